import { builtInScenes, type Scene } from 'mirrorball';

/** The scenes that come with the page. */

export const sceneIds: readonly string[] = builtInScenes.map(({ id }) => id);

export function builtInScene(id: string | null): { id: string; scene: Scene } {
  const { id: found, scene } = builtInScenes.find((entry) => entry.id === id) ?? builtInScenes[0]!;
  return { id: found, scene };
}
