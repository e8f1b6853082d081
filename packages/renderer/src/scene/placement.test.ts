import { expect, test } from 'vitest';
import { between, inCube, seededRandom } from '../../../../tests/fixtures/random.ts';
import { meshBounds, placedBounds } from './mesh-bounds.ts';
import {
  AT_HOME,
  after,
  determinant,
  fromMatrix,
  inverse,
  isSolid,
  placeDirection,
  placementOf,
  placeNormal,
  placePoint,
  toMatrix,
} from './placement.ts';
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

test('scaled, then turned about X, Y and Z, then moved', () => {
  const quarter = placementOf(shape({ translation: [10, 20, 30], rotation: [0, 90, 0], scale: [2, 3, 4] }));
  expectNear(placePoint(quarter, [1, 1, 1]), [10 + 4, 20 + 3, 30 - 2]);
  expectNear(placeDirection(quarter, [0, 0, 1]), [4, 0, 0]);
});

test('a matrix is given row by row, and comes before all else', () => {
  const matrix = [0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1];
  expectNear(placePoint(placementOf(shape({ matrix })), [1, 2, 3]), [-2 + 5, 1 + 6, 3 + 7]);
  expectNear(placePoint(placementOf(shape({ matrix, scale: [2, 2, 2] })), [1, 2, 3]), [6, 14, 20]);
  expect(toMatrix(fromMatrix(matrix))).toEqual(matrix);
  expect(toMatrix(AT_HOME)).toEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
});

test(`one after the other, and back again (seed ${seed})`, () => {
  for (let k = 0; k < 50; k++) {
    const [a, b, p] = [placementOf(anyShape()), placementOf(anyShape()), inCube(random, 3)];
    expectNear(placePoint(after(a, b), p), placePoint(a, placePoint(b, p)));
    expectNear(placePoint(inverse(a), placePoint(a, p)), p);
    expect(determinant(after(a, b))).toBeCloseTo(determinant(a) * determinant(b), 6);
  }
});

test(`normals stay across the surface and outside, mirrored or not (seed ${seed})`, () => {
  for (let k = 0; k < 50; k++) {
    const placement = placementOf(anyShape());
    const [u, v]: Vec3[] = [inCube(random, 1), inCube(random, 1)];
    const n = cross(u!, v!);
    const placed = placeNormal(inverse(placement), n);
    for (const side of [u!, v!]) expect(dot(placed, placeDirection(placement, side))).toBeCloseTo(0, 9);
    expect(dot(placed, placeDirection(placement, n))).toBeGreaterThan(0);
  }
});

test('a placement that is flat is told', () => {
  expect(isSolid(AT_HOME)).toBe(true);
  expect(isSolid({ ...AT_HOME, x: [1e-3, 0, 0], y: [0, 1e5, 0] })).toBe(true);
  expect(isSolid({ ...AT_HOME, z: [0, 0, 0] })).toBe(false);
  expect(isSolid({ ...AT_HOME, z: [1, 2, 0] })).toBe(false);
  expect(isSolid({ ...AT_HOME, z: [1, 2, 1e-7] })).toBe(false);
});

test('the box around a placed mesh', () => {
  const mesh = { positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 2, -3), indices: Uint32Array.of(0, 1, 2) };
  const bounds = meshBounds(mesh);
  expect(bounds).toEqual({ min: [0, 0, -3], max: [1, 2, 0] });
  expect(meshBounds(mesh)).toBe(bounds);
  const placed = placedBounds(bounds, placementOf(shape({ translation: [1, 1, 1], scale: [-1, 2, 1] })));
  expect(placed).toEqual({ min: [0, 1, -2], max: [1, 5, 1] });
});
