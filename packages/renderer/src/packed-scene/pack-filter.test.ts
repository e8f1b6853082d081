import { describe, expect, test } from 'vitest';
import { chiSquareExcess } from '../../../../tests/fixtures/nets.ts';
import { filterOffset } from '../reference/filter.ts';
import { Sampler } from '../reference/sampler.ts';
import { AXIS_FILTERS, areaTo, PIXEL_FILTERS } from './pack-filter.ts';

describe.each(PIXEL_FILTERS)('%s', (name) => {
  const filter = AXIS_FILTERS[name];
  const { radius } = filter;
  const total = areaTo(filter, radius, 4096);
  const share = (x: number) => 0.5 + (0.5 * Math.sign(x) * areaTo(filter, Math.abs(x), 512)) / total;
  const axis = (u: number) => filterOffset(name, [u, 0.5])[0];

  test('the distribution of places is never farther than 4e-5 from the filter’s; of box and tent it is exact', () => {
    const bound = name === 'box' || name === 'tent' ? 1e-12 : 4e-5;
    for (let k = 0; k <= 8192; k++) expect(Math.abs(share(axis(k / 8192)) - k / 8192)).toBeLessThan(bound);
  });

  test('places go up with u, are mirrored about the middle, and end at the radius', () => {
    let last = Number.NEGATIVE_INFINITY;
    for (let k = 0; k <= 8192; k++) {
      const x = axis(k / 8192);
      expect(x).toBeGreaterThan(last);
      expect(x).toBeCloseTo(-axis(1 - k / 8192), 10);
      last = x;
    }
    expect(axis(0.5)).toBe(0);
    expect(axis(1)).toBeCloseTo(radius, 10);
  });

  test('drawn places have its density by χ², mean 0, and no link between the axes (seed 31)', () => {
    const side = 12;
    const n = 100000;
    const edge = (k: number) => share(radius * ((2 * k) / side - 1));
    const along = Array.from({ length: side }, (_, k) => edge(k + 1) - edge(k));
    const cells = along.flatMap((a) => along.map((b) => a * b));
    const counts = cells.map(() => 0);
    const cell = (x: number) => Math.min(Math.floor(((x / radius + 1) * side) / 2), side - 1);
    let [sum, squares] = [0, 0];
    for (let k = 0; k < n; k++) {
      const sampler = new Sampler(k % 1000, Math.floor(k / 1000), 0, 31, 'independent');
      const [x, y] = filterOffset(name, sampler.next2d());
      counts[cell(x) * side + cell(y)]!++;
      sum += x + y;
      squares += x * x + y * y;
    }
    // Cells with next to no weight count together: χ² needs some hits in each.
    const rare = cells.map((p) => p * n < 10);
    const put = (values: readonly number[]) => [
      ...values.filter((_, k) => !rare[k]),
      values.reduce((s, v, k) => s + (rare[k] ? v : 0), 0),
    ];
    const [hits, shares] = rare.includes(true) ? [put(counts), put(cells)] : [counts, cells];
    expect(chiSquareExcess(hits, shares)).toBeLessThan(4);
    expect(Math.abs(sum)).toBeLessThan(4 * Math.sqrt(squares));
  });
});

test('the Gaussian has a standard deviation of nearly half a pixel', () => {
  const n = 4096;
  let squares = 0;
  for (let k = 0; k < n; k++) squares += filterOffset('gaussian', [(k + 0.5) / n, 0.5])[0] ** 2;
  expect(Math.sqrt(squares / n)).toBeCloseTo(0.5, 2);
});
