import { expect, test } from 'vitest';
import { inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Vec3 } from './scene.ts';
import { add, addScaled, cross, dot, length, negate, normalize, reflect, rotate, scale, subtract } from './vec3.ts';

const X: Vec3 = [1, 0, 0];
const Y: Vec3 = [0, 1, 0];
const Z: Vec3 = [0, 0, 1];
const seed = 31;
const random = seededRandom(seed);
const triples = Array.from({ length: 20 }, () => [inCube(random, 5), inCube(random, 5), inCube(random, 5)] as const);

function expectNear(a: Vec3, b: Vec3): void {
  for (const c of [0, 1, 2] as const) expect(a[c]).toBeCloseTo(b[c], 10);
}

test('sums, differences and multiples go number by number', () => {
  expect(add([1, 2, 3], [10, 20, 30])).toEqual([11, 22, 33]);
  expect(subtract([1, 2, 3], [10, 20, 30])).toEqual([-9, -18, -27]);
  expect(scale([1, 2, 3], -2)).toEqual([-2, -4, -6]);
  expect(negate([1, -2, 3])).toEqual([-1, 2, -3]);
  expect(addScaled([1, 2, 3], [10, 20, 30], 0.5)).toEqual([6, 12, 18]);
});

test('dot and length', () => {
  expect(dot([1, 2, 3], [4, -5, 6])).toBe(12);
  expect(length([2, -3, 6])).toBe(7);
});

test('cross is right-handed', () => {
  expect([cross(X, Y), cross(Y, Z), cross(Z, X)]).toEqual([Z, X, Y]);
});

test(`u × (v × w) = v (u · w) − w (u · v) (seed ${seed})`, () => {
  for (const [u, v, w] of triples)
    expectNear(cross(u, cross(v, w)), subtract(scale(v, dot(u, w)), scale(w, dot(u, v))));
});

test(`normalize keeps the direction and makes the length 1 (seed ${seed})`, () => {
  for (const [v] of triples) {
    expect(length(normalize(v))).toBeCloseTo(1, 12);
    expectNear(scale(normalize(v), length(v)), v);
  }
});

test(`reflect turns over what lies along the normal, and nothing else (seed ${seed})`, () => {
  for (const [v] of triples) {
    const normal = randomDirection(random);
    const mirrored = reflect(v, normal);
    expect(dot(mirrored, normal)).toBeCloseTo(-dot(v, normal), 10);
    expectNear(cross(mirrored, normal), cross(v, normal));
    expectNear(reflect(v, negate(normal)), mirrored);
  }
});

test('rotate turns about X first, then Y, then Z, right-handed', () => {
  expectNear(rotate(Y, [90, 0, 0]), Z);
  expectNear(rotate(Z, [0, 90, 0]), X);
  expectNear(rotate(X, [0, 0, 90]), Y);
  expectNear(rotate(Y, [90, 90, 0]), X);
  expectNear(rotate(Y, [90, 90, 90]), Y);
});
