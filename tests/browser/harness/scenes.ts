import { builtInScenes, type Projection, type Scene } from 'mirrorball';
import { baselineRoom } from '../../fixtures/baseline-room.ts';

/** A built-in scene by its id, or the course project's room; with a projection after it, seen by such a camera. */
export function sceneNamed(name: string): Scene {
  const [id = '', projection] = name.split(' ');
  const scene = plainScene(id);
  if (projection === undefined) return scene;
  // High enough that its rays start outside of rooms and below floors too.
  return { ...scene, camera: { ...scene.camera, projection: projection as Projection, viewHeight: 8 } };
}

function plainScene(name: string): Scene {
  if (name === 'baseline-room') return baselineRoom;
  const found = builtInScenes.find(({ id }) => id === name);
  if (!found) throw new Error(`There is no scene "${name}".`);
  return found.scene;
}
