import wasm from 'draco3dgltf/draco_decoder_gltf.wasm?url&inline';
import createDecoder from 'draco3dgltf/draco_decoder_gltf_nodejs.js';
import { readDataUri } from './base64.ts';

/** The program lies in this module, so that it is found wherever the module is. */
export function startDraco(): Promise<unknown> {
  const wasmBinary = bytesOf(wasm);
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

/** A data URI, or, as scripts/lazy-parts.mjs packs it, a letter for each byte. */
function bytesOf(text: string): Uint8Array {
  const program = text.startsWith('data:')
    ? readDataUri(text)
    : { bytes: Uint8Array.from(text, (letter) => letter.charCodeAt(0)) };
  if (typeof program === 'string') throw new Error(`The Draco decoder is damaged: ${program}.`);
  return program.bytes;
}
