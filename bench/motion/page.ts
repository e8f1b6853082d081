/**
 * Frames a second of models that play in the page, what its thread does in one, and how late the picture is:
 *
 *     npm run bench:motion-page -- --models FOLDER [--backend webgl2,webgpu] [--rounds 4] [--size 384] [--no-build]
 *
 * for each .glb and .gltf file of the folder that moves, beside the same model that stands still while its film begins anew in every frame,
 * as if it moved; and for a skin of 120,000 triangles. Large meshes twice, bent in a worker and on the page's thread. In a Chromium that draws in
 * software, unless it is given a GPU; full resolution, one sample a pixel and frame.
 */
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import type { Page } from '@playwright/test';
import { buildStudio, studioFolder } from '../../scripts/build-studio.mjs';
import { ensureChromium } from '../../scripts/install-chromium.mjs';
import { serveFolders } from '../../scripts/static-server.mjs';
import { arm } from '../../tests/fixtures/motion.ts';
import { withBrowser } from '../browser.mjs';
import { markdownTable, median } from '../statistics.mjs';

const { values } = parseArgs({
  options: {
    models: { type: 'string' },
    backend: { type: 'string', default: 'webgl2,webgpu' },
    rounds: { type: 'string', default: '4' },
    size: { type: 'string', default: '384' },
    'no-build': { type: 'boolean', default: false },
  },
});
if (values.models === undefined) throw new Error('--models FOLDER says where the models are.');
const folder = values.models;
/** Of the picture, pixels. */
const SIDE = Number(values.size);
/** At so small a speed a double keeps its value when time passes, and all else is as in motion. */
const STILL = 1e-300;
/** The page's own figure is a mean over a second. */
const SETTLE_MS = 1500;
const READ_MS = 250;
const READS = 8;

// biome-ignore lint/suspicious/noExplicitAny: what the page has for its console
type Window = { readonly mirrorball: any };

interface Pace {
  readonly framesPerSecond: number;
  /** Milliseconds of a frame that the page's thread is at work until all is submitted: the median. */
  readonly thread: number;
  /** Of the scene's time that the last picture is behind it, milliseconds: the median. */
  readonly late: number;
}

/** At this speed, from now on. */
async function paceAt(page: Page, speed: number): Promise<Pace> {
  const { fps, thread, late } = await page.evaluate(
    async ({ speed, settle, pause, reads }) => {
      const { renderer } = (globalThis as unknown as Window).mirrorball;
      renderer.speed = speed;
      await new Promise((resolve) => setTimeout(resolve, settle));
      const [fps, late, thread]: [number[], number[], number[]] = [[], [], []];
      const ask = globalThis.requestAnimationFrame;
      const counts = globalThis as unknown as { submits: number };
      globalThis.requestAnimationFrame = (tick) =>
        ask((now) => {
          const { submits } = counts;
          const begun = performance.now();
          tick(now);
          if (counts.submits > submits) thread.push(performance.now() - begun);
        });
      for (let i = 0; i < reads; i++) {
        fps.push(renderer.stats.fps);
        late.push(1000 * (renderer.time - renderer.stats.time));
        await new Promise((resolve) => setTimeout(resolve, pause));
      }
      globalThis.requestAnimationFrame = ask;
      return { fps, thread, late };
    },
    { speed, settle: SETTLE_MS, pause: READ_MS, reads: READS },
  );
  return { framesPerSecond: fps.reduce((sum, x) => sum + x, 0) / READS, thread: median(thread), late: median(late) };
}

/** Shows the scene and waits until paths have drawn it; its numbers go over as text. */
async function show(page: Page, scene: unknown): Promise<boolean> {
  const text = JSON.stringify(scene, (_, value) =>
    ArrayBuffer.isView(value) ? { array: value.constructor.name, of: [...(value as Float32Array)] } : value,
  );
  await page.evaluate(async (text) => {
    const scene = JSON.parse(text, (_, value) =>
      value?.array ? new (globalThis as never as Record<string, typeof Float32Array>)[value.array]!(value.of) : value,
    );
    const { renderer } = (globalThis as unknown as Window).mirrorball;
    await renderer.setScene(scene);
    renderer.time = 0.5;
    renderer.playing = true;
  }, text);
  return true;
}

