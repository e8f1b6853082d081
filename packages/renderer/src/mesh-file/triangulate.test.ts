import { expect, test } from 'vitest';
import { between, inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Vec3 } from '../scene/scene.ts';
import { addScaled, cross, dot, length, normalize } from '../scene/vec3.ts';
import { triangulate } from './triangulate.ts';

type Point = readonly [number, number];

/** The signed area of each triangle, of a polygon in the plane. */
function cut(polygon: readonly Point[]) {
  const triangles = triangulate(polygon.length, (k, c) => [...polygon[k]!, 0][c]!);
  const areas = Array.from({ length: triangles.length / 3 }, (_, t) => {
    const [a, b, c] = [0, 1, 2].map((k) => polygon[triangles[3 * t + k]!]!) as [Point, Point, Point];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])) / 2;
  });
  return { triangles, areas };
}
const areaOf = (polygon: readonly Point[]) =>
  polygon.reduce((sum, [x, y], k) => {
    const [u, v] = polygon[(k + 1) % polygon.length]!;
    return sum + (x * v - u * y) / 2;
  }, 0);

function expectWhole(polygon: readonly Point[]): void {
  const { triangles, areas } = cut(polygon);
  expect(triangles).toHaveLength(3 * (polygon.length - 2));
  const sign = Math.sign(areaOf(polygon));
  for (const area of areas) expect(sign * area).toBeGreaterThanOrEqual(0);
  expect(areas.reduce((a, b) => a + b, 0)).toBeCloseTo(areaOf(polygon), 9);
}

test('fewer than three corners are nothing, three are themselves, four of a square two', () => {
  expect(triangulate(0, () => 0)).toEqual([]);
  expect(triangulate(2, () => 0)).toEqual([]);
  expect(triangulate(3, () => 0)).toEqual([0, 1, 2]);
  expect(cut([[0, 0], [1, 0], [1, 1], [0, 1]]).triangles).toEqual([0, 1, 2, 0, 2, 3]); // biome-ignore format: short
});

test('an arrowhead is cut through its notch', () => {
  expectWhole([[0, 0], [4, 4], [0, 2], [-4, 4]]); // biome-ignore format: short
  expectWhole([[4, 4], [0, 2], [-4, 4], [0, 0]]); // biome-ignore format: short
});

test('a comb, a spiral, and a frame that touches itself at a cut', () => {
  const comb: Point[] = [[0, 0], [9, 0], [9, 3], [8, 3], [8, 1], [6, 1], [6, 3], [5, 3], [5, 1], [1, 1], [1, 3], [0, 3]]; // biome-ignore format: short
  expectWhole(comb);
  expectWhole([...comb].reverse());
  const turn = (k: number, r: number): Point => [r * Math.cos(k / 3), r * Math.sin(k / 3)];
  const outer = Array.from({ length: 40 }, (_, k) => turn(k, 1 + k / 10));
  expectWhole([...outer, ...Array.from({ length: 40 }, (_, k) => turn(39 - k, 0.7 + (39 - k) / 10))]);
  expectWhole([[0, 0], [6, 0], [6, 6], [0, 6], [0, 0], [2, 2], [2, 4], [4, 4], [4, 2], [2, 2]]); // biome-ignore format: short
});

test('random stars, seen from any side (seed 62)', () => {
  const random = seededRandom(62);
  for (let round = 0; round < 200; round++) {
    const count = 4 + Math.floor(30 * random());
    const star = Array.from({ length: count }, (_, k): Point => {
      const [angle, radius] = [(2 * Math.PI * k) / count, between(random, 0.1, 1)];
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
    expectWhole(round % 2 ? star : [...star].reverse());
    const u = normalize(inCube(random, 1));
    const normal = normalize(cross(u, randomDirection(random)));
    if (!(length(normal) > 0.5)) continue;
    const v = cross(normal, u);
    const points = star.map(([x, y]): Vec3 => addScaled(addScaled([5, 5, 5], u, x), v, y));
    const triangles = triangulate(count, (k, c) => points[k]![c]!);
    for (let t = 0; t < triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => points[triangles[t + k]!]!) as [Vec3, Vec3, Vec3];
      expect(dot(normal, cross(addScaled(b, a, -1), addScaled(c, a, -1)))).toBeGreaterThan(-1e-9);
    }
  }
});

test('what is no polygon gives triangles all the same: of one point, one line, or crossing itself', () => {
  for (const polygon of [
    Array.from({ length: 7 }, (): Point => [1, 1]),
    Array.from({ length: 7 }, (_, k): Point => [k, 2 * k]),
    Array.from({ length: 7 }, (_, k): Point => [Math.cos((6 * Math.PI * k) / 7), Math.sin((6 * Math.PI * k) / 7)]),
    Array.from({ length: 1000 }, (_, k): Point => [k % 3, k % 7]),
  ])
    expect(cut(polygon).triangles).toHaveLength(3 * (polygon.length - 2));
});
