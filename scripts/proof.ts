/**
 * Writes docs/proof: the path integrator beside the references of tests/reference. `npm run proof` does all scenes,
 * `npm run proof -- C1 S1` only these, and keeps the numbers of the others. `--backend webgpu` takes the other backend. The
 * same sources give the same files: fixed seeds, and SwiftShader's arithmetic.
 */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium, type Page } from '@playwright/test';
import { pathFilm, pathFilms } from '../tests/browser/films.ts';
import { serveHarness } from '../tests/browser/serve-harness.ts';
import { type Film, meansOf, mergeFilms, type Reference } from '../tests/reference/blocks.ts';
import { pictureOfMeans, pictureOfZ } from '../tests/reference/pictures.ts';
import { referenceNames, referencePicture, referenceScene } from '../tests/reference/references.ts';
import { BATCHES, CUT, SAMPLES, SEED } from '../tests/reference/samples.ts';
import { judge } from '../tests/reference/statistics.ts';
import { chromiumFlags } from './chromium.mjs';
import { ensureChromium } from './install-chromium.mjs';
import { encodePng, type Picture } from './png.ts';
import { type Convergence, noiseFloor, relativeError } from './proof/convergence.ts';
import { proofPage, type SceneProof } from './proof/page.ts';

const folder = fileURLToPath(new URL('../docs/proof', import.meta.url));
const resultsFile = join(folder, 'results.json');

type Backend = 'webgpu' | 'webgl2';
/** Samples of the longest film of the charts, a power of two. */
const CHART_SAMPLES = 256;
/** Not one of the batches'. */
const CHART_SEED = 1000;

async function prove(page: Page, backend: Backend, name: string): Promise<SceneProof> {
  const [scene, reference] = [referenceScene(name), referencePicture(name)];
  const { width, height } = reference;
  const settings = { width, height, samples: SAMPLES[name]!, batches: BATCHES, seed: SEED };
  const films = await pathFilms(page, backend, scene, settings);
  const result = judge(films, reference, CUT);
  const { exposure } = scene.render;
  writePicture(`${name}-ours`, pictureOfMeans(meansOf(mergeFilms(films)), width, exposure));
  writePicture(`${name}-reference`, pictureOfMeans(reference.mean, width, exposure));
  writePicture(`${name}-z`, pictureOfZ(result, width, height));
  const { rms, shareBeyond3, largest, blockError, picture, failures } = result;
  return {
    name,
    description: scene.description,
    backend,
    batches: BATCHES,
    samples: BATCHES * SAMPLES[name]!,
    ...{ rms, shareBeyond3, largest, blockError, picture, failures },
    convergence: await converge(page, backend, name, reference),
  };
}

/** One film in parts, each as long as all before: 1, 2, 4 … samples a pixel. */
async function converge(page: Page, backend: Backend, name: string, reference: Reference): Promise<Convergence> {
  const { width, height } = reference;
  const steps: { samples: number; error: number }[] = [];
  let film: Film | null = null;
  for (let samples = 1; samples <= CHART_SAMPLES; samples *= 2) {
    const first = samples === 1 ? 0 : samples / 2;
    const range = { width, height, firstSample: first, samples: samples - first, seed: CHART_SEED };
    const part: Film = await pathFilm(page, backend, referenceScene(name), range);
    film = film ? mergeFilms([film, part]) : part;
    steps.push({ samples, error: relativeError(film, reference) });
  }
  return { steps, floor: noiseFloor(reference) };
}

function writePicture(name: string, picture: Picture): void {
  writeFileSync(join(folder, `${name}.png`), encodePng(picture));
}

/** Six digits: enough to look at, and short. */
const rounded = (_: string, value: unknown): unknown =>
  typeof value === 'number' ? Number(value.toPrecision(6)) : value;

const { values, positionals } = parseArgs({
  options: { backend: { type: 'string', default: 'webgl2' } },
  allowPositionals: true,
});
const unknown = positionals.filter((name) => !referenceNames.includes(name));
if (unknown.length > 0) throw new Error(`There is no ${unknown.join(', ')}; there are ${referenceNames.join(', ')}.`);
if (values.backend !== 'webgpu' && values.backend !== 'webgl2') throw new Error('--backend is webgpu or webgl2.');
const wanted = positionals.length > 0 ? positionals : referenceNames;

mkdirSync(folder, { recursive: true });
const before: SceneProof[] = existsSync(resultsFile) ? JSON.parse(readFileSync(resultsFile, 'utf8')) : [];
const results = new Map(before.map((scene) => [scene.name, scene]));
const browser = await chromium.launch({ executablePath: await ensureChromium(), args: chromiumFlags });
const server = await serveHarness();
try {
  const page = await browser.newPage();
  await page.goto(`${server.origin}/tests/index.html`);
  await page.waitForFunction(() => window.harness !== undefined);
  for (const name of wanted) {
    const start = performance.now();
    const proof = await prove(page, values.backend, name);
    results.set(name, proof);
    const seconds = ((performance.now() - start) / 1000).toFixed(0);
    const verdict = proof.failures.length === 0 ? 'agrees' : `DIFFERS: ${proof.failures.join('; ')}`;
    console.log(
      `${name}: ${verdict} (z rms ${proof.rms.toFixed(2)}, block ${(100 * proof.blockError).toFixed(2)} %, ${seconds} s)`,
    );
  }
} finally {
  await browser.close();
  await server.close();
}
const scenes = referenceNames.flatMap((name) => results.get(name) ?? []);
writeFileSync(resultsFile, `${JSON.stringify(scenes, rounded, 1)}\n`);
writeFileSync(join(folder, 'index.html'), proofPage(scenes));
console.log(`docs/proof/index.html: ${scenes.length} scenes.`);
if (scenes.some(({ failures }) => failures.length > 0)) process.exitCode = 1;
