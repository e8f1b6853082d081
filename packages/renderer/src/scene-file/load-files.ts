/** The second step of reading a scene: the files that it names. */
import type { ImageDecoder } from '../gltf/images/decoder.ts';
import { lacksMap } from '../scene/environment.ts';
import { lacksData } from '../scene/mesh.ts';
import { lacksModel } from '../scene/models.ts';
import type { Scene } from '../scene/scene.ts';
import { lacksPixels } from '../scene/textures.ts';
import { checkPlaying } from './check-clips.ts';
import { FaultyPlaces } from './faulty-places.ts';
import { loadImage } from './load-image.ts';
import { loadMeshes } from './load-meshes.ts';
import { type Problem, ProblemList } from './problem.ts';
import type { ReadFile } from './read-file.ts';
import { isParsedScene, withMap, withMeshes, withThings } from './trusted-scenes.ts';

export type LoadedScene =
  | {
      readonly ok: true;
      readonly scene: Scene;
      /** What was changed in the files' content, as sentences for people. */
      readonly notes: readonly string[];
    }
  | { readonly ok: false; readonly problems: readonly Problem[] };

export interface LoadOptions {
  /** Makes pixels of images. Default: what a browser offers; elsewhere PNG alone. */
  readonly decoder?: ImageDecoder;
}

/**
 * The scene with the content of the files that it names, or everything that is wrong with them; itself when it names none or has it
 * already. Never rejects.
 */
export async function loadFiles(scene: Scene, readFile: ReadFile, options: LoadOptions = {}): Promise<LoadedScene> {
  const problems = new ProblemList();
  const notes: string[] = [];
  const { sky, meshes = {}, images = {}, models = {} } = scene;
  let loaded = scene;
  if (sky.image !== undefined && lacksMap(sky)) {
    const map = await loadImage(sky.image, readFile, problems, notes);
    if (map) loaded = withMap(loaded, map);
  }
  if (Object.values(meshes).some(lacksData))
    loaded = withMeshes(loaded, await loadMeshes(meshes, readFile, problems, notes));
  if (Object.values(images).some(lacksPixels)) {
    const { loadImages } = await import('./load-images.ts');
    loaded = withThings(loaded, { images: await loadImages(images, readFile, problems, notes, options.decoder) });
  }
  if (Object.values(models).some(lacksModel)) {
    const { loadModels } = await import('./load-models.ts');
    const whole = await loadModels(loaded, readFile, problems, notes, options);
    checkPlaying(whole, new FaultyPlaces(), problems, true);
    loaded = withThings(whole, {}, isParsedScene(loaded));
  }
  return problems.isEmpty ? { ok: true, scene: loaded, notes } : { ok: false, problems: problems.list() };
}
