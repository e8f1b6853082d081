import { writeFile } from 'node:fs/promises';
import type { SceneFiles } from '../fixtures/fuzz/fuzz.ts';

/** Writes a random scene, and beside it the map that it names; gives the scene's path. */
export async function keepScene(
  name: string,
  { scene, map }: SceneFiles,
  pathOf: (name: string) => string,
): Promise<string> {
  const path = pathOf(`${name}.scene.json`);
  await writeFile(path, scene.replace('"fuzz.npy"', `"${name}.npy"`));
  if (map) await writeFile(pathOf(`${name}.npy`), Uint8Array.from(map));
  return path;
}
