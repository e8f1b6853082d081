import { describe, expect, test } from 'vitest';
import { between, inCube, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Light, Plane, Shape, Vec3 } from '../scene/scene.ts';
import { add, cross, dot, length, rotate, scale, subtract } from '../scene/vec3.ts';
import { fieldOffset, TABLE_WIDTH, type TableStruct, tableColumn } from './layout.ts';
import { eulerQuaternion, type PackedScene, packScene } from './pack-scene.ts';

const material = 'white';
const sphere = (center: Vec3, radius = 1): Shape => ({ type: 'sphere', center, radius, material });
const box = (center: Vec3, size: Vec3, rotation: Vec3 = [0, 0, 0]): Shape => ({
  type: 'box',
  center,
  size,
  rotation,
  material,
});
const plane = (point: Vec3, normal: Vec3): Plane => ({ type: 'plane', point, normal, material });
const quad = (corner: Vec3, u: Vec3, v: Vec3): Shape => ({ type: 'quad', corner, u, v, material });

/** Numbers of a row of the table, from the field on. */
function numbers<S extends TableStruct>(
  packed: PackedScene,
  row: number,
  name: S,
  field: Parameters<typeof fieldOffset<S>>[1],
  count: number,
): number[] {
  const start = (row * TABLE_WIDTH + tableColumn(name)) * 4 + fieldOffset(name, field) / 4;
  return Array.from(packed.table.f32.subarray(start, start + count));
}
const vector = (...at: [PackedScene, number, TableStruct, never]) => numbers(...at, 3) as unknown as Vec3;
const center = (packed: PackedScene, row: number) => vector(packed, row, 'Bounds', 'center' as never);

test('shapes are sorted by kind and keep the order of the file within a kind', () => {
  const shapes = {
    p: plane([0, 0, 0], [0, 1, 0]),
    q: quad([0, 0, 0], [1, 0, 0], [0, 1, 0]),
    b: box([0, 0, 0], [1, 1, 1]),
    s: sphere([0, 0, 0]),
    b2: box([0, 0, 0], [1, 1, 1]),
    s2: sphere([0, 0, 0]),
  };
  const packed = packScene(testScene(shapes, { a: testLight({ center: [0, -1, 0] }) }), [0, 1, 0]);
  expect(packed.shapeNames).toEqual(['s', 's2', 'b', 'b2', 'q', 'p']);
  expect(packed.shapeEnds).toEqual([2, 4, 5, 6]);
  expect(packed.occluderEnd).toBe(6);
  expect(packed.lightCount).toBe(1);
  expect(packed.rows).toBe(6);
});

test('a plane through where the camera may start has no side of the eye, and may cast shadows', () => {
  const floor = testScene({ floor: plane([0, 0, 0], [0, 2, 0]) }, { a: testLight({ center: [0, 5, 0] }) });
  const pack = (up: Vec3) => packScene(floor, [0, 1, 0], { reach: { right: [3, 0, 0], up } });
  for (const [up, cut] of [
    [[0, 0.9, 0], false],
    [[0, -1.1, 0], true],
    [[0, 0, 9], false],
  ] as [Vec3, boolean][]) {
    const packed = pack(up);
    expect([packed.planesCutView, packed.occluderEnd]).toEqual([cut, cut ? 1 : 0]);
  }
  const throughEye = packScene(floor, [0, 0, 0]);
  expect(throughEye.planesCutView, 'a pinhole in the plane').toBe(false);
});

test('an empty scene and one of lights only are packed too', () => {
  const empty = packScene(testScene({}, {}), [0, 0, 0]);
  expect([empty.rows, empty.lightCount, ...empty.shapeEnds, empty.occluderEnd]).toEqual([1, 0, 0, 0, 0, 0, 0]);
  expect(packScene(testScene({}, { a: testLight(), b: testLight(), c: testLight() }), [0, 0, 0]).rows).toBe(3);
});

