/**
 * How a model of 1.1 million triangles with textures is opened in the page: `npm run bench:size -- [--backend webgl2,webgpu] [--rounds 1]
 * [--no-build] [--verbose] [--write]`. For each backend a Chromium of its own, drawing in software.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, tmpdir, type } from 'node:os';
import { basename, join } from 'node:path';
import { parseArgs } from 'node:util';
import type { Page } from '@playwright/test';
import { buildStudio, studioFolder } from '../../scripts/build-studio.mjs';
import { ensureChromium } from '../../scripts/install-chromium.mjs';
import { serveFolders } from '../../scripts/static-server.mjs';
import { withBrowser } from '../browser.mjs';
import { markdownTable, median } from '../statistics.mjs';
import { Heap } from './heap.ts';
import { GRID, makeModel } from './model.ts';

const { values } = parseArgs({
  options: {
    backend: { type: 'string', default: 'webgl2,webgpu' },
    rounds: { type: 'string', default: '1' },
    'no-build': { type: 'boolean', default: false },
    verbose: { type: 'boolean', default: false },
    write: { type: 'boolean', default: false },
  },
});
const TEXTURE_BYTES = 2 * 2048 ** 2 * 4;
/** Before the heap is measured: what waits for another file ends, and finalizers run. */
const REST_MS = 6000;

interface Opened {
  /** Milliseconds since the file was chosen. */
  readonly phases: Readonly<Record<string, number>>;
  readonly shown: number;
  readonly compiled: number;
  readonly sketch: number;
  readonly traced: number;
}
interface Result extends Opened {
  readonly triangles: number;
  readonly geometryBytes: number;
  /** Bytes: before, open, left, left again. */
  readonly heap: readonly number[];
}
interface Probe {
  data(): readonly number[];
  watch(name: string): Promise<Opened>;
}
// biome-ignore lint/suspicious/noExplicitAny: what the page has for its console
type Window = { readonly sizeProbe: Probe; readonly mirrorball: any };

const rest = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

async function open(page: Page, heap: Heap, name: string, file: string): Promise<Opened> {
  const opened = page.evaluate((wanted) => (globalThis as unknown as Window).sizeProbe.watch(wanted), name);
  await heap.chooseFile('#scene-file', file);
  return opened;
}

async function measure(chromium: string, origin: string, backend: string, file: string): Promise<Result> {
  const name = basename(file).replace(/\.[^.]*$/, '');
  return withBrowser(chromium, async (browser) => {
    const page = await browser.newPage({ viewport: { width: 960, height: 640 } });
    await page.addInitScript({ content: readFileSync(new URL('observe.js', import.meta.url), 'utf8') });
    await page.goto(`${origin}/index.html?scene=cube-room&backend=${backend}`);
    await page.waitForFunction(() => (globalThis as unknown as Window).mirrorball?.renderer?.stats.samples > 0);
    const heap = await Heap.of(page);
    await rest(REST_MS);
    const before = await heap.bytes();
    const times = await open(page, heap, name, file);
    const data = await page.evaluate(() => (globalThis as unknown as Window).sizeProbe.data());
    const triangles = await page.evaluate(() => {
      const { meshes } = (globalThis as unknown as Window).mirrorball.renderer.scene;
      return Object.values(meshes as Record<string, { data: { indices: Uint32Array } }>).reduce((sum, { data }) => sum + data.indices.length / 3, 0); // biome-ignore format: one sum
    });
    const heaps = [before, await heap.bytes()];
    for (let again = 0; again < 2; again++) {
      if (again > 0) await open(page, heap, name, file);
      await page.evaluate(() =>
        document.querySelector<HTMLInputElement>('input[name=scene][value=cube-room]')!.click(),
      );
      await rest(REST_MS);
      heaps.push(await heap.bytes());
    }
    const all = data.reduce((sum, bytes) => sum + bytes, 0);
    return { ...times, triangles, geometryBytes: all - TEXTURE_BYTES, heap: heaps };
  });
}

const seconds = (all: readonly number[]) => (median(all) / 1000).toFixed(2);
const megabytes = (bytes: number) => (bytes / 1e6).toFixed(1);

function row(backend: string, results: readonly Result[]): string[] {
  const of = (read: (result: Result) => number) => results.map(read);
  const last = results.at(-1)!;
  return [
    backend,
    String(last.triangles),
    seconds(of(({ shown }) => shown)),
    seconds(of(({ sketch }) => sketch)),
    seconds(of(({ traced }) => traced)),
    (last.geometryBytes / last.triangles).toFixed(1),
    ...last.heap.map(megabytes),
    (last.heap[2]! / last.heap[0]!).toFixed(2),
    (last.heap[3]! / last.heap[2]!).toFixed(2),
  ];
}

function writeReport(report: string): void {
  const path = new URL('../../docs/benchmarks.md', import.meta.url);
  const [start, end] = ['<!-- npm run bench:size -- --write: start -->', '<!-- end -->'];
  const text = readFileSync(path, 'utf8');
  const from = text.indexOf(start);
  const to = text.indexOf(end, from);
  if (from < 0 || to < 0) throw new Error(`docs/benchmarks.md has lost its marks ${start} and ${end}`);
  writeFileSync(path, `${text.slice(0, from + start.length)}\n\n${report}\n\n${text.slice(to)}`);
}

async function main(): Promise<void> {
  if (!values['no-build'] && (await buildStudio()) !== 0) process.exit(1);
  const chromium = await ensureChromium();
  const server = await serveFolders({ mounts: { '/': studioFolder } });
  const folder = mkdtempSync(join(tmpdir(), 'mirrorball-size-'));
  try {
    const file = join(folder, 'large.glb');
    writeFileSync(file, makeModel(GRID));
    const rows: string[][] = [];
    for (const backend of values.backend.split(',')) {
      const results: Result[] = [];
      for (let round = 0; round < Number(values.rounds); round++) {
        const result = await measure(chromium, `http://127.0.0.1:${server.port}`, backend, file);
        if (values.verbose) console.error(JSON.stringify(result));
        results.push(result);
      }
      rows.push(row(backend, results));
    }
    const [processor] = cpus();
    const version = await withBrowser(chromium, async (browser) => browser.version());
    const head = ['backend', 'triangles', 'read and built, s', 'sketch, s', 'first traced picture, s', 'GPU bytes a triangle', 'JS heap before, MB', 'open, MB', 'left, MB', 'left again, MB', 'left ÷ before', 'left again ÷ left']; // biome-ignore format: one row
    const report = `${new Date().toISOString().slice(0, 10)} · ${cpus().length} × ${processor?.model.trim() ?? 'unknown processor'}, ${type()} · Chromium ${version}, SwiftShader (no GPU)\n\n${markdownTable(head, rows)}`;
    console.log(report);
    if (values.write) writeReport(report);
  } finally {
    rmSync(folder, { recursive: true });
    await server.close();
  }
}

await main();
