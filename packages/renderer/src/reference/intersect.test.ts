import { describe, expect, test } from 'vitest';
import {
  between,
  inCube,
  pick,
  type Random,
  randomDirection,
  seededRandom,
} from '../../../../tests/fixtures/random.ts';
import { testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Shape, Vec3 } from '../scene/scene.ts';
import { add, addScaled, cross, dot, length, normalize, scale, subtract } from '../scene/vec3.ts';
import { intersectBox, intersectPlane, intersectQuad, intersectSphere, outwardNormal } from './intersect.ts';
import { type PreparedAnalytic, type PreparedBox, prepareScene } from './prepare.ts';
import { cameraRay, type Ray, rayLeaving } from './ray.ts';

const RAYS = 10_000;
/** Sizes and places from very small to far away. Rounding may move a hit by some 1e-15 of the numbers involved. */
const SETTINGS = [
  { size: 1, offset: 0 },
  { size: 1e-3, offset: 0 },
  { size: 1, offset: 1e4 },
  { size: 1e-3, offset: 1e4 },
  { size: 1e4, offset: 0 },
];
const roundingOf = ({ size, offset }: { size: number; offset: number }) => 4e-15 * (size + offset);

function prepared(shape: Shape): PreparedAnalytic {
  const scene = prepareScene(testScene({ it: shape }, {}, { materials: { white: testMaterial() } }));
  return [...scene.spheres, ...scene.boxes, ...scene.planes, ...scene.quads][0]!;
}
function intersect(shape: PreparedAnalytic, ray: Ray): number {
  if (shape.type === 'sphere') return intersectSphere(shape, ray);
  if (shape.type === 'box') return intersectBox(shape, ray);
  return shape.type === 'plane' ? intersectPlane(shape, ray) : intersectQuad(shape, ray);
}
/** How much the hit point lies off the true one for each unit that rounding shifts the ray sideways. */
const slant = (direction: Vec3, normal: Vec3) => 1 / Math.abs(dot(direction, normal));

/** As `expect`, but quick enough for some 10⁵ cases. */
function ensure(holds: boolean, otherwise: string): void {
  if (!holds) expect.fail(otherwise);
}
function expectMiss(shape: PreparedAnalytic, ray: Ray): void {
  const t = intersect(shape, ray);
  ensure(t === Infinity, `hit at ${t} and not missed`);
}
function expectHit(shape: PreparedAnalytic, ray: Ray, t: number, normal: Vec3, tolerance: number): void {
  const found = intersect(shape, ray);
  ensure(Math.abs(found - t) <= tolerance, `hit at ${found} and not ${t}`);
  const n = outwardNormal(shape, ray, found);
  ensure(Math.abs(length(n) - 1) < 1e-12, `normal of length ${length(n)}`);
  ensure(dot(n, normal) > 1 - 1e-4, `normal ${n} and not ${normal}`);
}

describe('sphere', () => {
  test.each(SETTINGS)('aimed at a known point: size $size at $offset (seed 11)', (setting) => {
    const { size, offset } = setting;
    const random = seededRandom(11);
    for (let k = 0; k < RAYS; k++) {
      const center = add([offset, -offset, offset], inCube(random, size));
      const radius = size * between(random, 0.1, 2);
      const sphere = prepared({ type: 'sphere', center, radius, material: 'white' });
      const normal = randomDirection(random);
      const direction = randomDirection(random);
      const cosine = dot(direction, normal);
      if (Math.abs(cosine) < 0.02) continue;
      const back = size * between(random, 0.01, 5);
      const ray = cameraRay(addScaled(addScaled(center, normal, radius), direction, -back), direction);
      // The chord that ends in a point of exit is 2·r·cos long; from further back the ray meets its other end first.
      const chord = 2 * radius * cosine;
      const exitsOnly = cosine > 0 && back < chord;
      const t = cosine > 0 && !exitsOnly ? back - chord : back;
      const tolerance = roundingOf(setting) * slant(direction, normal);
      if (Math.abs(back - chord) < 2 * tolerance) continue;
      const atEntry = cosine > 0 && !exitsOnly ? addScaled(normal, direction, -2 * cosine) : normal;
      expectHit(sphere, ray, t, atEntry, tolerance);
    }
  });

  test('misses what passes outside, and what lies behind (seed 12)', () => {
    const random = seededRandom(12);
    for (let k = 0; k < RAYS; k++) {
      const direction = randomDirection(random);
      const aside = normalize(cross(direction, add(direction, inCube(random, 1))));
      const sphere = prepared({ type: 'sphere', center: inCube(random, 3), radius: 1, material: 'white' });
      if (sphere.type !== 'sphere') throw new Error('unreachable');
      const along = between(random, -10, 10);
      const besides = addScaled(addScaled(sphere.center, aside, 1 + 1e-9), direction, along);
      expectMiss(sphere, cameraRay(besides, direction));
      const behind = addScaled(sphere.center, direction, between(random, 1 + 1e-9, 10));
      expectMiss(sphere, cameraRay(behind, direction));
    }
  });
});

