/**
 * How fast and how right the path integrator is on this machine's GPU, through Dawn for Node. Every scene of tests/reference is
 * rendered in 256 × 256 pixels: first its picture is judged against the reference, then it is timed.
 *
 *     npm run bench:gpu -- [scene …] [--samples 1024] [--batches 32] [--json FILE] [--write]
 *
 * `--batches 1` leaves the proof out; `--write` puts the table into docs/benchmarks.md. dist/gpu.mjs is one file: a machine without a
 * network needs this repository's files, Node and the package "webgpu" beside it.
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { readExr } from '../../packages/renderer/src/export/exr.ts';
import { type FilmJob, GpuFilmTracer, openWebGpu } from '../../packages/renderer/src/headless/index.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { relativeSquaredError } from '../../scripts/proof/convergence.ts';
import type { Film } from '../../tests/reference/blocks.ts';
import { namesIn, readPicture, readScene } from '../../tests/reference/reading.ts';
import { CUT } from '../../tests/reference/samples.ts';
import { judge, LIMITS } from '../../tests/reference/statistics.ts';
import { writeTable } from './write-table.ts';

const SIZE = 256;
/** Work before a film is timed, milliseconds: an idle GPU takes its time to clock up. */
const WARM_UP = 500;
/** What Mitsuba's independent sampler gave with 16 and 64 samples a pixel, mean of (a − r)² / (r² + 0.01). */
const MITSUBA_ERROR: Readonly<Record<string, readonly [number, number]>> = {
  C1: [0.0158, 0.004],
  V1_hc: [0.111, 0.0278],
  M1_hc: [0.0245, 0.0065],
  S1: [0.169, 0.0446],
};
/** What Mitsuba's cuda variant reached on an H100, million samples a second. */
const MITSUBA_SPEED: Readonly<Record<string, number>> = { C1: 247, S1: 108, V1_hc: 295, M1_hc: 372 };
/** Samples a pixel and batch, so that a block's combined error is at most 0.5 %. */
const PROOF_SAMPLES = 64;

const { values, positionals } = parseArgs({
  options: {
    samples: { type: 'string', default: '1024' },
    batches: { type: 'string', default: '32' },
    json: { type: 'string' },
    write: { type: 'boolean', default: false },
  },
  allowPositionals: true,
});
const samples = Number(values.samples);
const batches = Number(values.batches);
const references = pathToFileURL(`${resolve('tests/reference')}/`);

const device = await openWebGpu(null, { gpu: await dawnGpu() });
const tracer = await GpuFilmTracer.create(device);
console.log(`${tracer.description}, ${SIZE} × ${SIZE}, ${samples} samples a pixel, ${new Date().toISOString()}`);

async function begin(scene: Scene, seed: number, squares: boolean): Promise<void> {
  const area = { x: 0, y: 0, width: SIZE, height: SIZE };
  const settings = {
    ...scene.render,
    integrator: 'path',
    maxDepth: scene.render.maxDepth ?? -1,
    seed,
  } as FilmJob['settings'];
  await tracer.begin({ scene, settings, width: SIZE, height: SIZE, area, squares });
}

function filmOf(sums: Float32Array): Film {
  const texels = SIZE * SIZE;
  const rgb = (from: number) =>
    Float64Array.from({ length: 3 * texels }, (_, i) => sums[4 * (from + Math.floor(i / 3)) + (i % 3)]!);
  return {
    width: SIZE,
    height: SIZE,
    sum: rgb(0),
    sumOfSquares: rgb(texels),
    count: Float64Array.from({ length: texels }, (_, i) => sums[4 * i + 3]!),
  };
}

async function proof(scene: Scene, name: string) {
  const films: Film[] = [];
  for (let seed = 1; seed <= batches; seed++) {
    await begin(scene, seed, true);
    films.push(filmOf(await tracer.trace(0, PROOF_SAMPLES, null)));
  }
  return judge(films, readPicture(references, name), CUT, { ...LIMITS, blockError: 0.005 });
}

/** Milliseconds of one film, the reading of its sums included. */
async function time(scene: Scene): Promise<number> {
  await begin(scene, 100, false);
  for (const start = performance.now(); performance.now() - start < WARM_UP; ) await tracer.trace(0, samples, null);
  const runs: number[] = [];
  for (let run = 0; run < 5; run++) {
    const start = performance.now();
    await tracer.trace(0, samples, null);
    runs.push(performance.now() - start);
  }
  return runs.sort((a, b) => a - b)[2]!;
}

async function errorWith(scene: Scene, name: string, count: number): Promise<number> {
  const { channels } = readExr(readFileSync(resolve(`bench/gpu/references/${name}.exr`)));
  const channel = (letter: string) => channels.find((c) => c.name === letter)!.data;
  const [r, g, b] = [channel('R'), channel('G'), channel('B')];
  const mean = Float64Array.from({ length: 3 * SIZE * SIZE }, (_, i) => [r, g, b][i % 3]![Math.floor(i / 3)]!);
  await begin(scene, 7, true);
  const film = filmOf(await tracer.trace(0, count, null));
  return relativeSquaredError(film, { width: SIZE, height: SIZE, mean, error: mean });
}

const rows: Record<string, unknown>[] = [];
for (const name of positionals.length > 0 ? positionals : namesIn(references)) {
  const scene = readScene(references, name);
  const judged = batches > 1 ? await proof(scene, name) : null;
  const milliseconds = await time(scene);
  const speed = (SIZE * SIZE * samples) / milliseconds / 1000;
  const row: Record<string, unknown> = {
    scene: name,
    ms: milliseconds.toFixed(1),
    'Msamples/s': speed.toFixed(0),
    '/ Mitsuba': MITSUBA_SPEED[name] ? (speed / MITSUBA_SPEED[name]).toFixed(2) : '',
  };
  if (judged) {
    row['z rms'] = judged.rms.toFixed(2);
    row['largest z'] = judged.largest.toFixed(1);
    row['block error %'] = (100 * judged.blockError).toFixed(2);
    row['bias %'] = (100 * Math.max(...judged.picture.map(({ difference }) => Math.abs(difference)))).toFixed(3);
    row.verdict = judged.failures.join('; ') || 'agrees';
  }
  const theirs = MITSUBA_ERROR[name];
  if (theirs) {
    row['relMSE 16'] = (await errorWith(scene, name, 16)).toExponential(2);
    row['relMSE 64'] = (await errorWith(scene, name, 64)).toExponential(2);
    row['Mitsuba 16'] = theirs[0];
    row['Mitsuba 64'] = theirs[1];
  }
  rows.push(row);
  console.log(
    Object.entries(row)
      .map(([key, value]) => `${key} ${value}`)
      .join(' | '),
  );
}
console.table(rows);
if (values.json) writeFileSync(values.json, JSON.stringify(rows, null, 1));
if (values.write)
  writeTable('bench:gpu', `${tracer.description} · ${SIZE} × ${SIZE}, ${samples} samples a pixel`, rows);
process.exit(rows.some(({ verdict }) => verdict !== undefined && verdict !== 'agrees') ? 1 : 0);
