/**
 * KTX2 with Basis Universal (KHR_texture_basisu), by Binomial's transcoder as three.js carries it. Compressed blocks are unfolded to plain
 * pixels, as kernels read them. Half a megabyte of WebAssembly: loaded when a file needs it, by who has it.
 */
import script from 'three/examples/jsm/libs/basis/basis_transcoder.js?raw';
import wasm from 'three/examples/jsm/libs/basis/basis_transcoder.wasm?url&inline';
import type { ImagePixels } from '../../scene/textures.ts';
import { inlinedBytes } from '../base64.ts';

/** As much of the transcoder's module as is used. */
interface Basis {
  initializeBasis(): void;
  readonly KTX2File: new (bytes: Uint8Array) => BasisFile;
}
interface BasisFile {
  isValid(): boolean;
  getWidth(): number;
  getHeight(): number;
  startTranscoding(): boolean;
  getImageTranscodedSizeInBytes(level: number, layer: number, face: number, format: number): number;
  transcodeImage(out: Uint8Array, level: number, layer: number, face: number, format: number, unused: number, row: number, column: number): boolean | number; // biome-ignore format: as the library has it
  close(): void;
  delete(): void;
}

/** basist::transcoder_texture_format::cTFRGBA32. */
const RGBA32 = 13;

let basis: Promise<Basis> | undefined;

async function start(): Promise<Basis> {
  // A script of the old kind, which leaves a variable; it takes Node for a place to read files, so it sees no `process`.
  const make = new Function('process', `${script}\nreturn BASIS;`)(undefined) as (options: object) => Promise<Basis>;
  const module = await make({ wasmBinary: inlinedBytes(wasm) });
  module.initializeBasis();
  return module;
}

/** The largest level of the first image. Its size should be looked at first (image-head.ts). */
export async function decodeKtx2(bytes: Uint8Array): Promise<ImagePixels> {
  basis ??= start();
  const { KTX2File } = await basis;
  const file = new KTX2File(bytes);
  try {
    if (!file.isValid()) throw new Error('it is no KTX2 file with a Basis Universal image');
    const [width, height] = [file.getWidth(), file.getHeight()];
    if (!file.startTranscoding()) throw new Error('its content is damaged');
    const rgba = new Uint8Array(width * height * 4);
    if (
      file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32) !== rgba.length ||
      !file.transcodeImage(rgba, 0, 0, 0, RGBA32, 0, -1, -1)
    )
      throw new Error('its content is damaged');
    return { width, height, rgba };
  } finally {
    file.close();
    file.delete();
  }
}