test('a grazing ray into a sphere meets its far side, though rounding has put the start outside', () => {
  const sphere = prepared({ type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' });
  const ray = rayLeaving(
    { shape: sphere, point: [1 + 1e-15, 0, 0], outwardNormal: [1, 0, 0], triangle: -1 },
    normalize([-1e-9, 1, 0]),
    [0, 0, 0],
  );
  expect(ray.inward).toBe(true);
  expect(intersect(sphere, ray)).toBeLessThan(1e-8);
});

/** Where a ray crosses the surface of a box: each face on its own as a rectangle in space. */
function boxFaces(box: PreparedBox, ray: Ray, slack: number): { t: number; normal: Vec3 }[] {
  const crossings: { t: number; normal: Vec3 }[] = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const side of [-1, 1]) {
      const normal = scale(box.axes[axis]!, side);
      const middle = addScaled(box.center, normal, box.halfSize[axis]!);
      const t = dot(subtract(middle, ray.origin), normal) / dot(ray.direction, normal);
      const p = subtract(addScaled(ray.origin, ray.direction, t), box.center);
      const within = [1, 2].every((next) => {
        const other = (axis + next) % 3;
        return Math.abs(dot(p, box.axes[other]!)) <= box.halfSize[other]! + slack;
      });
      if (t > 0 && t < Infinity && within) crossings.push({ t, normal });
    }
  }
  return crossings.sort((a, b) => a.t - b.t);
}

function randomBox(random: Random, size: number, offset: number): PreparedBox {
  const rotation = random() < 0.5 ? ([0, 0, 0] as const) : scale(inCube(random, 1), 180);
  const box = prepared({
    type: 'box',
    center: add([offset, offset, -offset], inCube(random, size)),
    size: [size * between(random, 0.1, 2), size * between(random, 0.1, 2), size * between(random, 0.1, 2)],
    rotation,
    material: 'white',
  });
  if (box.type !== 'box') throw new Error('unreachable');
  return box;
}

/** The point of the box with these coordinates, −1 … 1 from face to face. */
const inBox = (box: PreparedBox, at: Vec3): Vec3 =>
  [0, 1, 2].reduce<Vec3>((p, axis) => addScaled(p, box.axes[axis]!, at[axis]! * box.halfSize[axis]!), box.center);

describe('box', () => {
  test.each(SETTINGS)('equals six rectangles by brute force: size $size at $offset (seed 21)', (setting) => {
    const { size, offset } = setting;
    const random = seededRandom(21);
    let hits = 0;
    for (let k = 0; k < RAYS; k++) {
      const box = randomBox(random, size, offset);
      const ray = cameraRay(inBox(box, inCube(random, pick(random, [0.9, 3]))), randomDirection(random));
      const slack = roundingOf(setting) * 100;
      const strict = boxFaces(box, ray, -slack);
      const loose = boxFaces(box, ray, slack);
      if (strict.length !== loose.length) continue; // within rounding of an edge
      const first = strict[0];
      if (first === undefined) {
        expectMiss(box, ray);
        continue;
      }
      hits++;
      expectHit(box, ray, first.t, first.normal, roundingOf(setting) * 4 * slant(ray.direction, first.normal));
    }
    expect(hits).toBeGreaterThan(RAYS / 2);
  });

  test.each(SETTINGS)('has no gap on edges and corners: size $size at $offset (seed 22)', (setting) => {
    const random = seededRandom(22);
    for (let k = 0; k < RAYS; k++) {
      const box = randomBox(random, setting.size, setting.offset);
      // On a corner, or an edge, with the outward normals of the faces that meet there.
      const sides = [0, 1, 2].map(() => pick(random, [-1, 1]));
      if (random() < 0.5) sides[Math.floor(random() * 3)] = 0;
      const free = between(random, -1, 1);
      const normals = sides.flatMap((side, axis) => (side === 0 ? [] : [scale(box.axes[axis]!, side)]));
      const direction = randomDirection(random);
      if (normals.some((n) => dot(n, direction) > -0.05)) continue;
      const point = inBox(box, sides.map((side) => (side === 0 ? free : side)) as unknown as Vec3);
      const back = setting.size * between(random, 0.1, 5);
      const ray = cameraRay(addScaled(point, direction, -back), direction);
      const t = intersectBox(box, ray);
      ensure(Math.abs(t - back) < roundingOf(setting) * 100, `hit at ${t} and not ${back}`);
      const n = outwardNormal(box, ray, t);
      ensure(Math.max(...normals.map((face) => dot(face, n))) > 1 - 1e-12, `normal ${n} of no face that meets there`);
    }
  });
});

