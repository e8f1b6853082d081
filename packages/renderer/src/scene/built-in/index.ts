import { parseScene } from '../../scene-file/parse-scene.ts';
import type { Scene } from '../scene.ts';
import cubeRoom from './cube-room.scene.json';
import materials from './materials.scene.json';
import mirrorBlocks from './mirror-blocks.scene.json';
import movingShadows from './moving-shadows.scene.json';

export interface BuiltInScene {
  /** Stays the same in every version and language, such as "cube-room". */
  readonly id: string;
  /** The scene's English name, at hand without reading the scene. */
  readonly name: string;
  /** Read at first use, then remembered. */
  readonly scene: Scene;
}

/** The scenes that come with Mirrorball, in the order of the menu. */
export const builtInScenes: readonly BuiltInScene[] = [
  builtIn('cube-room', cubeRoom),
  builtIn('mirror-blocks', mirrorBlocks),
  builtIn('moving-shadows', movingShadows),
  builtIn('materials', materials),
];

function builtIn(id: string, file: { readonly name: string }): BuiltInScene {
  let scene: Scene | null = null;
  return {
    id,
    name: file.name,
    get scene() {
      scene ??= read(id, file);
      return scene;
    },
  };
}

function read(id: string, file: unknown): Scene {
  const parsed = parseScene(file);
  if (parsed.ok) return parsed.scene;
  throw new Error(`The built-in scene "${id}" is broken: ${parsed.problems[0]?.message}`);
}
