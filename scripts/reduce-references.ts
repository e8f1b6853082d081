/**
 * For developers: writes tests/reference/ from a set of reference pictures.
 *
 *     npx tsx scripts/reduce-references.ts FOLDER [NAME …]
 *
 * FOLDER holds scenes/NAME.json and refs/NAME.npz (`mean` and `se`, linear RGB, row 0 on top) with refs/NAME.report.json.
 * Scenes that our format cannot say are passed over, with the reason. With names only these are written.
 */
import { copyFileSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, extname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { formatOf } from '../packages/renderer/src/export/formats.ts';
import type { Scene } from '../packages/renderer/src/scene/scene.ts';
import { environmentFromPicture } from '../packages/renderer/src/scene-file/environment-from-picture.ts';
import { writeScene } from '../packages/renderer/src/scene-file/index.ts';
import { readNpy, writeNpy } from '../tests/reference/npy.ts';
import { ConversionError, type Converted, convertScene } from './reference/convert-scene.ts';
import { readZip } from './reference/npz.ts';
import { type Reference, reduce } from './reference/reduce.ts';

const SIZE = 64;
/** The smallest half float: an error is never so small that it would be stored as none. */
const LEAST = 2 ** -24;
/** Folder of the meshes of all scenes. */
const MESHES = 'meshes';
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

/** Copies the map of the sky, if there is one: as EXR if that lies beside it with the same content, as it is packed. */
function withImageBeside(scene: Scene, from: string, folder: string): Scene {
  const { image } = scene.sky;
  if (image === undefined) return scene;
  const [given, packed] = [image, image.replace(/\.npy$/, '.exr')].map((name) => join(from, 'scenes', name)) as [string, string]; // biome-ignore format: short
  const file = existsSync(packed) && isSamePicture(given, packed) ? packed : given;
  const name = `sky${extname(file)}`;
  copyFileSync(file, join(folder, name));
  return { ...scene, sky: { ...scene.sky, image: name } };
}

function isSamePicture(a: string, b: string): boolean {
  const [one, other] = [a, b].map((file) => environmentFromPicture(formatOf(file).read(readFileSync(file))).map);
  return one!.width === other!.width && one!.data.every((x, k) => x === other!.data[k]);
}

/** Copies meshes to where all scenes find theirs. */
function withMeshesBeside(scene: Scene, from: string): Scene {
  if (!scene.meshes) return scene;
  mkdirSync(join(to, MESHES), { recursive: true });
  const copied = Object.entries(scene.meshes).map(([name, mesh]) => {
    const file = basename(mesh.file!);
    copyFileSync(join(from, 'scenes', mesh.file!), join(to, MESHES, file));
    return [name, { ...mesh, file: `../${MESHES}/${file}` }];
  });
  return { ...scene, meshes: Object.fromEntries(copied) };
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
  writeFileSync(
    join(folder, 'scene.json'),
    writeScene(withMeshesBeside(withImageBeside(converted.scene, from, folder), from), SCHEMA),
  );
  writeFileSync(join(folder, 'mean.npy'), writeNpy({ shape, data: small.mean }, 32));
  writeFileSync(join(folder, 'error.npy'), writeNpy({ shape, data: error }, 16));
  const { spp, mitsuba } = JSON.parse(read(`refs/${name}.report.json`));
  console.log(`| ${name} | ${converted.scene.description} | ${spp} | (Mitsuba ${mitsuba})`);
}

const [from, ...wanted] = process.argv.slice(2);
if (!from) {
  console.error('From which folder? npx tsx scripts/reduce-references.ts FOLDER');
  process.exit(2);
}
const names = readdirSync(join(from, 'scenes')).filter((file) => file.endsWith('.json'));
for (const file of names.sort()) {
  const name = file.slice(0, -'.json'.length);
  if (wanted.length === 0 || wanted.includes(name)) write(from, name);
}
