/**
 * The programs that scenes are drawn with, as text: `npx tsx scripts/program-texts.ts FOLDER FILE …` writes into the folder, for each scene
 * file or model, WGSL with the entries of paths, with its switches set and without what they leave out. So one can see what a scene
 * makes a driver compile, and give it to a compiler such as Windows' FXC. Textures and meshes beside a file are not looked for: name the
 * .glb, or a scene without any.
 */
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { pathFeatures } from '../packages/renderer/src/integrator/path/path-features.ts';
import { openModel } from '../packages/renderer/src/open/index.ts';
import { drawsModels, FEATURES, type Feature } from '../packages/renderer/src/shading/features.ts';
import { DEFAULT_SETTINGS } from '../packages/renderer/src/view.ts';
import { withoutFeatures } from './without-features.ts';

const GENERATED = fileURLToPath(new URL('../packages/renderer/src/shading/generated/', import.meta.url));

/** The text that a page takes for these needs, with nothing else left in it. */
function textFor(needs: ReadonlySet<Feature>): string {
  const whole = readFileSync(join(GENERATED, drawsModels(needs) ? 'path_models.wgsl' : 'path.wgsl'), 'utf8');
  const off = FEATURES.filter((feature) => !needs.has(feature));
  return withoutFeatures(whole, off).replace(/^override (\w+) = (true|false);/gm, 'const $1 = true;');
}

const [folder, ...files] = process.argv.slice(2);
if (folder === undefined || files.length === 0) {
  console.error('Usage: npx tsx scripts/program-texts.ts FOLDER FILE …');
  process.exit(2);
}
mkdirSync(folder, { recursive: true });
for (const file of files) {
  const opened = await openModel(new Uint8Array(readFileSync(file)), basename(file), {});
  if (!opened.ok) {
    console.error(`${file}: ${JSON.stringify(opened.problems)}`);
    process.exitCode = 1;
    continue;
  }
  const { scene } = opened;
  const needs = pathFeatures({ scene, camera: scene.camera, settings: DEFAULT_SETTINGS });
  const out = join(folder, `${basename(file)}.wgsl`);
  writeFileSync(out, textFor(needs));
  console.log(`${out}: ${[...needs].join(' ')}`);
}
