/**
 * The programs that scenes are drawn with, as text: `npx tsx scripts/program-texts.ts FOLDER FILE …` writes into the folder, for each scene
 * file or model, WGSL with the entries of paths, with its switches set and without what they leave out: as one program, and as one of several
 * passes (….relay.wgsl). So one can see what a scene makes a driver compile, and give it to a compiler such as Windows' FXC. Textures and meshes beside a file are not looked for: name the
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

const renderer = fileURLToPath(new URL('../packages/renderer/src/', import.meta.url));
const GENERATED = join(renderer, 'shading/generated');
const RELAY = join(renderer, 'integrator/path/generated/path_relay.wgsl');

/** That text for these needs, with nothing else left in it. */
function textFor(file: string, needs: ReadonlySet<Feature>): string {
  const whole = readFileSync(file, 'utf8');
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
  const texts = {
    '': join(GENERATED, drawsModels(needs) ? 'path_models.wgsl' : 'path.wgsl'),
    '.relay': RELAY,
  };
  for (const [suffix, text] of Object.entries(texts)) {
    const out = join(folder, `${basename(file)}${suffix}.wgsl`);
    writeFileSync(out, textFor(text, needs));
    console.log(`${out}: ${[...needs].join(' ')}`);
  }
}
