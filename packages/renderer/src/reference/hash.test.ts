import { expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { length } from '../scene/vec3.ts';
import { hashOfSample, lightRandoms, pcg } from './hash.ts';
import { samplePoints } from './sample-points.ts';

/** The formula of docs/classic.md in whole numbers without an upper end, cut to 32 bits by hand. */
function pcgBig(x: bigint): bigint {
  const cut = (n: bigint) => n & 0xffffffffn;
  const s = cut(cut(x) * 747796405n + 2891336453n);
  const w = cut(((s >> ((s >> 28n) + 4n)) ^ s) * 277803737n);
  return (w >> 22n) ^ w;
}

test('pcg follows its formula in exact arithmetic (seed 1)', () => {
  const random = seededRandom(1);
  const inputs = [
    0,
    1,
    2,
    0x7fffffff,
    0x80000000,
    0xffffffff,
    ...Array.from({ length: 5000 }, () => random() * 2 ** 32),
  ];
  for (const x of inputs.map(Math.floor)) expect(pcg(x)).toBe(Number(pcgBig(BigInt(x))));
});

test('known values: 0, 1 and 2³² − 1', () => {
  expect([0, 1, 0xffffffff].map(pcg)).toEqual([129708002, 2831084092, Number(pcgBig(0xffffffffn))]);
});

test('sums wrap at 2³² (seed 2)', () => {
  const random = seededRandom(2);
  for (let n = 0; n < 1000; n++) {
    const [i, j, s, seed] = Array.from({ length: 4 }, () => Math.floor(random() * 5000)) as [
      number,
      number,
      number,
      number,
    ];
    const h = pcgBig(BigInt(i) + pcgBig(BigInt(j) + pcgBig(BigInt(s) + pcgBig(BigInt(seed)))));
    expect(hashOfSample(i, j, s, seed)).toBe(Number(h));
    const first = pcgBig(h + 128n * 3n + 7n);
    const units = [first, pcgBig(first)].map((bits) => Number(bits >> 8n) / 2 ** 24);
    expect(lightRandoms(Number(h), 3, 7)).toEqual(units);
  }
});

test('1 sample point is the centre, 9 are the flat grid', () => {
  expect(samplePoints(1, [0.3, 0.7])).toEqual([[0, 0, 0]]);
  const grid = samplePoints(9, [0.3, 0.7]);
  expect(grid[0]).toEqual([-0.5, 0, -0.5]);
  expect(grid[5]).toEqual([0.5, 0, 0]);
  expect(grid[7]).toEqual([0, 0, 0.5]);
});

test.each([2, 8, 64, 256])('%i sample points lie on the sphere, one in each slice of equal area', (n) => {
  const points = samplePoints(n, lightRandoms(12345, 0, 0));
  points.forEach((p, k) => {
    expect(length(p)).toBeCloseTo(1, 12);
    expect(Math.floor(((1 - p[2]) / 2) * n)).toBe(k);
  });
});
