import { builtInScenes, parseScene, type Scene } from 'mirrorball';

/** The page's one door to scene files. */

/** As much of a file as is read; `parseScene` says that a file of this size is too large. */
const MOST_BYTES = 64 * 2 ** 20;

export const sceneIds: readonly string[] = builtInScenes.map(({ id }) => id);

export function builtInScene(id: string | null): { id: string; scene: Scene } {
  const { id: found, scene } = builtInScenes.find((entry) => entry.id === id) ?? builtInScenes[0]!;
  return { id: found, scene };
}

export async function readSceneFile(file: File): Promise<ReturnType<typeof parseScene>> {
  return parseScene(await file.slice(0, MOST_BYTES).text());
}
