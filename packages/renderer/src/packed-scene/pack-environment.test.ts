import { expect, test } from 'vitest';
import { ENVIRONMENTS, mapOf } from '../../../../tests/fixtures/lights/environments.ts';
import { densityOnMap, overMap, placeDensity } from '../reference/light/environment.ts';
import { environmentDirection, MOST_COLUMNS, MOST_ROWS } from '../scene/environment.ts';
import { inversionTableSize, MOST_ENTRIES } from './inversion-table.ts';
import { environmentRows, noEnvironment, packEnvironment } from './pack-environment.ts';

const small = Object.entries(ENVIRONMENTS).filter(([, { width }]) => width < 100);

/** Of each of n entries in the table that begins there: differences of the shares. */
function probabilities(texels: Float32Array, at: number, n: number): number[] {
  const share = (i: number) => (i < 0 ? 0 : (texels[at + 2 * i]! + (texels[at + 2 * i + 1]! % 4096) / 4096) / 2 ** 24);
  return Array.from({ length: n }, (_, i) => share(i) - share(i - 1));
}

test.each(small)('%s: cells are as likely as the density says, and alpha is the density', (_, map) => {
  const { width, height, texels, rows } = packEnvironment(map);
  expect(texels).toHaveLength(width * rows * 4);
  const first = 4 * width * height;
  const ofRow = probabilities(texels, first, height + 1);
  const p = ofRow.flatMap((row, j) => {
    const at = first + inversionTableSize(height + 1) + j * inversionTableSize(width);
    return probabilities(texels, at, width).map((cell) => cell * row);
  });
  const cells = p.length;
  const total = overMap(map, (place) => placeDensity(map, place));
  for (let k = 0; k < cells; k++) {
    const mass = overMap(map, ([x, y]) => {
      const [i, j] = [Math.floor(x + 0.5) % width, Math.floor(y + 0.5)];
      return j * width + i === k ? placeDensity(map, [x, y]) : 0;
    });
    expect(Math.abs(p[k]! - mass / total)).toBeLessThan(1e-10);
  }
  const pdf = densityOnMap(map);
  for (let k = 0; k < width * height; k++) {
    const v = (Math.floor(k / width) + 0.5) / height;
    const exact = pdf(environmentDirection(((k % width) + 0.5) / width, v)) * Math.sin(Math.PI * v);
    expect(Math.abs(texels[4 * k + 3]! - exact)).toBeLessThan(1e-6 * (1 + exact));
  }
});

test('the mean radiance is that over all directions, and without a map it is 1', () => {
  expect(noEnvironment().meanRadiance).toBeCloseTo(1, 3);
  expect(packEnvironment(mapOf(64, 32, () => [1, 2, 6])).meanRadiance).toBeCloseTo(3, 2);
  expect(packEnvironment(mapOf(4, 2, () => [0, 0, 0])).meanRadiance).toBe(0);
});

test('a map is packed once', () => {
  const map = mapOf(4, 2, () => [1, 1, 1]);
  expect(packEnvironment(map)).toBe(packEnvironment(map));
});

test('the largest map fits into the textures that devices have, and the numbers of its cells into tables', () => {
  expect(environmentRows(MOST_COLUMNS, MOST_ROWS)).toBeLessThanOrEqual(4096);
  expect(Math.max(MOST_COLUMNS, MOST_ROWS + 1)).toBeLessThanOrEqual(MOST_ENTRIES);
});

test('light samples go to what is brighter than the mean, and to all of a map where nothing is', () => {
  const alphas = (map: Parameters<typeof packEnvironment>[0]) =>
    Array.from({ length: map.width * map.height }, (_, k) => packEnvironment(map).texels[4 * k + 3]!);
  const sunny = alphas(mapOf(8, 4, (i, j) => (i === 3 && j === 1 ? [9, 9, 9] : [0.3, 0.2, 0.1])));
  expect(sunny.flatMap((alpha, k) => (alpha > 0 ? [k] : []))).toEqual([11]);
  for (const alpha of alphas(mapOf(8, 4, () => [0.3, 0.2, 0.1]))) expect(alpha).toBeGreaterThan(0.03);
});

test('what is no map is refused with the place', () => {
  const data = new Float32Array(12).fill(1);
  expect(() => packEnvironment({ width: 3, height: 2, data })).toThrow('12 numbers, where 3 × 2 texels need 18');
  expect(() => packEnvironment({ width: 5000, height: 2, data })).toThrow('a size of 5000 × 2');
  data[7] = Number.NaN;
  expect(() => packEnvironment({ width: 2, height: 2, data })).toThrow('the radiance NaN in column 0 of row 1');
});
