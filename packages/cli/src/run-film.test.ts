import type { FilmSums, FilmTracer, TraceOptions } from 'mirrorball/headless';
import { expect, test } from 'vitest';
import { AccumulatedFilm, BLOCK } from './accumulated-film.ts';
import { type FilmGoal, runFilm } from './run-film.ts';
import type { Savings } from './savings.ts';

const PIXELS = 7;
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
    [5, 1],
    [6, BLOCK - 6],
    [BLOCK, BLOCK],
    [2 * BLOCK, 3],
  ]);
});

test('interrupted anywhere and resumed: the same film, bit for bit', async () => {
  const whole = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), whole, to(3 * BLOCK + 4));
  for (const at of [0, 1, BLOCK - 2, BLOCK - 1, BLOCK, 2 * BLOCK + 3, 3 * BLOCK + 3]) {
    const film = new AccumulatedFilm(PIXELS);
    const tracer = new FakeTracer();
    const stop = new AbortController();
    tracer.during = (s) => {
      if (s === at) stop.abort();
    };
    expect(await run(tracer, film, to(3 * BLOCK + 4), stop.signal)).toBe('interrupted');
    expect(film.samples).toBe(at + 1);
    expect(await run(new FakeTracer(), film, to(3 * BLOCK + 4))).toBe('all samples');
    expect(film.closed).toEqual(whole.closed);
  }
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
  expect(film.samples).toBeGreaterThan(0);
  expect(film.samples).toBeLessThan(1e6);
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
  const whole = new AccumulatedFilm(PIXELS);
  await run(new FakeTracer(), whole, to(3 * BLOCK + 4));
  const film = new AccumulatedFilm(PIXELS);
  const saved: number[] = [];
  const savings: Savings = { due: () => true, save: async () => void saved.push(film.samples) };
  const tracer = new FakeTracer();
  expect(await runFilm(tracer, film, to(3 * BLOCK + 4), never, quiet, savings)).toBe('all samples');
  expect(film.closed).toEqual(whole.closed);
  expect(saved.slice(0, 4)).toEqual([1, 3, 5, 7]);
  expect(saved.at(-1)).toBe(3 * BLOCK + 5);
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
