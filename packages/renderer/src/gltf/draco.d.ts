declare module 'draco3dgltf/draco_decoder_gltf_nodejs.js' {
  /** Emscripten's start of a program. */
  export default function createDecoder(options: { wasmBinary: Uint8Array }): Promise<unknown>;
}
