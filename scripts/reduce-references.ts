/**
 * For developers: writes tests/reference/ from a set of reference pictures.
 *
 *     npx tsx scripts/reduce-references.ts FOLDER
 *
 * FOLDER holds scenes/NAME.json and refs/NAME.npz (`mean` and `se`, linear RGB, row 0 on top) with refs/NAME.report.json.
 * Scenes that our format cannot say are passed over, with the reason.
 */
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Scene } from '../packages/renderer/src/scene/scene.ts';
import { writeScene } from '../packages/renderer/src/scene-file/index.ts';
import { readNpy, writeNpy } from '../tests/reference/npy.ts';
import { ConversionError, type Converted, convertScene } from './reference/convert-scene.ts';
import { readZip } from './reference/npz.ts';
import { type Reference, reduce } from './reference/reduce.ts';

const SIZE = 64;
/** The smallest half float: an error is never so small that it would be stored as none. */
const LEAST = 2 ** -24;
const SCHEMA = '../../../packages/renderer/scene.schema.json';
const to = fileURLToPath(new URL('../tests/reference/', import.meta.url));

function readReference(path: string): Reference {
  const members = readZip(readFileSync(path));
  const [mean, error] = ['mean.npy', 'se.npy'].map((name) => readNpy(members.get(name)!)) as [
    ReturnType<typeof readNpy>,
    ReturnType<typeof readNpy>,
  ];
  const [height, width] = mean.shape as [number, number];
  return { width, height, mean: mean.data, error: error.data };
}

function convertOrTell(name: string, json: unknown): Converted | null {
  try {
    return convertScene(json);
  } catch (error) {
    if (!(error instanceof ConversionError)) throw error;
    console.log(`${name}: left out. ${error.problems.join(' ')}`);
    return null;
  }
}

/** Copies the map of the sky, if there is one. */
function withImageBeside(scene: Scene, from: string, folder: string): Scene {
  const { image } = scene.sky;
  if (image === undefined) return scene;
  const name = `sky${extname(image)}`;
  copyFileSync(join(from, 'scenes', image), join(folder, name));
  return { ...scene, sky: { ...scene.sky, image: name } };
}

function write(from: string, name: string): void {
  const read = (path: string) => readFileSync(join(from, path), 'utf8');
  const converted = convertOrTell(name, JSON.parse(read(`scenes/${name}.json`)));
  if (!converted) return;
  const reference = readReference(join(from, `refs/${name}.npz`));
  if (reference.width !== converted.width || reference.height !== converted.height)
    throw new Error(`${name}: the picture has another size than its scene says.`);
  const small = reduce(reference, reference.width / SIZE);
  const shape = [small.height, small.width, 3];
  const error = Array.from(small.error, (e) => (e > 0 ? Math.max(e, LEAST) : 0));
  const folder = join(to, name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'scene.json'), writeScene(withImageBeside(converted.scene, from, folder), SCHEMA));
  writeFileSync(join(folder, 'mean.npy'), writeNpy({ shape, data: small.mean }, 32));
  writeFileSync(join(folder, 'error.npy'), writeNpy({ shape, data: error }, 16));
  const { spp, mitsuba } = JSON.parse(read(`refs/${name}.report.json`));
  console.log(`| ${name} | ${converted.scene.description} | ${spp} | (Mitsuba ${mitsuba})`);
}

const from = process.argv[2];
if (!from) {
  console.error('From which folder? npx tsx scripts/reduce-references.ts FOLDER');
  process.exit(2);
}
const names = readdirSync(join(from, 'scenes')).filter((file) => file.endsWith('.json'));
for (const file of names.sort()) write(from, file.slice(0, -'.json'.length));