test('far from the origin positions keep the precision of what is near the eye (seed 51)', () => {
  const random = seededRandom(51);
  for (let k = 0; k < 200; k++) {
    const eye = inCube(random, 1e4);
    const near = inCube(random, 1e-2);
    const normal = inCube(random, 1);
    const shapes = { s: sphere(add(eye, near)), p: plane(add(eye, near), normal) };
    const packed = packScene(testScene(shapes, { l: testLight({ center: add(eye, near) }) }), eye);
    // Doubles hold eye + near up to 2e-12; 32-bit floats of 1e4 would be off by 5e-4.
    expect(length(subtract(center(packed, 0), near))).toBeLessThan(1e-8);
    expect(length(subtract(vector(packed, 0, 'Light', 'center' as never), near))).toBeLessThan(1e-8);
    const [offset] = numbers(packed, 1, 'Bounds', 'radius', 1);
    expect(offset! - dot(normal, near) / length(normal)).toBeCloseTo(0, 8);
  }
});

describe('what is packed of a shape', () => {
  test('box: half size, bounding sphere, and the rotation from world to box as Rz·Ry·Rx inverted (seed 52)', () => {
    const random = seededRandom(52);
    for (let k = 0; k < 200; k++) {
      const degrees = inCube(random, 360);
      const size: Vec3 = [between(random, 1, 2), between(random, 1, 2), between(random, 1, 2)];
      const packed = packScene(testScene({ b: box([0, 0, 0], size, degrees) }, {}), [0, 0, 0]);
      expect(numbers(packed, 0, 'Bounds', 'radius', 1)[0]).toBeCloseTo(length(size) / 2, 6);
      expect(length(subtract(vector(packed, 0, 'Extent', 'b' as never), scale(size, 0.5)))).toBeLessThan(1e-6);
      const [x, y, z, w] = numbers(packed, 0, 'Extent', 'a', 4) as [number, number, number, number];
      const v = inCube(random, 1);
      const turned = rotate(v, degrees);
      const t = scale(cross([x, y, z], turned), 2);
      const back = add(add(turned, scale(t, w)), cross([x, y, z], t));
      expect(length(subtract(back, v))).toBeLessThan(2e-6);
    }
  });

  test('no rotation is exactly none; the smallest one is not', () => {
    expect(eulerQuaternion([0, 0, 0])).toEqual([0, 0, 0, 1]);
    const packed = packScene(testScene({ b: box([0, 0, 0], [1, 1, 1], [0, 0.01, 0]) }, {}), [0, 0, 0]);
    // Its cosine rounds to 1, so that a kernel must not ask that.
    expect(numbers(packed, 0, 'Extent', 'a', 4)[3]).toBe(1);
    expect(numbers(packed, 0, 'Extent', 'a', 4)[1]).not.toBe(0);
  });

  test('quad: reciprocal edges, its middle, and a sphere that holds its corners (seed 53)', () => {
    const random = seededRandom(53);
    for (let k = 0; k < 200; k++) {
      const [corner, u, v] = [inCube(random, 2), inCube(random, 1), inCube(random, 1)];
      if (length(cross(u, v)) < 0.1) continue;
      const packed = packScene(testScene({ q: quad(corner, u, v) }, {}), [0, 0, 0]);
      const a = vector(packed, 0, 'Extent', 'a' as never);
      const b = vector(packed, 0, 'Extent', 'b' as never);
      expect([dot(a, u), dot(a, v), dot(b, u), dot(b, v)].map((x) => Math.round(x * 1e4) / 1e4 + 0)).toEqual([
        1, 0, 0, 1,
      ]);
      const [radius] = numbers(packed, 0, 'Bounds', 'radius', 1);
      for (const p of [corner, add(corner, u), add(corner, v), add(corner, add(u, v))])
        expect(length(subtract(p, center(packed, 0)))).toBeLessThan(radius! * (1 + 1e-6));
    }
  });

  test('material and light: the constants that the kernels need', () => {
    const light = testLight({ radiance: 3, radius: 2, halo: 0.5, visible: true });
    const unseen = testLight({ radiance: 3, radius: 2, halo: 0.5, visible: false });
    const materials = { white: testMaterial({ roughness: 0.01 }), matt: testMaterial({ roughness: 1 }) };
    const shapes = { s: sphere([0, 0, 0]), t: { ...sphere([0, 0, 0]), material: 'matt' } };
    const packed = packScene(testScene(shapes, { light, unseen }, { materials }), [0, 0, 0]);
    expect(numbers(packed, 0, 'Material', 'exponent', 1)[0]).toBeCloseTo(2 / 0.05 ** 4 - 2, 1);
    expect(numbers(packed, 1, 'Material', 'exponent', 1)[0]).toBe(0);
    expect(numbers(packed, 0, 'Light', 'power', 1)).toEqual([12]);
    expect([packed.lightCount, packed.ballCount, packed.rows], 'a row for the ball that is seen').toEqual([2, 1, 3]);
    expect(numbers(packed, 2, 'Bounds', 'radius', 1), 'where rays look for a sphere').toEqual([2]);
    expect(numbers(packed, 2, 'Ball', 'halo', 1)).toEqual([6]);
    expect(numbers(packed, 2, 'Ball', 'radiance', 1)).toEqual([3]);
  });
});

