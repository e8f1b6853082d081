/** glTF 2.0 and GLB in. The code behind it comes when the first file does. */
import { trustScene } from '../scene-file/trusted-scenes.ts';
import type { GltfImport, GltfOptions } from './types.ts';

export type { SceneCounts } from '../scene/counts.ts';
export type { ImageDecoder } from './images/decoder.ts';
export type { ImportReport, ReportEntry } from './report.ts';
export type { GltfImport, GltfOptions, GltfProgress } from './types.ts';

/**
 * Reads a .glb or .gltf file into a scene, with a report of all that was not taken as it stands, or tells everything that is wrong with
 * it. Memory is bounded before any is given. Rejects with the signal's reason when that is aborted, and never for what a file has.
 */
export async function importGltf(bytes: Uint8Array, options: GltfOptions = {}): Promise<GltfImport> {
  const { readGltf } = await import('./read-gltf.ts');
  const result = await readGltf(bytes, options);
  if (result.ok) trustScene(result.scene);
  return result;
}
