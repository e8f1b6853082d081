import { expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { aliasTable } from './alias-table.ts';

/** What the table says about how often each is given. */
function probabilities({ own, other }: ReturnType<typeof aliasTable>): number[] {
  const p = new Array<number>(own.length).fill(0);
  own.forEach((share, i) => {
    p[i]! += share / own.length;
    p[other[i]!]! += (1 - share) / own.length;
  });
  return p;
}

test('every weight gets its share, from one to thousands of wildly different ones (seed 91)', () => {
  const random = seededRandom(91);
  for (const n of [1, 2, 3, 17, 4096]) {
    const weights = Float64Array.from({ length: n }, () => (random() < 0.2 ? 0 : 10 ** (12 * random() - 6)));
    weights[n - 1] = 1;
    const total = weights.reduce((sum, w) => sum + w, 0);
    const table = aliasTable(weights);
    for (const share of table.own) expect(share >= 0 && share <= 1).toBe(true);
    probabilities(table).forEach((p, i) => {
      expect(Math.abs(p - weights[i]! / total)).toBeLessThan(1e-12);
      if (weights[i] === 0) expect(p).toBe(0);
    });
  }
});

test('equal weights keep their own columns, and one alone takes all', () => {
  expect([...aliasTable(new Float64Array([3, 3, 3])).own]).toEqual([1, 1, 1]);
  expect(probabilities(aliasTable(new Float64Array([0, 0, 5, 0])))).toEqual([0, 0, 1, 0]);
});
