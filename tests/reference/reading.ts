/** Reads reference scenes and pictures from a folder like this one. */
import { readdirSync, readFileSync } from 'node:fs';
import { formatOf } from '../../packages/renderer/src/export/formats.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { environmentFromPicture } from '../../packages/renderer/src/scene-file/environment-from-picture.ts';
import { parseScene, withMap } from '../../packages/renderer/src/scene-file/parse-scene.ts';
import type { Reference } from './blocks.ts';
import { readNpy } from './npy.ts';

/** `folder`: with a slash at its end. */
export function namesIn(folder: URL): string[] {
  const entries = readdirSync(folder, { withFileTypes: true });
  return entries
    .filter((entry) => entry.isDirectory())
    .map((entry) => entry.name)
    .sort();
}

export function readScene(folder: URL, name: string): Scene {
  const file = (path: string) => readFileSync(new URL(`${name}/${path}`, folder));
  const parsed = parseScene(file('scene.json').toString('utf8'));
  if (!parsed.ok) throw new Error(`${name}: ${parsed.problems.map(({ message }) => message).join(' ')}`);
  const { image } = parsed.scene.sky;
  if (image === undefined) return parsed.scene;
  return withMap(parsed.scene, environmentFromPicture(formatOf(image).read(file(image))).map);
}

export function readPicture(folder: URL, name: string): Reference {
  const array = (file: string) => readNpy(readFileSync(new URL(`${name}/${file}.npy`, folder)));
  const [mean, error] = [array('mean'), array('error')];
  const [height, width, channels] = mean.shape;
  if (channels !== 3 || String(mean.shape) !== String(error.shape)) throw new Error(`${name}: odd shapes of arrays.`);
  return { width: width!, height: height!, mean: mean.data, error: error.data };
}
