/**
 * Frames a second of models that play in the page:
 *
 *     npm run bench:motion-page -- --models FOLDER [--backend webgl2,webgpu] [--rounds 4] [--no-build]
 *
 * for each .glb and .gltf file of the folder that moves, beside the same model that stands still while its film begins anew in every frame,
 * as if it moved. In a Chromium that draws in software, unless it is given a GPU; full resolution, one sample a pixel and frame.
 */
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import type { Page } from '@playwright/test';
import { buildStudio, studioFolder } from '../../scripts/build-studio.mjs';
import { ensureChromium } from '../../scripts/install-chromium.mjs';
import { serveFolders } from '../../scripts/static-server.mjs';
import { withBrowser } from '../browser.mjs';
import { markdownTable, median } from '../statistics.mjs';

const { values } = parseArgs({
  options: {
    models: { type: 'string' },
    backend: { type: 'string', default: 'webgl2,webgpu' },
    rounds: { type: 'string', default: '4' },
    'no-build': { type: 'boolean', default: false },
  },
});
if (values.models === undefined) throw new Error('--models FOLDER says where the models are.');
const folder = values.models;
/** Of the picture, pixels. */
const SIDE = 384;
/** At so small a speed a double keeps its value when time passes, and all else is as in motion. */
const STILL = 1e-300;
/** The page's own figure is a mean over a second. */
const SETTLE_MS = 1500;
const READ_MS = 250;
const READS = 8;

// biome-ignore lint/suspicious/noExplicitAny: what the page has for its console
type Window = { readonly mirrorball: any };

/** Frames a second at this speed, from now on. */
const framesPerSecond = (page: Page, speed: number): Promise<number> =>
  page.evaluate(
    async ({ speed, settle, pause, reads }) => {
      const { renderer } = (globalThis as unknown as Window).mirrorball;
      renderer.speed = speed;
      await new Promise((resolve) => setTimeout(resolve, settle));
      let sum = 0;
      for (let i = 0; i < reads; i++) {
        sum += renderer.stats.fps;
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
      return sum / reads;
    },
    { speed, settle: SETTLE_MS, pause: READ_MS, reads: READS },
  );

/** Opens the model and waits until paths have drawn it; whether it moves. */
async function open(page: Page, files: readonly string[]): Promise<boolean> {
  await page.locator('#scene-file').setInputFiles(files.map((file) => join(folder, file)));
  await page.waitForFunction(() => {
    const { renderer } = (globalThis as unknown as Window).mirrorball;
    return renderer.scene.meshes && !renderer.compiling && renderer.stats.samples > 0;
  });
  return page.evaluate(() => {
    const { renderer } = (globalThis as unknown as Window).mirrorball;
    renderer.time = 0.5;
    renderer.playing = true;
    return (renderer.scene.clips && Object.keys(renderer.scene.clips).length > 0) as boolean;
  });
}

async function measure(chromium: string, origin: string, backend: string, file: string): Promise<string[] | null> {
  return withBrowser(chromium, async (browser) => {
    const page = await browser.newPage({ viewport: { width: 960, height: 640 } });
    await page.goto(`${origin}/index.html?scene=cube-room&size=${SIDE}&adaptive=0&scale=1&paused=1&backend=${backend}`);
    await page.waitForFunction(() => (globalThis as unknown as Window).mirrorball?.renderer?.stats.samples > 0);
    const isGlb = file.endsWith('.glb');
    if (!(await open(page, isGlb ? [file] : [file, ...others]))) return null;
    const [still, moving, ratios]: [number[], number[], number[]] = [[], [], []];
    for (let round = 0; round < Number(values.rounds); round++) {
      still.push(await framesPerSecond(page, STILL));
      moving.push(await framesPerSecond(page, 1));
      ratios.push(moving.at(-1)! / still.at(-1)!);
    }
    return [file, backend, median(still).toFixed(1), median(moving).toFixed(1), median(ratios).toFixed(2)];
  });
}

const names = readdirSync(folder);
const isModel = (file: string) => /\.(glb|gltf)$/i.test(file);
/** What .gltf files may name. */
const others = names.filter((file) => /\.(bin|png|jpe?g|webp|ktx2)$/i.test(file));

async function main(): Promise<void> {
  if (!values['no-build'] && (await buildStudio()) !== 0) process.exit(1);
  const chromium = await ensureChromium();
  const server = await serveFolders({ mounts: { '/': studioFolder } });
  try {
    const rows: string[][] = [];
    for (const file of names.filter(isModel))
      for (const backend of values.backend.split(',')) {
        const row = await measure(chromium, `http://127.0.0.1:${server.port}`, backend, file);
        if (row) rows.push(row);
      }
    const head = ['model', 'backend', 'standing still, frames/s', 'playing, frames/s', 'ratio'];
    console.log(`${SIDE} × ${SIDE}, one sample a pixel and frame\n\n${markdownTable(head, rows)}`);
  } finally {
    await server.close();
  }
}

await main();
