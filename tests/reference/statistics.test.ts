import { describe, expect, test } from 'vitest';
import { type Random, seededRandom } from '../fixtures/random.ts';
import { blocksOfBatches, blocksOfFilm, type Film, mergeFilms, type Reference, WHOLE } from './blocks.ts';
import { judge, LIMITS, normalOf } from './statistics.ts';

/** Pictures of known statistics: what a test may conclude from them is known beforehand. */
const SIZE = 32;
const CUT = { columns: 16, rows: 16 };
const PIXELS = SIZE * SIZE;
const BATCHES = 32;

/** Box and Muller 1958. */
const gauss = (random: Random): number => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());

/** A grey film of these sums: channels that depend on each other wholly, as those of a path nearly do. */
function film(count: number, sumOf: (pixel: number) => readonly [sum: number, squares: number]): Film {
  const [sum, sumOfSquares] = [new Float64Array(PIXELS * 3), new Float64Array(PIXELS * 3)];
  for (let p = 0; p < PIXELS; p++) {
    const [s, q] = sumOf(p);
    sum.fill(s, p * 3, p * 3 + 3);
    sumOfSquares.fill(q, p * 3, p * 3 + 3);
  }
  return { width: SIZE, height: SIZE, sum, sumOfSquares, count: new Float64Array(PIXELS).fill(count) };
}
/** Samples one by one. */
const drawn = (count: number, draw: () => number): Film =>
  film(count, () => {
    let [sum, squares] = [0, 0];
    for (let k = 0; k < count; k++) {
      const x = draw();
      sum += x;
      squares += x * x;
    }
    return [sum, squares];
  });
/** Films whose pixels are normal with this mean and, all films together, this standard error: quick to make. */
const normalFilms = (random: Random, error: number, mean: (pixel: number) => number): Film[] =>
  Array.from({ length: BATCHES }, () =>
    film(1, (p) => {
      const x = mean(p) + error * Math.sqrt(BATCHES) * gauss(random);
      return [x, x * x];
    }),
  );
const reference = (mean: number | ((pixel: number) => number), error = 0): Reference => ({
  width: SIZE,
  height: SIZE,
  mean: Float64Array.from({ length: PIXELS * 3 }, (_, i) =>
    typeof mean === 'number' ? mean : mean(Math.floor(i / 3)),
  ),
  error: new Float64Array(PIXELS * 3).fill(error),
});
const seeds = (count: number, first: number): Random[] =>
  Array.from({ length: count }, (_, n) => seededRandom(first + n));
const rms = (values: readonly number[]): number => Math.sqrt(values.reduce((s, x) => s + x * x, 0) / values.length);

describe('a right picture', () => {
  test('passes: at most 3 of 50 false alarms, fewer than 1 expected (seeds 1000 to 1049)', () => {
    // Pixels of 1 %, so blocks of 2 × 2 of 0.5 %; the reference has half of that, other noise for each seed.
    const results = seeds(50, 1000).map((random) => {
      const noise = Float64Array.from({ length: PIXELS }, () => 1 + 0.005 * gauss(random));
      return judge(
        normalFilms(random, 0.01, () => 1),
        reference((p) => noise[p]!, 0.005),
        CUT,
      );
    });
    expect(results.filter(({ failures }) => failures.length > 0).length).toBeLessThanOrEqual(3);
    // Below 1 by the pull of variances towards their neighbourhood.
    const all = rms(results.map((result) => result.rms));
    expect(all).toBeGreaterThan(0.93);
    expect(all).toBeLessThan(1.01);
    const wholes = rms(results.map(({ picture }) => picture[0]!.z));
    expect(wholes).toBeGreaterThan(0.8);
    expect(wholes).toBeLessThan(1.2);
    expect(results[0]!.blockError).toBeCloseTo(Math.hypot(0.005, 0.0025), 3);
  });

  test.each([
    ['exponential samples', 8, (r: Random) => -Math.log(1 - r()), 1],
    // 30 such samples in a block of all films together.
    ['caustics: one sample of 133 is 27 × as bright', 32, (r: Random) => 0.5 + (r() < 0.0075 ? 40 / 3 : 0), 0.6],
    ['power law without a third moment, exponent 2.5', 32, (r: Random) => (1 - r()) ** (-1 / 2.5), 2.5 / 1.5],
  ] as const)('passes with skewed noise: %s (seeds 7 to 10)', (_, count, draw, mean) => {
    for (const random of seeds(4, 7)) {
      const films = Array.from({ length: BATCHES }, () => drawn(count, () => draw(random)));
      const { failures, rms } = judge(films, reference(mean), CUT, { ...LIMITS, blockError: 0.04 });
      expect(failures).toEqual([]);
      expect(rms).toBeGreaterThan(0.85);
    }
  });

  test('a block that met no caustic is not certain of its mistake (seed 11)', () => {
    // Two bright samples a block: a seventh of all blocks meet none and would have no error at all.
    const random = seededRandom(11);
    const films = Array.from({ length: BATCHES }, () => drawn(32, () => 0.5 + (random() < 0.0005 ? 200 : 0)));
    const result = judge(films, reference(0.6), CUT);
    expect(result.largest).toBeLessThan(LIMITS.largest);
    expect(result.failures.join()).toMatch('combined error of a block');
  });

  test('passes without any noise, when only rounding differs', () => {
    const films = Array.from({ length: BATCHES }, () => film(8, (p) => [8 * (1 + 5e-5 * (-1) ** p), 8]));
    expect(judge(films, reference(1), CUT).failures).toEqual([]);
    const black = Array.from({ length: BATCHES }, () => film(8, () => [0, 0]));
    expect(judge(black, reference(0), CUT).failures).toEqual([]);
  });
});