/** Counts what is drawn or submitted. */
const countSubmits = (page: Page) =>
  page.addInitScript(() => {
    const counts = globalThis as unknown as { submits: number };
    counts.submits = 0;
    for (const [of, name] of [
      [WebGL2RenderingContext.prototype, 'drawArrays'],
      [globalThis.GPUQueue?.prototype, 'submit'],
    ] as const) {
      // biome-ignore format: pairs
      const methods = of as unknown as Record<string, (...values: unknown[]) => unknown> | undefined;
      const method = methods?.[name];
      if (!methods || !method) continue;
      methods[name] = function (this: unknown, ...values) {
        counts.submits++;
        return method.apply(this, values);
      };
    }
  });

/** The worker that is to bend meshes ends at once, and the page's thread does it. */
const withoutPoses = (page: Page) =>
  page.addInitScript(() => {
    const { postMessage } = Worker.prototype;
    Worker.prototype.postMessage = function (this: Worker, message: unknown, ...more: unknown[]) {
      const bends = typeof message === 'object' && message !== null && 'bend' in message;
      if (bends) setTimeout(() => this.dispatchEvent(new ErrorEvent('error', { cancelable: true })));
      else Reflect.apply(postMessage, this, [message, ...more]);
    };
  });

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

/** `by`: what bends large meshes. */
async function measure(
  chromium: string,
  origin: string,
  backend: string,
  model: string,
  by: By,
): Promise<string[] | null> {
  return withBrowser(chromium, async (browser) => {
    const page = await browser.newPage({ viewport: { width: 960, height: 640 } });
    await countSubmits(page);
    if (by === 'the thread') await withoutPoses(page);
    await page.goto(`${origin}/index.html?scene=cube-room&size=${SIDE}&adaptive=0&scale=1&paused=1&backend=${backend}`);
    await page.waitForFunction(() => (globalThis as unknown as Window).mirrorball?.renderer?.stats.samples > 0);
    const made = MADE[model];
    const files = /\.glb$/i.test(model) ? [model] : [model, ...others];
    if (!(await (made ? show(page, made) : open(page, files)))) return null;
    const [still, moving]: [Pace[], Pace[]] = [[], []];
    for (let round = 0; round < Number(values.rounds); round++) {
      still.push(await paceAt(page, STILL));
      moving.push(await paceAt(page, 1));
    }
    const of = (paces: Pace[], what: keyof Pace) => median(paces.map((pace) => pace[what]));
    const ratio = median(moving.map(({ framesPerSecond }, i) => framesPerSecond / still[i]!.framesPerSecond));
    const rates = [of(still, 'framesPerSecond').toFixed(1), of(moving, 'framesPerSecond').toFixed(1), ratio.toFixed(2)];
    return [model, backend, by, ...rates, of(still, 'thread').toFixed(1), of(moving, 'thread').toFixed(1), of(moving, 'late').toFixed(0)]; // biome-ignore format: a row
  });
}

type By = 'a worker' | 'the thread';
const MADE: Readonly<Record<string, unknown>> = { 'skin, 120 k triangles': arm(1000, 60, 20) };
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
    for (const model of [...names.filter(isModel), ...Object.keys(MADE)])
      for (const backend of values.backend.split(','))
        for (const by of ['a worker', 'the thread'] as const) {
          const row = await measure(chromium, `http://127.0.0.1:${server.port}`, backend, model, by);
          if (row) rows.push(row);
        }
    const head = ['model', 'backend', 'large meshes bent by', 'standing still, frames/s', 'playing, frames/s', 'ratio', 'thread in a frame, still, ms', 'playing, ms', 'picture behind the time, ms']; // biome-ignore format: one row
    console.log(`${SIDE} × ${SIDE}, one sample a pixel and frame\n\n${markdownTable(head, rows)}`);
  } finally {
    await server.close();
  }
}

await main();
