import { describe, expect, test } from 'vitest';
import { chiSquareExcess, isNet, PairCounts } from '../../../../tests/fixtures/nets.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { Sampler, type SamplerKind } from './sampler.ts';

type Pixel = readonly [number, number];
const range = (n: number) => Array.from({ length: n }, (_, k) => k);

/** The draws of one group of dimensions for samples first … first + n − 1 of each pixel. */
function draws(
  pixels: readonly Pixel[],
  n: number,
  group: number,
  seed: number,
  first = 0,
): [number, number, number][] {
  return pixels.flatMap(([x, y]) => range(n).map((i) => new Sampler(x, y, first + i, seed).skip(group).next3d()));
}
const firstTwo = (points: [number, number, number][]) => points.map(([a, b]) => [a, b]);

const PIXELS: readonly Pixel[] = [
  [0, 0],
  [37, 91],
  [1919, 1079],
];

describe('one pixel', () => {
  test.each(range(11))('any aligned 2^%i samples are a (0, m, 2)-net in base 2, in every group (seed 3)', (m) => {
    for (const pixel of PIXELS)
      for (const group of [0, 1, 2, 17, 100])
        for (const block of [0, 1, 5])
          expect(isNet(firstTwo(draws([pixel], 2 ** m, group, 3, block * 2 ** m)), 2)).toBe(true);
  });

  test.each(range(6))('any aligned 4^%i samples are a (0, m, 3)-net in base 4 (seed 4)', (m) => {
    for (const pixel of PIXELS)
      for (const group of [0, 7])
        for (const block of [0, 3]) expect(isNet(draws([pixel], 4 ** m, group, 4, block * 4 ** m), 4)).toBe(true);
  });

  test('each dimension alone, of next1d too, has one number in each of 2^m parts (seed 5)', () => {
    for (const m of range(11)) {
      const numbers = range(2 ** m).map((i) => [new Sampler(12, 5, i, 5).skip(3).next1d()]);
      expect(isNet(numbers, 2)).toBe(true);
      for (const d of range(3))
        expect(
          isNet(
            draws([[12, 5]], 2 ** m, 3, 5).map((p) => [p[d]!]),
            2,
          ),
        ).toBe(true);
    }
  });

  test('after 65536 samples a new sequence begins (seed 6)', () => {
    const [before, after] = [0, 65536].map((first) => draws([[3, 4]], 256, 2, 6, first));
    expect(isNet(firstTwo(after!), 2)).toBe(true);
    expect(new Set([...before!, ...after!].flat()).size).toBeGreaterThan(6 * 256 - 10);
  });

  test('numbers are multiples of 2^-24 in [0, 1), and next1d, next2d and next3d begin alike (seed 7)', () => {
    const random = seededRandom(7);
    for (const k of range(2000)) {
      const [x, y, i] = [random() * 4096, random() * 4096, random() * 2 ** 20].map(Math.floor) as [
        number,
        number,
        number,
      ];
      const sampler = () => new Sampler(x, y, i, 7).skip(k % 50);
      const point = sampler().next3d();
      expect(sampler().next1d()).toBe(point[0]);
      expect(sampler().next2d()).toEqual(point.slice(0, 2));
      for (const u of point) {
        expect(u * 2 ** 24).toBe(Math.floor(u * 2 ** 24));
        expect(u >= 0 && u < 1).toBe(true);
      }
    }
  });

  test('a sample is the same whatever was drawn before it (seed 8)', () => {
    const whole = draws([[9, 8]], 100, 0, 8);
    expect(draws([[9, 8]], 20, 0, 8, 40)).toEqual(whole.slice(40, 60));
    expect(new Sampler(9, 8, 77, 8).next3d()).toEqual(whole[77]);
    const sampler = new Sampler(9, 8, 77, 8);
    sampler.next1d();
    sampler.next2d();
    expect(sampler.next3d()).toEqual(draws([[9, 8]], 78, 2, 8)[77]);
  });
});

