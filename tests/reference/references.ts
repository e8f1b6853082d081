/** The scenes and pictures of this folder, for tests and scripts in Node. */
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import type { Reference } from './blocks.ts';
import { namesIn, readPicture, readScene } from './reading.ts';

const folder = new URL('.', import.meta.url);

export const referenceNames: readonly string[] = namesIn(folder);
export const referenceScene = (name: string): Scene => readScene(folder, name);
export const referencePicture = (name: string): Reference => readPicture(folder, name);
