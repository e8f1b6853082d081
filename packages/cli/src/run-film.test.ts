import type { FilmSums, FilmTracer, TraceOptions } from 'mirrorball/headless';
import { expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import { type FilmGoal, runFilm } from './run-film.ts';
import type { Savings } from './savings.ts';

const PIXELS = 7;
/** Samples of each of the first blocks, and of all from that many on. */
const [BLOCK, LARGE] = [32, 256];
const quiet = { update: () => {}, stop: () => {} };
const never = new AbortController().signal;

/** Sample s of value i is a fixed number. Calls `during` after each sample; ends early when it is told to. */
class FakeTracer implements FilmTracer {
  readonly description = 'fake';
  readonly traced: [first: number, count: number][] = [];
  during: (sample: number) => void | Promise<void> = () => {};
  async begin() {}
  dispose() {}
  async trace(first: number, count: number, onto: FilmSums | null, { signal, onProgress }: TraceOptions = {}) {
    this.traced.push([first, count]);
    const sums = onto?.slice() ?? new Float32Array(PIXELS * 4);
    for (let s = first; s < first + count && !signal?.aborted; s++) {
      for (let i = 0; i < sums.length; i++) sums[i]! += i % 4 === 3 ? 1 : ((s * 37 + i * 11) % 101) / 101;
      await this.during(s);
      onProgress?.(s - first + 1);
    }
    return sums;
  }
}

const run = (tracer: FilmTracer, film: AccumulatedFilm, goal: FilmGoal, signal = never) =>
  runFilm(tracer, film, goal, signal, quiet);
const to = (last: number, first = 0) => ({ wanted: { first, last } });

test('blocks end at the same samples wherever a run begins', async () => {
  const tracer = new FakeTracer();
  expect(await run(tracer, new AccumulatedFilm(PIXELS), to(2 * BLOCK + 2, 5))).toBe('all samples');
  expect(tracer.traced).toEqual([
    [5, BLOCK - 5],
    [BLOCK, BLOCK],
    [2 * BLOCK, 3],
  ]);
});

test('what is in one run what others have, and cut where a block ends, is the same film, bit for bit', async () => {
  const whole = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), whole, to(3 * LARGE + 9));
  const cuts = [0, 2 * BLOCK, LARGE, 2 * LARGE, 3 * LARGE + 10];
  const merged = new AccumulatedFilm(PIXELS);
  for (const [i, first] of cuts.slice(0, -1).entries()) {
    const tracer = new FakeTracer();
    const part = new AccumulatedFilm(PIXELS);
    await run(tracer, part, to(cuts[i + 1]! - 1, first));
    if (first === LARGE) expect(tracer.traced).toEqual([[LARGE, LARGE]]);
    merged.merge(part);
  }
  expect(merged.ranges).toEqual(whole.ranges);
  expect(merged.mean()).toEqual(whole.mean());
  expect(merged.standardErrors()).toEqual(whole.standardErrors());
});

test('interrupted anywhere and resumed: the same film, bit for bit', async () => {
  const last = 2 * LARGE + 4;
  const whole = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), whole, to(last));
  for (const at of [0, 1, BLOCK - 2, BLOCK - 1, BLOCK, 2 * BLOCK + 3, LARGE - 1, LARGE, LARGE + BLOCK, last - 1]) {
    const film = new AccumulatedFilm(PIXELS);
    const tracer = new FakeTracer();
    const stop = new AbortController();
    tracer.during = (s) => {
      if (s === at) stop.abort();
    };
    expect(await run(tracer, film, to(last), stop.signal)).toBe('interrupted');
    expect(film.samples).toBe(at + 1);
    expect(await run(new FakeTracer(), film, to(last))).toBe('all samples');
    expect(film.closed).toEqual(whole.closed);
  }
});

test('with a time to end at, the first sample is traced alone, whatever the time', async () => {
  const tracer = new FakeTracer();
  await run(tracer, new AccumulatedFilm(PIXELS), { ...to(BLOCK), untilTime: 1e6 });
  expect(tracer.traced).toEqual([
    [0, 1],
    [1, BLOCK - 1],
    [BLOCK, 1],
  ]);
});

test('ends when the error is small enough, and not before it is known', async () => {
  const film = new AccumulatedFilm(PIXELS);
  expect(await run(new FakeTracer(), film, { ...to(9999), untilError: 10 })).toBe('error reached');
  expect(film.samples).toBe(2 * BLOCK);
});

test('ends when the time is over, however short, with one sample at least', async () => {
  const film = new AccumulatedFilm(PIXELS);
  const tracer = new FakeTracer();
  tracer.during = () => new Promise((resolve) => setTimeout(resolve, 1));
  expect(await run(tracer, film, { ...to(1e6), untilTime: 1e-9 })).toBe('time over');
  expect(film.samples).toBe(1);
});

test('holes in what is held are filled, and nothing is traced twice', async () => {
  const film = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), film, to(9, 3));
  await run(new FakeTracer(), film, to(BLOCK + 3, BLOCK));
  expect(film.ranges).toEqual([
    { first: 3, last: 9 },
    { first: BLOCK, last: BLOCK + 3 },
  ]);
  await run(new FakeTracer(), film, to(BLOCK + 9));
  expect(film.ranges).toEqual([{ first: 0, last: BLOCK + 9 }]);
});

test('saved again and again on the way, also within a block: the same film, bit for bit', async () => {
  const last = LARGE + BLOCK + 4;
  const whole = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), whole, to(last));
  const film = new AccumulatedFilm(PIXELS);
  const saved: number[] = [];
  const savings: Savings = { due: () => true, save: async () => void saved.push(film.samples) };
  const tracer = new FakeTracer();
  expect(await runFilm(tracer, film, to(last), never, quiet, savings)).toBe('all samples');
  expect(film.closed).toEqual(whole.closed);
  expect(saved.slice(0, 4)).toEqual([2, 4, 6, 8]);
  expect(saved).toContain(LARGE + 10);
  expect(saved.at(-1)).toBe(last + 1);
});

test('what was traced before a failure stays', async () => {
  const film = new AccumulatedFilm(PIXELS);
  const tracer = new FakeTracer();
  tracer.during = (s) => {
    if (s === BLOCK + 3) throw new Error('lost');
  };
  await expect(run(tracer, film, to(3 * BLOCK))).rejects.toThrow('lost');
  expect(film.ranges).toEqual([{ first: 0, last: BLOCK - 1 }]);
});
