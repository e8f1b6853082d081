import { describe, expect, test } from 'vitest';
import { between, inCube, type Random, seededRandom } from '../../tests/fixtures/random.ts';
import type { Matrix, Triple } from './neutral-scene.ts';
import { placeBox, placeQuad, placeSphere } from './transform.ts';

const rad = (degrees: number) => (degrees * Math.PI) / 180;
type Rows = readonly (readonly number[])[];
const times = (a: Rows, b: Rows): number[][] =>
  a.map((row) => b[0]!.map((_, c) => row.reduce((sum, x, k) => sum + x * b[k]![c]!, 0)));
const scale = (x: number, y: number, z: number): Rows => [
  [x, 0, 0],
  [0, y, 0],
  [0, 0, z],
];
/** docs/scene-file.md: about X, then Y, then Z, R = Rz·Ry·Rx. */
function turn([x, y, z]: Triple): Rows {
  const [cx, sx, cy, sy, cz, sz] = [x, y, z].flatMap((a) => [Math.cos(rad(a)), Math.sin(rad(a))]) as number[] as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const rx = [[1, 0, 0], [0, cx, -sx], [0, sx, cx]]; // biome-ignore format: a matrix
  const ry = [[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]]; // biome-ignore format: a matrix
  const rz = [[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]]; // biome-ignore format: a matrix
  return times(rz, times(ry, rx));
}
const matrix = (linear: Rows, move: Triple): Matrix =>
  [...linear.map((row, r) => [...row, move[r]!]), [0, 0, 0, 1]] as unknown as Matrix;
const apply = (m: Matrix, p: readonly number[]): number[] =>
  [0, 1, 2].map((r) => m[r]![0]! * p[0]! + m[r]![1]! * p[1]! + m[r]![2]! * p[2]! + m[r]![3]!);

const SIGNS = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z] as const)));
type Box = ReturnType<typeof placeBox>;
const cornersOf = ({ center, size, rotation }: Box): number[][] => {
  const m = matrix(turn(rotation), center);
  return SIGNS.map((s) =>
    apply(
      m,
      s.map((x, c) => (x * size[c]!) / 2),
    ),
  );
};
const distance = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((x, c) => x - b[c]!));
const away = (point: readonly number[], points: readonly number[][]) =>
  Math.min(...points.map((other) => distance(point, other)));

function randomTurn(random: Random, n: number): Triple {
  // Every third looks straight along Z after the turn about Y, where the two other angles cannot be told apart.
  const aboutY = n % 3 === 0 ? (n % 2 === 0 ? 90 : -90) : between(random, -90, 90);
  return [between(random, -180, 180), aboutY, between(random, -180, 180)];
}

test('boxes under 200 random turns, scales and mirrorings keep their corners (seed 31)', () => {
  const random = seededRandom(31);
  for (let n = 0; n < 200; n++) {
    const linear = times(turn(randomTurn(random, n)), scale(...(inCube(random, 3) as unknown as Triple)));
    const m = matrix(linear, inCube(random, 5) as Triple);
    const min = inCube(random, 2) as Triple;
    const max = min.map((x) => x + between(random, 0.1, 2)) as Triple;
    const corners = cornersOf(placeBox(min, max, m));
    for (const s of SIGNS) {
      const corner = apply(
        m,
        s.map((x, c) => (x < 0 ? min[c]! : max[c]!)),
      );
      expect(away(corner, corners), `box ${n}`).toBeLessThan(1e-9);
    }
  }
});

describe('boxes', () => {
  test('without transform keep short numbers', () =>
    expect(placeBox([-1.6, -2, -1.5], [-0.4, -1.1, -0.3])).toEqual({
      center: [-1, -1.55, -0.9],
      size: [1.2, 0.9, 1.2],
      rotation: [0, 0, 0],
    }));
  test('scaled after a turn have shear', () => {
    const sheared = matrix(times(scale(1, 2, 1), turn([30, 0, 0])), [0, 0, 0]);
    expect(() => placeBox([0, 0, 0], [1, 1, 1], sheared)).toThrow(/box under a transform with shear/);
  });
});

test('spheres move, turn and scale, but do not become ellipsoids', () => {
  const alike = matrix(times(turn([10, 20, 30]), scale(2, -2, 2)), [1, 0, 0]);
  const { center, radius } = placeSphere([0, 0, 0], 0.5, alike);
  expect(center).toEqual([1, 0, 0]);
  expect(radius).toBeCloseTo(1, 10);
  expect(() => placeSphere([0, 0, 0], 1, matrix(scale(1, 1, 2), [0, 0, 0]))).toThrow(/ellipsoid/);
});

test('quads go through any affine transform', () => {
  const m = matrix([[1, 1, 0], [0, 1, 0], [0, 0, 1]], [5, 0, 0]); // biome-ignore format: a matrix
  expect(placeQuad([0, 0, 0], [1, 0, 0], [0, 1, 0], m)).toEqual({ corner: [5, 0, 0], u: [1, 0, 0], v: [1, 1, 0] });
});

test('refuses projective transforms', () => {
  const m = [...matrix(scale(1, 1, 1), [0, 0, 0]).slice(0, 3), [0, 0, 0.1, 1]] as unknown as Matrix;
  expect(() => placeQuad([0, 0, 0], [1, 0, 0], [0, 1, 0], m)).toThrow(/projective/);
});
