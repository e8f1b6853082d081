import { type EnvironmentMap, environmentFault, lacksMap } from '../scene/environment.ts';
import type { Scene, Sky } from '../scene/scene.ts';
import { isParsedScene, parseScene, withMap } from './parse-scene.ts';

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
  const { rest, map, unnamed } = withoutMap(given);
  const parsed = parseScene(rest);
  if (parsed.ok) return loaded(map === undefined ? parsed.scene : attached(parsed.scene, map, unnamed));
  const told = parsed.problems.slice(0, MOST_TOLD).map(({ path, message }) => `${path || '(whole scene)'}: ${message}`);
  const more = parsed.problems.length - told.length;
  throw new TypeError(['This is no scene.', ...told, ...(more > 0 ? [`And ${more} more.`] : [])].join('\n'));
}

function loaded(scene: Scene): Scene {
  if (!lacksMap(scene.sky)) return scene;
  throw new TypeError(
    `The sky's image "${scene.sky.image}" has not been loaded: give what loadImages(scene, readFile) returns.`,
  );
}

/** Any name will do while the form of the scene is checked. */
const NO_FILE = 'memory.hdr';

/** What `parseScene` reads, and the sky's map, which it does not; with a name for a map that has no file. */
function withoutMap(given: unknown): { rest: unknown; map?: unknown; unnamed?: boolean } {
  const sky = (given as Partial<Scene> | null | undefined)?.sky;
  if (sky?.map === undefined) return { rest: given };
  const { map, image, ...others } = sky as Sky;
  return {
    rest: { ...(given as Scene), sky: { ...others, image: image ?? NO_FILE } },
    map,
    unnamed: image === undefined,
  };
}

function attached(scene: Scene, map: unknown, unnamed?: boolean): Scene {
  const fault = typeof map === 'object' && map !== null ? environmentFault(map as EnvironmentMap) : 'no content';
  if (fault !== null) throw new TypeError(`This is no scene.\n/sky/map: the map has ${fault}.`);
  const { image, ...others } = scene.sky;
  const named = { ...scene, sky: unnamed ? others : { ...others, image } };
  return withMap(named, map as EnvironmentMap, true);
}
