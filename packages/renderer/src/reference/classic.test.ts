import { expect, test } from 'vitest';
import { between, inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Camera, Scene, Shape, Vec3 } from '../scene/scene.ts';
import { add, dot, normalize, scale } from '../scene/vec3.ts';
import { cameraFrame, rayThrough, sampleOffset } from './camera.ts';
import { closestHit } from './cast.ts';
import { prepareClassic, tracePixel } from './classic.ts';
import { halo } from './halo.ts';
import { prepareScene } from './prepare.ts';
import { cameraRay } from './ray.ts';

const floor: Shape = { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'white' };
const onePixel = (scene: Scene, camera: Camera) =>
  tracePixel(prepareClassic(scene, { width: 1, height: 1, camera, maxReflections: 4 }), 0, 0);

test('camera: the corners of the picture lie where field of view and aspect say', () => {
  const camera: Camera = { eye: [1, 2, 3], target: [1, 2, -7], up: [0, 5, 1], verticalFov: 90 };
  const frame = cameraFrame(camera, 200, 100);
  const through = (column: number, row: number) => rayThrough(frame, column, row, 200, 100).direction;
  const expectDirection = (found: Vec3, expected: Vec3) => expect(dot(found, normalize(expected))).toBeCloseTo(1, 14);
  expectDirection(through(100, 50), [0, 0, -1]);
  expectDirection(through(0, 0), [-2, 1, -1]);
  expectDirection(through(200, 100), [2, -1, -1]);
  expect(sampleOffset(0)).toEqual([0.5, 0.5]);
  expect(sampleOffset(1)[0]).toBeCloseTo(0.2548776662466927, 15);
  expect(sampleOffset(3)[1]).toBeCloseTo(0.2095208729941596, 12);
});

test('sky: the horizon below, a blend by height above (seed 1)', () => {
  const random = seededRandom(1);
  const scene = testScene({}, {}, { sky: { horizon: [1, 0.5, 0], zenith: [0, 0.5, 3] } });
  for (let k = 0; k < 200; k++) {
    const direction = randomDirection(random);
    const up: Vec3 = Math.abs(direction[1]) > 0.9 ? [1, 0, 0] : [0, 1, 0];
    const sky = onePixel(scene, { eye: [0, 0, 0], target: direction, up, verticalFov: 50 });
    const height = Math.max(direction[1], 0);
    [1 - height, 0.5, 3 * height].forEach((value, channel) => {
      expect(sky[channel]).toBeCloseTo(value, 12);
    });
  }
});

test('each stretch of a path adds its own haze, weighted by the mirrors before it (seed 2)', () => {
  const random = seededRandom(2);
  // The light shines through the floor's back: no surface that is seen gets any of it.
  const lamp = testLight({ center: [0, -0.5, 0], radius: 0.2, radiance: 3, halo: 0.2, visible: true });
  const materials = { white: testMaterial({ reflectivity: 0.4 }) };
  const scene = testScene({ floor }, { lamp }, { materials, sky: { horizon: [1, 1, 1], zenith: [1, 1, 1] } });
  const prepared = prepareScene(scene);
  for (let k = 0; k < 100; k++) {
    const eye: Vec3 = [between(random, -3, 3), between(random, 1, 2), between(random, 1, 3)];
    const point: Vec3 = [between(random, -2, 2), 0, between(random, -2, 0)];
    const down = normalize(add(point, scale(eye, -1)));
    const first = halo(prepared, cameraRay(eye, down), eye[1] / -down[1])[0];
    const second = halo(prepared, cameraRay(point, [down[0], -down[1], down[2]]), Number.POSITIVE_INFINITY)[0];
    const found = onePixel(scene, { eye, target: point, up: [0, 1, 0], verticalFov: 50 })[0];
    expect(found).toBeCloseTo(first + 0.4 * (second + 1), 12);
    expect(Math.min(first, second)).toBeGreaterThan(0);
  }
});

test('of shapes and light balls the closest is hit; of equals the first in the order of kinds', () => {
  const at = (z: number): Vec3 => [0, 0, z];
  const shapes: Record<string, Shape> = {
    quad: { type: 'quad', corner: [-1, -1, -2], u: [2, 0, 0], v: [0, 2, 0], material: 'white' },
    plane: { type: 'plane', point: at(-2), normal: [0, 0, 1], material: 'white' },
    'second ball': { type: 'sphere', center: at(-3), radius: 1, material: 'white' },
    box: { type: 'box', center: at(-3), size: [2, 2, 2], rotation: [0, 0, 0], material: 'white' },
  };
  const ray = cameraRay([0, 0, 0], [0, 0, -1]);
  const found = (names: string[], lightAt: number) => {
    const kept = Object.fromEntries(names.map((name) => [name, shapes[name]!]));
    const lamp = testLight({ center: at(lightAt), radius: 1, visible: true });
    const { t, shape, light } = closestHit(prepareScene(testScene(kept, { lamp })), ray);
    return [t, shape?.type, light?.center[2]];
  };
  expect(found(['quad', 'plane', 'second ball', 'box'], -3)).toEqual([2, 'sphere', undefined]);
  expect(found(['quad', 'plane', 'box'], -3)).toEqual([2, undefined, -3]);
  expect(found(['quad', 'plane', 'box'], -4)).toEqual([2, 'box', undefined]);
  expect(found(['quad', 'plane'], -4)).toEqual([2, 'quad', undefined]);
  expect(found(['plane'], -4)).toEqual([2, 'plane', undefined]);
  expect(found(['quad', 'plane'], -2.5)).toEqual([1.5, undefined, -2.5]);
});

test('inside a mirror box, aimed at its edges and corners: no light from outside (seed 3)', () => {
  const random = seededRandom(3);
  const sky = { horizon: [1e6, 1e6, 1e6], zenith: [1e6, 1e6, 1e6] } as const;
  const materials = { white: testMaterial({ reflectivity: 1 }) };
  for (let k = 0; k < 2000; k++) {
    const size = 10 ** between(random, -3, 4);
    const box: Shape = {
      type: 'box',
      center: [0, 0, 0],
      size: [size, size, size],
      rotation: [0, 0, 0],
      material: 'white',
    };
    // Closer to an edge or corner than tMin: the next face is met at less than that.
    const target = inCube(random, size / 2).map((x, axis) =>
      (k >> axis) % 2 === 0 ? (Math.sign(x) * size * (1 - 10 ** between(random, -15, -5))) / 2 : x,
    ) as unknown as Vec3;
    const camera: Camera = { eye: scale(inCube(random, 0.4), size), target, up: [0.1, 1, 0.2], verticalFov: 50 };
    expect(onePixel(testScene({ box }, {}, { materials, sky }), camera)[0]).toBe(0);
  }
});

test('a shape that names no material of the scene is an error of the caller', () => {
  const stray = testScene({ floor: { ...floor, material: 'gold' } }, {});
  expect(() => prepareScene(stray)).toThrow('Shape "floor" names the missing material "gold".');
});
