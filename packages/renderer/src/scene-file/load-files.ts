/** The second step of reading a scene: the files that it names. */
import { lacksMap } from '../scene/environment.ts';
import { lacksData } from '../scene/mesh.ts';
import type { Scene } from '../scene/scene.ts';
import { loadImage } from './load-image.ts';
import { loadMeshes } from './load-meshes.ts';
import { withMap, withMeshes } from './parse-scene.ts';
import { type Problem, ProblemList } from './problem.ts';
import type { ReadFile } from './read-file.ts';

export type LoadedScene =
  | {
      readonly ok: true;
      readonly scene: Scene;
      /** What was changed in the files' content, as sentences for people. */
      readonly notes: readonly string[];
    }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/**
 * The scene with the content of the files that it names, or everything that is wrong with them; itself when it names none or has it
 * already. Never rejects.
 */
export async function loadFiles(scene: Scene, readFile: ReadFile): Promise<LoadedScene> {
  const problems = new ProblemList();
  const notes: string[] = [];
  const { sky, meshes = {} } = scene;
  let loaded = scene;
  if (sky.image !== undefined && lacksMap(sky)) {
    const map = await loadImage(sky.image, readFile, problems, notes);
    if (map) loaded = withMap(loaded, map);
  }
  if (Object.values(meshes).some(lacksData))
    loaded = withMeshes(loaded, await loadMeshes(meshes, readFile, problems, notes));
  return problems.isEmpty ? { ok: true, scene: loaded, notes } : { ok: false, problems: problems.list() };
}
