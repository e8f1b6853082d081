import { builtInScenes, type Scene } from 'mirrorball';
import { baselineRoom } from '../../fixtures/baseline-room.ts';

/** A built-in scene by its id, or the course project's room. */
export function sceneNamed(name: string): Scene {
  if (name === 'baseline-room') return baselineRoom;
  const found = builtInScenes.find(({ id }) => id === name);
  if (!found) throw new Error(`There is no scene "${name}".`);
  return found.scene;
}
