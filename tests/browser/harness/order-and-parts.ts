/** One long run of the path integrator beside several short ones, in any order, and beside the parts of its picture. */
import { AccumulatedFilm } from '../../../packages/cli/src/accumulated-film.ts';
import { runFilm } from '../../../packages/cli/src/run-film.ts';
import {
  DEFAULT_SETTINGS,
  type FilmArea,
  type FilmSums,
  type FilmTracer,
} from '../../../packages/renderer/src/headless/index.ts';
import { sceneNamed } from './scenes.ts';
import { type Entry, tracerBy } from './tracers.ts';

const [WIDTH, HEIGHT] = [19, 13];
const WHOLE: FilmArea = { x: 0, y: 0, width: WIDTH, height: HEIGHT };
/** Cuts at odd places, also through the tiles of compute passes, and one part of a single pixel. */
const PARTS: readonly FilmArea[] = [
  { x: 9, y: 0, width: 10, height: 4 },
  { x: 0, y: 0, width: 9, height: 12 },
  { x: 9, y: 4, width: 10, height: 9 },
  { x: 1, y: 12, width: 8, height: 1 },
  { x: 0, y: 12, width: 1, height: 1 },
];

/** Largest difference of two films' sums, relative to the second one's. */
function apart(a: ArrayLike<number>, b: ArrayLike<number>): number {
  let largest = a.length === b.length ? 0 : Number.POSITIVE_INFINITY;
  for (let i = 0; i < b.length; i++)
    largest = Math.max(largest, a[i] === b[i] ? 0 : Math.abs(a[i]! - b[i]!) / Math.abs(b[i]!));
  return largest;
}

const merged = (films: readonly FilmSums[]): Float64Array =>
  films.reduce((sum, film) => sum.map((value, i) => value + film[i]!), new Float64Array(films[0]!.length));

function put(film: Float64Array, part: FilmSums, { x, y, width, height }: FilmArea): void {
  for (let layer = 0; layer < 2; layer++)
    for (let row = 0; row < height; row++) {
      const at = (layer * height + row) * width * 4;
      film.set(part.subarray(at, at + width * 4), ((layer * HEIGHT + y + row) * WIDTH + x) * 4);
    }
}

const quiet = { update: () => {}, stop: () => {} };
const never = new AbortController().signal;

/** Samples from `first` on as the command line sums them up: blocks on the device, and these in double precision. */
async function accumulated(tracer: FilmTracer, first: number, count: number): Promise<AccumulatedFilm> {
  const film = new AccumulatedFilm(WIDTH * HEIGHT);
  await runFilm(tracer, film, { wanted: { first, last: first + count - 1 } }, never, quiet);
  return film;
}

async function joined(tracer: FilmTracer, firsts: readonly number[], count: number): Promise<Float32Array> {
  const film = new AccumulatedFilm(WIDTH * HEIGHT);
  for (const first of firsts) film.merge(await accumulated(tracer, first, count));
  return film.mean();
}

/** Samples that calls on top of one another begin at: groups of 32 are rounded together where passes compute. */
const CUTS = [32, 96, 128];

async function onTopOfOneAnother(tracer: FilmTracer, samples: number): Promise<FilmSums> {
  let film: FilmSums | null = null;
  for (const [i, first] of [0, ...CUTS].entries()) film = await tracer.trace(first, (CUTS[i] ?? samples) - first, film);
  return film!;
}

/** Ends as soon as a sample is done, and goes on from there. */
async function interrupted(tracer: FilmTracer, samples: number): Promise<FilmSums> {
  const stop = new AbortController();
  const begun = await tracer.trace(0, samples, null, { signal: stop.signal, onProgress: () => stop.abort() });
  const held = begun[3]!;
  return held < samples ? tracer.trace(held, samples - held, held > 0 ? begun : null) : begun;
}

/** How far the sums of `samples` at once are from those of four runs, in two orders, of runs that went on, and of parts; squares count too. */
export async function orderAndParts(entry: Entry, name: string, samples: number, seed: number) {
  const tracer = await tracerBy(entry);
  const scene = sceneNamed(name);
  const settings = { ...DEFAULT_SETTINGS, ...scene.render, integrator: 'path', seed } as const;
  const job = { scene, settings, width: WIDTH, height: HEIGHT, squares: true };
  await tracer.begin({ ...job, area: WHOLE });
  const quarter = samples / 4;
  const film = (await accumulated(tracer, 0, samples)).mean();
  const orders = [
    [0, 1, 2, 3],
    [3, 1, 0, 2],
  ].map((order) => order.map((n) => n * quarter));
  const runs = [];
  for (const firsts of orders) runs.push(apart(await joined(tracer, firsts, quarter), film));
  const whole = await tracer.trace(0, samples, null);
  const goneOn = [await onTopOfOneAnother(tracer, samples), await interrupted(tracer, samples)];
  const quarters: FilmSums[] = [];
  for (const first of orders[1]!) quarters.push(await tracer.trace(first, quarter, null));
  const union = new Float64Array(whole.length).fill(Number.NaN);
  for (const area of PARTS) {
    await tracer.begin({ ...job, area });
    put(union, await tracer.trace(0, samples, null), area);
  }
  return {
    samples: whole[3],
    brightest: Math.max(...whole.subarray(0, whole.length / 2)),
    runs,
    goneOn: goneOn.map((sums) => apart(sums, whole)),
    sums: apart(merged(quarters), whole),
    parts: apart(union, whole),
  };
}
