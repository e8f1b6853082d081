import wasm from 'draco3dgltf/draco_decoder_gltf.wasm?url&inline';
import createDecoder from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { inlinedBytes } from './base64.ts';

/** The program lies in this module, so that it is found wherever the module is. */
export function startDraco(): Promise<unknown> {
  const wasmBinary = inlinedBytes(wasm);
  // Under Node it asks for its folder, though it reads nothing there; ES modules have no such name.
  const place = globalThis as { __dirname?: string };
  const isStrange = !('__dirname' in place);
  if (isStrange) place.__dirname = '';
  try {
    return createDecoder({ wasmBinary });
  } finally {
    if (isStrange) delete place.__dirname;
  }
}
