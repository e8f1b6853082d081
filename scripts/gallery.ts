/**
 * Pictures of models by the command line, and a page with all of them and whom they are owed to: docs/gallery.
 *
 *     npm run gallery [-- FOLDER …] [--only NAME] [--spp N]
 *
 * The models of tests/fixtures/models, and those of the folders, whose CREDITS.md says where each is from and under which licence; a
 * model without such a line is left out, as nobody knows whether its picture may be shown. Pictures that are there are kept.
 */
import { spawn } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { buildCliIfStale } from './build-cli.mjs';

const root = fileURLToPath(new URL('..', import.meta.url));
const folder = join(root, 'docs/gallery');
const MODEL = /\.(glb|gltf|ply|obj|stl)$/i;
const SIZE = '400x300';

interface Credit {
  readonly names: readonly string[];
  readonly from: string;
  readonly licence: string;
}
interface Model {
  readonly file: string;
  readonly name: string;
  readonly credit: Credit;
}
/** A picture with what is under it; kept beside the pictures, so that one can be made anew alone. */
interface Entry {
  readonly name: string;
  readonly from: string;
  readonly licence: string;
  readonly picture: string;
  readonly triangles: number;
}

/** The rows of a table of models, where they are from, and licences. */
function creditsOf(models: string): Credit[] {
  const file = join(models, 'CREDITS.md');
  if (!existsSync(file)) return [];
  const cells = readFileSync(file, 'utf8').split('\n').map((line) => line.split('|').map((cell) => cell.trim())); // biome-ignore format: short
  const rows = cells.filter((row) => row.length >= 5 && !/^-*$|^model$/i.test(row[1]!));
  return rows.map(([, names, from, licence]) => ({ names: names!.replaceAll('`', '').split(/,\s*/), from: from!, licence: licence! })); // biome-ignore format: one row
}

/** Whether one of the row's names is the model's path, its name, the folder that it lies in, or a pattern with one "*" at its end. */
function isCredited(path: string, { names }: Credit): boolean {
  const bare = path.replace(MODEL, '');
  return names.some((name) => {
    const wanted = name.replace(/\*$/, '').replace(MODEL, '');
    return bare === wanted || path.startsWith(name.endsWith('*') ? wanted : `${wanted}/`);
  });
}

function modelsIn(models: string): Model[] {
  const credits = creditsOf(models);
  const files = readdirSync(models, { recursive: true, encoding: 'utf8' }).filter((file) => MODEL.test(file));
  return files.sort().flatMap((file) => {
    const path = file.replaceAll('\\', '/');
    const credit = credits.find((one) => isCredited(path, one));
    if (credit) return [{ file: join(models, file), name: basename(path).replace(MODEL, ''), credit }];
    console.log(`${path}: no line in CREDITS.md says whose it is, so that it is left out.`);
    return [];
  });
}

/** What the command line says, an object a line; null when it fails, after its words have been passed on. */
function mirrorball(...words: string[]): Promise<Record<string, unknown>[] | null> {
  const child = spawn(process.execPath, [join(root, 'packages/cli/dist/mirrorball.mjs'), ...words, '--json'], {
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  let text = '';
  child.stdout.on('data', (piece) => (text += piece));
  return new Promise((resolve) =>
    child.on('close', (code) => {
      const lines = text.split('\n').filter((line) => line.startsWith('{'));
      resolve(code === 0 ? lines.map((line) => JSON.parse(line) as Record<string, unknown>) : null);
    }),
  );
}

/** Null when it cannot be drawn. */
async function render({ file, name, credit }: Model, spp: string): Promise<Entry | null> {
  const picture = `${name}.png`;
  const info = await mirrorball('info', file);
  const triangles = Number(info?.[0]?.triangles ?? 0);
  const done = info && (await mirrorball('render', file, '-o', join(folder, picture), '--size', SIZE, '--spp', spp));
  if (!done) return null;
  return { name, from: credit.from, licence: credit.licence, picture, triangles };
}

function page(entries: readonly Entry[]): string {
  const sections = entries.map(
    ({ name, from, licence, picture, triangles }) =>
      `## ${name}\n\n![${name}, path traced](${picture})\n\n${triangles.toLocaleString('en')} triangles. From: ${from}. Licence: ${licence}.\n`,
  );
  return `# Gallery\n\n\`npm run gallery\` made these pictures by the command line (\`mirrorball render model.glb\`): each model in its own light, or in the\nstudio where its file has none, seen by its own camera, or framed. The models are their makers'; so are their licences.\n\n${sections.join('\n')}`;
}

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { only: { type: 'string' }, spp: { type: 'string', default: '256' } },
});
if ((await buildCliIfStale()) !== 0) process.exit(1);
mkdirSync(folder, { recursive: true });
const list = join(folder, 'gallery.json');
const before: Entry[] = existsSync(list) ? JSON.parse(readFileSync(list, 'utf8')) : [];
const entries = new Map(before.map((entry) => [entry.name, entry]));
const models = [join(root, 'tests/fixtures/models'), ...positionals].flatMap(modelsIn);
let failed = 0;
for (const model of models) {
  if (values.only ? model.name !== values.only : entries.has(model.name)) continue;
  console.log(relative(root, model.file));
  const entry = await render(model, values.spp);
  if (entry) entries.set(entry.name, entry);
  else failed++;
}
const sorted = [...entries.values()].sort((a, b) => a.name.localeCompare(b.name));
writeFileSync(list, `${JSON.stringify(sorted, null, 2)}\n`);
writeFileSync(join(folder, 'README.md'), page(sorted));
console.log(`${sorted.length} models in docs/gallery/README.md${failed > 0 ? `, ${failed} could not be drawn` : ''}.`);
process.exit(failed > 0 ? 1 : 0);
