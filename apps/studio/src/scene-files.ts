import { builtInScenes, type LoadedScene, loadFiles, parseScene, type Scene } from 'mirrorball';

/** The page's one door to scene files. */

/** As much of a file as is read; `parseScene` says that a file of this size is too large. */
const MOST_BYTES = 64 * 2 ** 20;

export const sceneIds: readonly string[] = builtInScenes.map(({ id }) => id);

export function builtInScene(id: string | null): { id: string; scene: Scene } {
  const { id: found, scene } = builtInScenes.find((entry) => entry.id === id) ?? builtInScenes[0]!;
  return { id: found, scene };
}

/** As much of a picture or mesh as is read. */
const MOST_FILE_BYTES = 2 ** 30;

/** Of files that come together: the scene, and what it may name. */
export function sortFiles<Named extends { readonly name: string }>(files: readonly Named[]) {
  const scene = files.find(({ name }) => /\.json$/i.test(name)) ?? files[0];
  return { scene, others: files.filter((file) => file !== scene) };
}

/** A browser does not tell where files lie, so a file that the scene names is known by the last part of its path. */
export async function readSceneFile(file: File, others: readonly File[]): Promise<LoadedScene> {
  const parsed = parseScene(await file.slice(0, MOST_BYTES).text());
  if (!parsed.ok) return parsed;
  return loadFiles(parsed.scene, async (path) => {
    const name = path.split('/').at(-1)!;
    const found = others.find((other) => other.name === name);
    if (!found) throw new Error(`open ${name} together with the scene: choose or drop both files at once`);
    if (found.size > MOST_FILE_BYTES) throw new Error(`${name} is larger than 1 GiB`);
    return new Uint8Array(await found.arrayBuffer());
  });
}
