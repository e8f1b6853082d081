/** Reads the built-in scenes' files and writes what the reader makes of them, so that pages need not. Run by `npm run scenes`. */
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { parseScene } from '../packages/renderer/src/scene-file/parse-scene.ts';

const folder = new URL('../packages/renderer/src/scene/built-in/', import.meta.url);
const ENDING = '.scene.json';

mkdirSync(new URL('generated/', folder), { recursive: true });
for (const name of readdirSync(folder).filter((file) => file.endsWith(ENDING))) {
  const read = parseScene(readFileSync(new URL(name, folder), 'utf8'));
  if (!read.ok) throw new Error(`${name} is broken: ${read.problems[0]?.path} ${read.problems[0]?.message}`);
  const written = `generated/${name.slice(0, -ENDING.length)}.json`;
  writeFileSync(new URL(written, folder), `${JSON.stringify(read.scene, null, 1)}\n`);
  console.log(`Wrote packages/renderer/src/scene/built-in/${written}.`);
}