describe('planes that cannot cast a shadow stand behind those that can', () => {
  const floor = plane([0, 0, 0], [0, 3, 0]);
  const occluders = (p: Plane, lights: Record<string, Light>, eye: Vec3) =>
    packScene(testScene({ p }, lights), eye).occluderEnd;
  const above = testLight({ center: [0, 2, 0], radius: 0.5 });

  test.each<[string, number, Light[], Vec3, Plane?]>([
    ['eye and light above', 0, [above], [0, 1, 0]],
    ['the same with the normal downwards', 0, [above], [0, 1, 0], plane([0, 0, 0], [0, -1, 0])],
    ['no light at all', 0, [], [0, 1, 0]],
    ['the light below', 1, [testLight({ center: [0, -2, 0] })], [0, 1, 0]],
    ['one of two lights below', 1, [above, testLight({ center: [0, -2, 0] })], [0, 1, 0]],
    ['a light whose ball reaches through', 1, [testLight({ center: [0, 0.4, 0], radius: 0.5 })], [0, 1, 0]],
    ['the eye below', 1, [above], [0, -1, 0]],
    ['the eye exactly in the plane', 1, [above], [5, 0, 5]],
  ])('%s: %i casts', (_, casts, lights, eye, p = floor) => {
    expect(occluders(p, Object.fromEntries(lights.map((light, k) => [`${k}`, light])), eye)).toBe(casts);
  });

  test('they change places, and with them their names', () => {
    const shapes = { walled: floor, ceiling: plane([0, 1.5, 0], [0, 1, 0]), b: sphere([0, 0, 0]) };
    const packed = packScene(testScene(shapes, { above }), [0, 1, 0]);
    expect(packed.shapeNames).toEqual(['b', 'ceiling', 'walled']);
    expect(packed.occluderEnd).toBe(2);
  });
});

test('memory is used again when it is large enough, and only then', () => {
  const three = testScene({ a: sphere([1, 0, 0]), b: sphere([2, 0, 0]), c: sphere([3, 0, 0]) }, {});
  const one = testScene({ z: sphere([9, 0, 0]) }, {});
  const large = packScene(three, [0, 0, 0]);
  const again = packScene(one, [0, 0, 0], { reuse: large });
  expect(again.table).toBe(large.table);
  expect(center(again, 0)).toEqual([9, 0, 0]);
  expect(again.rows).toBe(1);
  const small = packScene(one, [0, 0, 0]);
  expect(packScene(three, [0, 0, 0], { reuse: small }).table).not.toBe(small.table);
  // What lay there before does not show through.
  const mixed = packScene(testScene({ q: quad([0, 0, 0], [1, 0, 0], [0, 2, 0]) }, {}), [0, 0, 0], { reuse: large });
  expect(numbers(mixed, 0, 'Extent', 'a', 4)).toEqual([1, 0, 0, 0]);
});
