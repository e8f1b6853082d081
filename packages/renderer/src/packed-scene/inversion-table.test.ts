import { expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { inversionTableSize, writeInversionTable } from './inversion-table.ts';

const STEPS = 2 ** 24;

function tableOf(weights: Float64Array) {
  const table = new Float32Array(inversionTableSize(weights.length) + 4).fill(0);
  writeInversionTable(table, 4, weights);
  const entry = (i: number) => ({
    share: (table[4 + 2 * i]! + (table[5 + 2 * i]! % 4096) / 4096) / STEPS,
    guide: Math.floor(table[5 + 2 * i]! / 4096),
  });
  return Array.from({ length: 2 * Math.ceil(weights.length / 2) }, (_, i) => entry(i));
}

/** Of wildly different sizes, some of them 0, also at both ends. */
function wild(n: number, random: () => number): Float64Array {
  const weights = Float64Array.from({ length: n }, () => (random() < 0.3 ? 0 : 10 ** (12 * random() - 6)));
  weights[Math.floor(n / 2)] = 1;
  return weights;
}

test('shares are sums of weights up to 2^-36, and what weighs nothing has none (seed 191)', () => {
  const random = seededRandom(191);
  for (const n of [1, 2, 3, 17, 100, 4095, 4096]) {
    const weights = wild(n, random);
    const entries = tableOf(weights);
    const total = weights.reduce((sum, w) => sum + w, 0);
    let sum = 0;
    weights.forEach((w, i) => {
      sum += w;
      expect(Math.abs(entries[i]!.share - sum / total)).toBeLessThan(2 ** -36);
      if (w === 0) expect(entries[i]!.share).toBe(i === 0 ? 0 : entries[i - 1]!.share);
    });
    // The last pair ends all searches.
    expect(entries.at(-1)!.share).toBe(1);
  }
});

test('a guide names the first pair that may be chosen in its part (seed 192)', () => {
  const random = seededRandom(192);
  for (const n of [1, 2, 5, 64, 1001]) {
    const entries = tableOf(wild(n, random));
    for (let part = 0; part < n; part++) {
      const first = entries.findIndex(({ share }) => share > part / n);
      expect(entries[part]!.guide).toBe(Math.floor(first / 2));
    }
  }
});

test('without any weight all is 0', () => {
  expect(tableOf(new Float64Array(3))).toEqual(Array.from({ length: 4 }, () => ({ share: 0, guide: 0 })));
});