describe('a tile', () => {
  const block = (x: number, y: number, side: number): Pixel[] =>
    range(side * side).map((k) => [x + (k % side), y + Math.floor(k / side)] as const);

  test.each([
    [1, 2],
    [1, 4],
    [1, 8],
    [1, 16],
    [4, 2],
    [4, 4],
    [4, 8],
    [16, 2],
    [16, 4],
    [64, 2],
    [64, 4],
    [256, 2],
  ])('%i samples of each of %i × as many neighbours are together a (0, m, 3)-net in base 4 (seed 9)', (spp, side) => {
    for (const group of [0, 4]) {
      const points = draws(block(32 + 16 - side, 64 + side * (16 / side - 1), side), spp, group, 9);
      expect(isNet(points, 4)).toBe(true);
    }
  });
});

describe('chance', () => {
  const KINDS: readonly SamplerKind[] = ['sobol', 'independent'];
  /** χ² has a heavy tail: this is about one in 10⁵ for 255 degrees of freedom. */
  const MOST = 5;

  test.each(KINDS)('%s: each point is uniform over seeds, within and across groups (seeds 0 to 49999)', (kind) => {
    for (const [x, y, i] of [
      [0, 0, 0],
      [21, 9, 3],
    ] as const) {
      const pairs = range(7).map(() => new PairCounts(16));
      for (const seed of range(50000)) {
        const sampler = new Sampler(x, y, i, seed, kind);
        const [a, b, c] = sampler.next3d();
        const [d, e] = sampler.next2d();
        const tested = [
          [a, b],
          [a, c],
          [b, c],
          [a, d],
          [b, e],
          [c, d],
          [a, (16 * a) % 1],
        ] as const;
        tested.forEach(([u, v], k) => void pairs[k]!.add(u, v));
      }
      for (const { counts } of pairs) expect(chiSquareExcess(counts)).toBeLessThan(MOST);
    }
  });

  test.each(KINDS)('%s: neighbouring tiles, later runs and next seeds know nothing of each other (seed 11)', (kind) => {
    const pairs = range(4).map(() => new PairCounts(16));
    for (const k of range(50000)) {
      const [x, y] = [16 * (k % 250), 16 * Math.floor(k / 250)];
      const first = (dx: number, dy: number, i: number, seed: number) =>
        new Sampler(x + dx, y + dy, i, seed, kind).next2d()[0];
      const here = first(0, 0, 0, 11);
      const others = [first(16, 0, 0, 11), first(0, 16, 0, 11), first(0, 0, 65536, 11), first(0, 0, 0, 12)];
      others.forEach((other, n) => void pairs[n]!.add(here, other));
    }
    for (const { counts } of pairs) expect(chiSquareExcess(counts)).toBeLessThan(MOST);
  });

  test('independent: neighbours and following samples know nothing of each other (seed 12)', () => {
    const pairs = range(2).map(() => new PairCounts(16));
    for (const k of range(50000)) {
      const first = (x: number, i: number) => new Sampler(x, k >> 8, i, 12, 'independent').next2d()[0];
      pairs[0]!.add(first(k & 255, 0), first((k & 255) + 1, 0));
      pairs[1]!.add(first(k & 255, 0), first(k & 255, 1));
    }
    for (const { counts } of pairs) expect(chiSquareExcess(counts)).toBeLessThan(MOST);
  });

  // Samples 2 j and 2 j + 1 lie in different halves in every dimension, so at best n / 2 pairs are independent: √2 / √n.
  test.each([16, 64, 256])(
    'correlation of groups over %i samples of a pixel is that of chance (seeds 0 to 199)',
    (n) => {
      let squares = 0;
      for (const seed of range(200)) {
        const sampler = (i: number) => new Sampler(7, 3, i, seed);
        let sum = 0;
        for (const i of range(n)) {
          const s = sampler(i);
          sum += 12 * (s.next2d()[0] - 0.5) * (s.next2d()[1] - 0.5);
        }
        squares += (sum / n) ** 2;
      }
      expect(Math.sqrt(squares / 200)).toBeLessThan(1.6 / Math.sqrt(n));
    },
  );
});
