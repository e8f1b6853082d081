/** The scenes and pictures of this folder, for tests and scripts in Node. */
import { readdirSync, readFileSync } from 'node:fs';
import { formatOf } from '../../packages/renderer/src/export/formats.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { environmentFromPicture } from '../../packages/renderer/src/scene-file/environment-from-picture.ts';
import { parseScene, withMap } from '../../packages/renderer/src/scene-file/parse-scene.ts';
import type { Reference } from './blocks.ts';
import { readNpy } from './npy.ts';

const file = (path: string) => new URL(path, import.meta.url);

export const referenceNames: readonly string[] = readdirSync(file('.'), { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map((entry) => entry.name)
  .sort();

export function referenceScene(name: string): Scene {
  const parsed = parseScene(readFileSync(file(`${name}/scene.json`), 'utf8'));
  if (!parsed.ok) throw new Error(`${name}: ${parsed.problems.map(({ message }) => message).join(' ')}`);
  const { image } = parsed.scene.sky;
  if (image === undefined) return parsed.scene;
  const bytes = readFileSync(file(`${name}/${image}`));
  return withMap(parsed.scene, environmentFromPicture(formatOf(image).read(bytes)).map);
}

export function referencePicture(name: string): Reference {
  const [mean, error] = [
    readNpy(readFileSync(file(`${name}/mean.npy`))),
    readNpy(readFileSync(file(`${name}/error.npy`))),
  ];
  const [height, width, channels] = mean.shape;
  if (channels !== 3 || String(mean.shape) !== String(error.shape)) throw new Error(`${name}: odd shapes of arrays.`);
  return { width: width!, height: height!, mean: mean.data, error: error.data };
}
