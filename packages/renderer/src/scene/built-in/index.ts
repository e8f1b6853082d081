/** The scenes that come with Mirrorball. Their files are read ahead, by `npm run scenes`: a page that shows one needs no reader at its start. */
import { adoptedScene } from '../../scene-file/trusted-scenes.ts';
import type { Scene } from '../scene.ts';
import cubeRoom from './generated/cube-room.json';
import materials from './generated/materials.json';
import mirrorBlocks from './generated/mirror-blocks.json';
import movingShadows from './generated/moving-shadows.json';

export interface BuiltInScene {
  /** Stays the same in every version and language, such as "cube-room". */
  readonly id: string;
  /** The scene's English name, at hand without reading the scene. */
  readonly name: string;
  /** Made at first use, then remembered. */
  readonly scene: Scene;
}

/** The scenes that come with Mirrorball, in the order of the menu. */
export const builtInScenes: readonly BuiltInScene[] = [
  builtIn('cube-room', cubeRoom),
  builtIn('mirror-blocks', mirrorBlocks),
  builtIn('moving-shadows', movingShadows),
  builtIn('materials', materials),
];

function builtIn(id: string, read: { readonly name: string }): BuiltInScene {
  let scene: Scene | null = null;
  return {
    id,
    name: read.name,
    get scene() {
      scene ??= adoptedScene(read as unknown as Scene);
      return scene;
    },
  };
}