describe('plane', () => {
  test.each(SETTINGS)('hit point lies in the plane: size $size at $offset (seed 31)', (setting) => {
    const { size, offset } = setting;
    const random = seededRandom(31);
    for (let k = 0; k < RAYS; k++) {
      const point: Vec3 = add([offset, offset, offset], inCube(random, size));
      const normal = randomDirection(random);
      const plane = prepared({
        type: 'plane',
        point,
        normal: scale(normal, between(random, 0.1, 9)),
        material: 'white',
      });
      const aside = cross(normal, inCube(random, size));
      const direction = randomDirection(random);
      const t = size * between(random, -1, 5);
      const ray = cameraRay(addScaled(add(point, aside), direction, -t), direction);
      const tolerance = roundingOf(setting) * slant(direction, normal);
      if (Math.abs(dot(direction, normal)) < 1e-3 || Math.abs(t) < tolerance) continue;
      if (t < 0) expectMiss(plane, ray);
      else expectHit(plane, ray, t, normal, tolerance);
    }
  });

  test('a ray within or along the plane does not meet it', () => {
    const plane = prepared({ type: 'plane', point: [0, 0, 0], normal: [0, 2, 0], material: 'white' });
    expect(intersect(plane, cameraRay([1, 0, 0], [1, 0, 0]))).toBe(Infinity);
    expect(intersect(plane, cameraRay([1, 1, 0], [1, 0, 0]))).toBe(Infinity);
  });
});

describe('quad', () => {
  test.each(SETTINGS)('hit exactly where s and t are in 0 … 1: size $size at $offset (seed 41)', (setting) => {
    const { size, offset } = setting;
    const random = seededRandom(41);
    let hits = 0;
    for (let k = 0; k < RAYS; k++) {
      const corner = add([-offset, offset, offset], inCube(random, size));
      const u = inCube(random, size);
      const v = inCube(random, size);
      const normal = normalize(cross(u, v));
      const skew = length(cross(u, v)) / (length(u) * length(v));
      const direction = randomDirection(random);
      if (!(skew > 0.1) || Math.min(length(u), length(v)) < 0.1 * size) continue;
      if (Math.abs(dot(direction, normal)) < 0.02) continue;
      const [s, t] = [between(random, -0.5, 1.5), between(random, -0.5, 1.5)];
      const aim = addScaled(addScaled(corner, u, s), v, t);
      const quad = prepared({ type: 'quad', corner, u, v, material: 'white' });
      const back = size * between(random, 0.1, 5);
      const ray = cameraRay(addScaled(aim, direction, -back), direction);
      const tolerance = roundingOf(setting) * slant(direction, normal);
      const edgeBand = (100 * tolerance) / size;
      if ([s, t].some((x) => Math.abs(x) < edgeBand || Math.abs(x - 1) < edgeBand)) continue;
      if (s > 0 && s < 1 && t > 0 && t < 1) {
        hits++;
        expectHit(quad, ray, back, normal, tolerance);
      } else expectMiss(quad, ray);
    }
    expect(hits).toBeGreaterThan(RAYS / 8);
  });

  test('edges and corners belong to it', () => {
    const quad = prepared({ type: 'quad', corner: [0, 0, 0], u: [1, 0, 0], v: [0, 0, 1], material: 'white' });
    for (const [x, z] of [
      [0, 0],
      [1, 0],
      [0, 1],
      [1, 1],
      [0.5, 0],
      [1, 0.5],
    ] as const) {
      expect(intersect(quad, cameraRay([x, 1, z], [0, -1, 0]))).toBe(1);
      expect(intersect(quad, cameraRay([x, -1, z], [0, 1, 0]))).toBe(1);
    }
  });
});