describe('a wrong picture', () => {
  const failuresOf = (random: Random, mean: (pixel: number) => number) =>
    judge(normalFilms(random, 0.01, mean), reference(1), CUT).failures.join();

  test('1 % too bright everywhere is found (seeds 20 to 39)', () => {
    for (const random of seeds(20, 20)) expect(failuresOf(random, () => 1.01)).toMatch('whole picture');
  });
  test('1 % too bright and too dark in turn is found, though the mean is right (seeds 40 to 59)', () => {
    for (const random of seeds(20, 40))
      expect(failuresOf(random, (p) => 1 + 0.01 * (-1) ** Math.floor(p / SIZE / 2))).toMatch('root mean square');
  });
  test('one block in 50 off by 3 % is found (seeds 60 to 79)', () => {
    const block = (p: number) => Math.floor(p / SIZE / 2) * 16 + Math.floor((p % SIZE) / 2);
    for (const random of seeds(20, 60))
      expect(failuresOf(random, (p) => (block(p) % 50 === 0 ? 1.03 : 1))).toMatch('beyond 3');
  });
  test('one block off by 6 % is found (seeds 80 to 99)', () => {
    for (const random of seeds(20, 80))
      expect(failuresOf(random, (p) => (p % SIZE < 2 && p < SIZE * 2 ? 1.06 : 1))).toMatch('largest');
  });
  test('0.1 % without noise is found', () => {
    const films = Array.from({ length: BATCHES }, () => film(8, () => [8.008, 8.016]));
    expect(judge(films, reference(1), CUT).failures.join()).toMatch('largest');
  });
  test('light where there is none is found', () => {
    const films = Array.from({ length: BATCHES }, () => film(8, () => [1e-3, 1e-6]));
    expect(judge(films, reference(0), CUT).failures.join()).toMatch('largest');
  });
  test('NaN, infinite and negative sums are found', () => {
    for (const bad of [Number.NaN, Number.POSITIVE_INFINITY, -1]) {
      const films = Array.from({ length: BATCHES }, () => film(8, (p) => (p === 77 ? [bad, 8] : [8, 8])));
      expect(judge(films, reference(1), CUT).failures.join()).toMatch('96 sums are negative or not finite');
    }
  });
  test('too much noise to tell is a failure (seed 100)', () => {
    const failures = judge(
      normalFilms(seededRandom(100), 0.06, () => 1),
      reference(1),
      CUT,
    ).failures.join();
    expect(failures).toMatch('combined error of a block: 0.03');
  });
});

describe('the error of ours', () => {
  test('from sums of squares is σ / √n for independent samples (seed 110)', () => {
    const random = seededRandom(110);
    const blocks = blocksOfFilm(
      drawn(64, () => -Math.log(1 - random())),
      CUT,
    );
    const mean = blocks.variance.reduce((s, v) => s + v, 0) / blocks.variance.length;
    expect(mean * 4 * 64).toBeGreaterThan(0.97);
    expect(mean * 4 * 64).toBeLessThan(1.03);
  });
  test('is the same from batches and from their sums of squares (seed 111)', () => {
    const random = seededRandom(111);
    const films = Array.from({ length: BATCHES }, () => drawn(4, () => random()));
    const exact = 1 / 12 / (4 * BATCHES * 4);
    for (const blocks of [blocksOfBatches(films, CUT), blocksOfFilm(mergeFilms(films), CUT)]) {
      const ratio = blocks.variance.reduce((s, v) => s + v / exact, 0) / blocks.variance.length;
      expect(ratio).toBeGreaterThan(0.95);
      expect(ratio).toBeLessThan(1.12);
    }
  });
  test('of stratified samples is known to batches only (seed 112)', () => {
    const random = seededRandom(112);
    const stratified = () => {
      let k = 0;
      return drawn(16, () => ((k++ % 16) + random()) / 16);
    };
    const films = Array.from({ length: BATCHES }, stratified);
    const [batches, squares] = [blocksOfBatches(films, WHOLE), blocksOfFilm(mergeFilms(films), WHOLE)];
    // 16 strata: each has 1/16² of the variance.
    expect(batches.variance[0]! / squares.variance[0]!).toBeLessThan(3 / 256);
  });
  test('needs two samples, equal counts, and blocks that fit', () => {
    const one = film(1, () => [1, 1]);
    expect(() => blocksOfFilm(one, CUT)).toThrow('at least 2');
    expect(() => blocksOfBatches([one], CUT)).toThrow('At least two films');
    expect(() => blocksOfBatches([one, film(2, () => [2, 2])], CUT)).toThrow('unlike');
    expect(() => blocksOfBatches([one, one], { columns: 5, rows: 16 })).toThrow('equal blocks');
  });
});

test.each([
  // Student's t with so many degrees of freedom, and the normal quantile of the same probability.
  [4, 2.776, 1.96],
  [10, 2.228, 1.96],
  [10, 4.587, 3.2905],
  [15, 2.131, 1.96],
  [15, 4.073, 3.2905],
  [30, 3.646, 3.2905],
  [100, 1.984, 1.96],
])('with %i degrees of freedom t = %f is as unlikely as z = %f', (freedom, t, z) => {
  expect(Math.abs(normalOf(t, freedom) - z)).toBeLessThan(0.02);
  expect(normalOf(-t, freedom)).toBe(-normalOf(t, freedom));
});
