import { expect, test } from 'vitest';
import { seededRandom } from '../../../tests/fixtures/random.ts';
import { AccumulatedFilm } from './accumulated-film.ts';
import { blockEnd } from './blocks.ts';

const PIXELS = 50;
/** Samples of each of the first blocks. */
const BLOCK = 32;

/** Sums of samples first … first + count − 1, in float32 and in order, as tracers make them. */
function sums(values: (sample: number, index: number) => number, first: number, count: number, onto?: Float32Array) {
  const sum = onto?.slice() ?? new Float32Array(PIXELS * 4);
  for (let s = first; s < first + count; s++)
    for (let i = 0; i < sum.length; i++) sum[i]! += i % 4 === 3 ? 1 : values(s, i);
  return sum;
}

function randomValues(seed: number, samples = 4 * BLOCK) {
  const random = seededRandom(seed);
  const table = Float64Array.from({ length: samples * PIXELS * 4 }, random);
  return (s: number, i: number) => table[s * PIXELS * 4 + i]!;
}

function filled(values: (s: number, i: number) => number, first: number, count: number) {
  const film = new AccumulatedFilm(PIXELS);
  for (let s = first; s < first + count; ) {
    const n = Math.min(blockEnd(s) + 1, first + count) - s;
    film.put(s, sums(values, s, n));
    s += n;
  }
  return film;
}

test('a block that is open closes at its end, with the sums of one that was never open (seed 2)', () => {
  const values = randomValues(2);
  const whole = filled(values, 0, BLOCK);
  const film = new AccumulatedFilm(PIXELS);
  film.put(0, sums(values, 0, 5));
  expect(film.open?.first).toBe(0);
  expect([film.samples, film.closed.blocks]).toEqual([5, 0]);
  film.put(0, sums(values, 5, BLOCK - 5, film.open!.sums));
  expect(film.open).toBeNull();
  expect(film.closed).toEqual(whole.closed);
});

test('merged films hold the samples of both, in any cut (seed 3)', () => {
  const values = randomValues(3);
  const whole = filled(values, 0, 4 * BLOCK).mean();
  for (const cut of [1, BLOCK - 1, BLOCK, 2 * BLOCK + 7]) {
    const film = filled(values, 0, cut);
    film.merge(filled(values, cut, 4 * BLOCK - cut));
    expect(film.ranges).toEqual([{ first: 0, last: 4 * BLOCK - 1 }]);
    film.mean().forEach((value, i) => {
      expect(Math.abs(value - whole[i]!)).toBeLessThan(1e-6);
    });
  }
  expect(() => filled(values, 0, 9).merge(filled(values, 8, 2))).toThrow('Samples 8 are there twice.');
});

test('the standard error of uniform random numbers is √(1/12 N), whatever the blocks (seed 4)', () => {
  const n = 30 * 256 + 5;
  const film = filled(randomValues(4, n), 0, n);
  film.close();
  const errors = film.standardErrors()!;
  const variance = errors.reduce((sum, e) => sum + e * e, 0) / errors.length;
  // 38 blocks of two sizes × 150 values: the estimate itself is good to about 2 %.
  expect(variance * 12 * n).toBeGreaterThan(0.92);
  expect(variance * 12 * n).toBeLessThan(1.08);
  expect(film.error()).toBeCloseTo(Math.sqrt(1 / 12 / n / (0.25 + 0.01)), 3);
});

test('no error is told before there are two blocks', () => {
  expect(filled(() => 1, 0, 2 * BLOCK - 1).error()).toBeNull();
  expect(filled(() => 1, 0, 2 * BLOCK).error()).toBe(0);
});
