import wasm from 'draco3dgltf/draco_decoder_gltf.wasm?url&inline';
import createDecoder from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { readDataUri } from './base64.ts';

/** The program lies in this module as a data URI, so that it is found wherever the module is. */
export function startDraco(): Promise<unknown> {
  const program = readDataUri(wasm);
  if (typeof program === 'string') throw new Error(`The Draco decoder is damaged: ${program}.`);
  return createDecoder({ wasmBinary: program.bytes });
}
