/** What renderers can show: a scene that has been looked through, with the content of all files that it names. */
import { lacksMap } from '../scene/environment.ts';
import { lacksData } from '../scene/mesh.ts';
import { lacksModel } from '../scene/models.ts';
import type { Scene } from '../scene/scene.ts';
import { lacksPixels } from '../scene/textures.ts';
import { isParsedScene } from './trusted-scenes.ts';

/** The given scene. Throws a TypeError when nobody has looked through it, and when content is missing. */
export function usableScene(scene: Scene): Scene {
  if (!isParsedScene(scene)) throw new TypeError('A scene is wanted that parseScene or importGltf has made.');
  const advice = 'has not been loaded: give what loadFiles(scene, readFile) returns.';
  if (lacksMap(scene.sky)) throw new TypeError(`The sky's image "${scene.sky.image}" ${advice}`);
  for (const [name, mesh] of Object.entries(scene.meshes ?? {}))
    if (lacksData(mesh)) throw new TypeError(`The mesh "${name}" of "${mesh.file}" ${advice}`);
  for (const [name, image] of Object.entries(scene.images ?? {}))
    if (lacksPixels(image)) throw new TypeError(`The image "${name}" of "${image.file}" ${advice}`);
  for (const [name, model] of Object.entries(scene.models ?? {}))
    if (lacksModel(model)) throw new TypeError(`The model "${name}" of "${model.file}" ${advice}`);
  return scene;
}

/**
 * What a program has given, as `requireScene` makes it usable. One that was looked through is there at once; reading another takes code that
 * comes only then.
 */
export const readyScene = (given: Scene): Scene | Promise<Scene> =>
  isParsedScene(given)
    ? usableScene(given)
    : import('./require-scene.ts').then(({ requireScene }) => requireScene(given));
