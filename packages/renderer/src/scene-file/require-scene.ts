import type { Scene } from '../scene/scene.ts';
import { asInText, withContent } from './content.ts';
import { parseScene } from './parse-scene.ts';
import { isParsedScene } from './trusted-scenes.ts';
import { usableScene } from './usable-scene.ts';

/** So many problems stand in the message. */
const MOST_TOLD = 5;

/**
 * A scene that all later stages can rely on: the given one when `parseScene` made it, else what `parseScene` makes of it. Throws a
 * TypeError that says what is wrong when it is no scene: a programmer's error, as files go through `parseScene` first.
 */
export function requireScene(given: unknown): Scene {
  if (isParsedScene(given)) return usableScene(given);
  if (typeof given === 'string')
    throw new TypeError('A scene is wanted, not its text: give what parseScene(text) returns.');
  const parsed = parseScene(asInText(given));
  if (parsed.ok) return usableScene(withContent(parsed.scene, given as Scene));
  const told = parsed.problems.slice(0, MOST_TOLD).map(({ path, message }) => `${path || '(whole scene)'}: ${message}`);
  const more = parsed.problems.length - told.length;
  throw new TypeError(['This is no scene.', ...told, ...(more > 0 ? [`And ${more} more.`] : [])].join('\n'));
}
