/** Decompressors, loaded when a file needs them and then kept. */
import type { MeshoptDecoder } from 'meshoptimizer/decoder';

let draco: Promise<unknown> | undefined;

/** Google's Draco for glTF, as WebAssembly. */
export function loadDraco(): Promise<unknown> {
  draco ??= import('./draco-decoder.ts').then(({ startDraco }) => startDraco());
  return draco;
}

export async function loadMeshopt(): Promise<typeof MeshoptDecoder> {
  const { MeshoptDecoder: decoder } = await import('meshoptimizer/decoder');
  await decoder.ready;
  return decoder;
}
