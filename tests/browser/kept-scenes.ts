import { writeFile } from 'node:fs/promises';
import type { SceneFiles } from '../fixtures/fuzz/fuzz.ts';

/** Writes a random scene, and beside it the map and the meshes that it names; gives the scene's path. */
export async function keepScene(
  name: string,
  { scene, map, meshes }: SceneFiles,
  pathOf: (name: string) => string,
): Promise<string> {
  const path = pathOf(`${name}.scene.json`);
  const own = scene.replace('"fuzz.npy"', `"${name}.npy"`).replace(/"(mesh\d+\.ply)"/g, `"${name}-$1"`);
  await writeFile(path, own);
  for (const [file, bytes] of Object.entries(meshes))
    await writeFile(pathOf(`${name}-${file}`), Uint8Array.from(bytes));
  if (map) await writeFile(pathOf(`${name}.npy`), Uint8Array.from(map));
  return path;
}
