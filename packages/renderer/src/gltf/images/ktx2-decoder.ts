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

/** More pixels a byte than any picture has: what claims more is damaged, and nothing of its size is made. */
const MOST_PIXELS_A_BYTE = 4096;

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

/**
 * What the file claims before the transcoder sees it, whose memory never shrinks: one image without depth, layers or faces
 * (KHR_texture_basisu), levels that lie in the file, and no more content than blocks have (KTX 2.0, 3 and 4).
 */
function isSound(bytes: Uint8Array): boolean {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < LEVELS_AT) return false;
  const field = (at: number): number => view.getUint32(at, true);
  const [width, height, depth, layers, faces, levels] = [20, 24, 28, 32, 36, 40].map(field) as [number, number, number, number, number, number]; // biome-ignore format: fields in a row
  const side = Math.max(width, height);
  if (depth > 0 || layers > 1 || faces !== 1 || levels < 1 || levels > Math.log2(side) + 1) return false;
  if (width * height > bytes.length * MOST_PIXELS_A_BYTE || bytes.length < LEVELS_AT + 24 * levels) return false;
  for (let level = 0; level < levels; level++) {
    const [offset, length, unpacked] = [0, 8, 16].map((at) => Number(view.getBigUint64(LEVELS_AT + 24 * level + at, true))) as [number, number, number]; // biome-ignore format: fields in a row
    const blocks = Math.ceil((width >> level || 1) / 4) * Math.ceil((height >> level || 1) / 4);
    if (offset + length > bytes.length || unpacked > blocks * 16) return false;
  }
  const [shared, sharedLength] = [56 + 8, 56 + 16].map((at) => Number(view.getBigUint64(at, true))) as [number, number];
  return shared + sharedLength <= bytes.length;
}
/** The head's length, behind which the table of levels lies. */
const LEVELS_AT = 80;

/** The largest level of the first image. Its size should be looked at first (image-head.ts). */
export async function decodeKtx2(bytes: Uint8Array): Promise<ImagePixels> {
  if (!isSound(bytes)) throw new Error('it is no KTX2 file with a Basis Universal image, or damaged');
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
