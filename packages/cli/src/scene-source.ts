/** Scenes from files, or built-in ones by name, with everything that is wrong with them. */
import { readFile } from 'node:fs/promises';
import { builtInScenes } from 'mirrorball/built-in';
import type { Scene } from 'mirrorball/scene';
import { parseScene } from 'mirrorball/scene-file';
import { type BadScene, BadSceneError, usage } from './exit-codes.ts';

export type SceneSource = { readonly file: string; readonly scene: Scene } | BadScene;

/** Rejects only when the file cannot be read at all. A file goes before a built-in scene of its name. */
export async function readScene(file: string): Promise<SceneSource> {
  let text: string;
  try {
    text = await readFile(file, 'utf8');
  } catch (error) {
    const builtIn = builtInScenes.find(({ id }) => id === file);
    if (builtIn) return { file, scene: builtIn.scene };
    throw usage(`The scene ${file} cannot be read: ${(error as Error).message}`);
  }
  const parsed = parseScene(text);
  return parsed.ok ? { file, scene: parsed.scene } : { file, problems: parsed.problems };
}

export async function requireSceneFile(file: string): Promise<Scene> {
  const source = await readScene(file);
  if ('problems' in source) throw new BadSceneError([source]);
  return source.scene;
}
