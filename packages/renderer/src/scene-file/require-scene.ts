import { lacksMap } from '../scene/environment.ts';
import { lacksData } from '../scene/mesh.ts';
import { lacksModel } from '../scene/models.ts';
import type { Scene } from '../scene/scene.ts';
import { lacksPixels } from '../scene/textures.ts';
import { asInText, withContent } from './content.ts';
import { isParsedScene, parseScene } from './parse-scene.ts';

/** So many problems stand in the message. */
const MOST_TOLD = 5;

/**
 * A scene that all later stages can rely on: the given one when `parseScene` made it, else what `parseScene` makes of it. Throws a
 * TypeError that says what is wrong when it is no scene: a programmer's error, as files go through `parseScene` first.
 */
export function requireScene(given: unknown): Scene {
  if (isParsedScene(given)) return loaded(given);
  if (typeof given === 'string')
    throw new TypeError('A scene is wanted, not its text: give what parseScene(text) returns.');
  const parsed = parseScene(asInText(given));
  if (parsed.ok) return loaded(withContent(parsed.scene, given as Scene));
  const told = parsed.problems.slice(0, MOST_TOLD).map(({ path, message }) => `${path || '(whole scene)'}: ${message}`);
  const more = parsed.problems.length - told.length;
  throw new TypeError(['This is no scene.', ...told, ...(more > 0 ? [`And ${more} more.`] : [])].join('\n'));
}

function loaded(scene: Scene): Scene {
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
