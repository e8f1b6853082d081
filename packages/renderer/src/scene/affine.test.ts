import { expect, test } from 'vitest';
import { between, inCube, seededRandom } from '../../../../tests/fixtures/random.ts';
import {
  determinant,
  IDENTITY,
  invertAffine,
  isSolid,
  multiplyAffine,
  transformDirection,
  transformNormal,
  transformPoint,
} from './affine.ts';
import { boundsOf, meshBounds, placedBounds } from './bounds.ts';
import { placementOf } from './placed.ts';
import type { MeshShape, Vec3 } from './scene.ts';
import { cross, dot } from './vec3.ts';

const seed = 41;
const random = seededRandom(seed);
const shape = (part: Partial<MeshShape> = {}): MeshShape => ({
  type: 'mesh',
  mesh: 'it',
  material: 'white',
  translation: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
  ...part,
});
const anyShape = () =>
  shape({
    translation: inCube(random, 5),
    rotation: inCube(random, 180),
    scale: [between(random, 0.2, 2), -between(random, 0.2, 2), between(random, 0.2, 2)],
    matrix: [...inCube(random, 2), 1, ...inCube(random, 2), 2, ...inCube(random, 2), 3, 0, 0, 0, 1],
  });
const expectNear = (a: readonly number[], b: readonly number[]) =>
  a.forEach((x, k) => {
    expect(x).toBeCloseTo(b[k]!, 9);
  });

const after = (a: Float64Array, b: Float64Array): Float64Array => {
  const out = new Float64Array(12);
  multiplyAffine(out, 0, a, 0, b, 0);
  return out;
};

test('scaled, then turned about X, Y and Z, then moved', () => {
  const quarter = placementOf(shape({ translation: [10, 20, 30], rotation: [0, 90, 0], scale: [2, 3, 4] }));
  expectNear(transformPoint(quarter, 0, [1, 1, 1]), [10 + 4, 20 + 3, 30 - 2]);
  expectNear(transformDirection(quarter, 0, [0, 0, 1]), [4, 0, 0]);
});

test('a matrix is given row by row, and comes before all else', () => {
  const matrix = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1];
  expectNear(transformPoint(placementOf(shape({ matrix })), 0, [1, 2, 3]), [-2 + 5, 1 + 6, 3 + 7]);
  expectNear(transformPoint(placementOf(shape({ matrix, scale: [2, 2, 2] })), 0, [1, 2, 3]), [6, 14, 20]);
});

test(`one after the other, and back again (seed ${seed})`, () => {
  for (let k = 0; k < 50; k++) {
    const [a, b, p] = [placementOf(anyShape()), placementOf(anyShape()), inCube(random, 3)];
    expectNear(transformPoint(after(a, b), 0, p), transformPoint(a, 0, transformPoint(b, 0, p)));
    expectNear(transformPoint(invertAffine(a)!, 0, transformPoint(a, 0, p)), p);
    expect(determinant(after(a, b))).toBeCloseTo(determinant(a) * determinant(b), 6);
  }
});

test(`normals stay across the surface and outside, mirrored or not (seed ${seed})`, () => {
  for (let k = 0; k < 50; k++) {
    const placement = placementOf(anyShape());
    const [u, v]: Vec3[] = [inCube(random, 1), inCube(random, 1)];
    const n = cross(u!, v!);
    const placed = transformNormal(invertAffine(placement)!, 0, n);
    for (const side of [u!, v!]) expect(dot(placed, transformDirection(placement, 0, side))).toBeCloseTo(0, 9);
    expect(dot(placed, transformDirection(placement, 0, n))).toBeGreaterThan(0);
  }
});

test('a map that makes everything flat is told', () => {
  const withColumn = (column: number, [x, y, z]: Vec3, of = IDENTITY) =>
    of.map((value, i) => (i % 4 === column ? [x, y, z][Math.floor(i / 4)]! : value));
  expect(isSolid(IDENTITY)).toBe(true);
  expect(isSolid(withColumn(0, [1e-3, 0, 0], withColumn(1, [0, 1e5, 0])))).toBe(true);
  for (const z of [
    [0, 0, 0],
    [1, 2, 0],
    [1, 2, 1e-7],
  ] as Vec3[])
    expect(isSolid(withColumn(2, z))).toBe(false);
  expect(isSolid([...withColumn(2, [0, 0, 0]), ...IDENTITY], 12)).toBe(true);
  expect(invertAffine(withColumn(2, [0, 0, 0]))).toBeNull();
});

test('the box around a placed mesh', () => {
  const mesh = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, -3), indices: Uint32Array.of(0, 1, 2) };
  const bounds = meshBounds(mesh);
  expect(bounds).toEqual({ min: [0, 0, -3], max: [1, 2, 0] });
  expect(meshBounds(mesh)).toBe(bounds);
  const placed = placedBounds(bounds, placementOf(shape({ translation: [1, 1, 1], scale: [-1, 2, 1] })));
  expect(placed).toEqual({ min: [0, 1, -2], max: [1, 5, 1] });
  expect(boundsOf(mesh.positions, Uint8Array.of(0, 1, 1))).toEqual({ min: [0, 0, -3], max: [1, 2, 0] });
  expect(boundsOf(mesh.positions, Uint8Array.of(0, 1, 0))).toEqual({ min: [1, 0, 0], max: [1, 0, 0] });
});
