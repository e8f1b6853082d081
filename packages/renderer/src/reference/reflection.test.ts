import { describe, expect, test } from 'vitest';
import { between, inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Camera, Scene, Shape, Vec3 } from '../scene/scene.ts';
import { add, addScaled, dot, length, reflect, scale, subtract } from '../scene/vec3.ts';
import { closestHit, surfaceAt } from './cast.ts';
import { panelAt, prepareClassic, traceClassic, tracePixel } from './classic.ts';
import { prepareScene } from './prepare.ts';
import { cameraRay, rayLeaving } from './ray.ts';

/** Ambient light alone, 0.8 in every channel: every surface that is hit counts the same. */
const ambient = { lamp: testLight({ radiance: 0, ambient: [0.8, 0.8, 0.8] }) };
const brightSky = { horizon: [1e6, 1e6, 1e6], zenith: [1e6, 1e6, 1e6] } as const;

function mirrors(shapes: Record<string, Shape>, reflectivity: number, other = reflectivity): Scene {
  const materials = { white: testMaterial({ reflectivity }), other: testMaterial({ reflectivity: other }) };
  return testScene(shapes, ambient, { materials, sky: brightSky });
}
const plane = (y: number, material: string): Shape => ({
  type: 'plane',
  point: [0, y, 0],
  normal: [0, 1, 0],
  material,
});
const between0and1 = { below: plane(0, 'white'), above: plane(1, 'other') };
const upwards: Camera = { eye: [0, 0.4, 0], target: [0.3, 1, 0.2], up: [0, 0, 1], verticalFov: 40 };

function onePixel(scene: Scene, camera: Camera, maxReflections: number): number {
  return tracePixel(prepareClassic(scene, { width: 1, height: 1, camera, maxReflections }), 0, 0)[0];
}

describe('two parallel mirrors', () => {
  test.each([0.1, 0.5, 0.7, 0.9, 0.95])('reflectivity %f: a geometric series, 0 … 64 reflections', (r) => {
    const scene = mirrors(between0and1, r);
    // The path also ends once its weight is below 1 / 4096.
    const terms = Math.ceil(Math.log(4096) / -Math.log(r) + 1e-9);
    for (let n = 0; n <= 64; n++) {
      expect(onePixel(scene, upwards, n)).toBeCloseTo(0.8 * (1 - r ** Math.min(n + 1, terms)), 12);
    }
  });

  test('different mirrors: each weighs what comes after it', () => {
    const scene = mirrors(between0and1, 0.6, 0.9);
    let sum = 0;
    let weight = 1;
    for (let n = 0; n <= 20; n++) {
      const r = n % 2 === 0 ? 0.9 : 0.6; // the ray goes up first
      sum += weight * (1 - r) * 0.8;
      weight *= r;
      if (weight >= 1 / 4096) expect(onePixel(scene, upwards, n)).toBeCloseTo(sum, 12);
    }
  });

  test('perfect mirrors stay dark, and with none left so does what they show', () => {
    expect(onePixel(mirrors(between0and1, 1), upwards, 64)).toBe(0);
    const onePerfect = mirrors({ above: plane(1, 'white') }, 1);
    expect(onePixel(onePerfect, upwards, 0)).toBe(0);
    expect(onePixel(onePerfect, upwards, 1)).toBe(1e6);
  });
});

describe('inside closed mirrors nothing leaks', () => {
  const places = [
    { size: 1, offset: 0 },
    { size: 1e-3, offset: 0 },
    { size: 1e4, offset: 0 },
    { size: 1, offset: 1e4 },
  ];
  test.each(places)('sphere and turned box of size $size at $offset: the full series (seed 7)', ({ size, offset }) => {
    const random = seededRandom(7);
    for (let k = 0; k < 300; k++) {
      const center: Vec3 = [offset, offset, -offset];
      const rotation = k % 2 === 0 ? ([0, 0, 0] as const) : scale(inCube(random, 1), 180);
      const sides: Vec3 = [size * between(random, 0.5, 2), size, size * 1.5];
      const sphere: Shape = { type: 'sphere', center, radius: size, material: 'white' };
      const box: Shape = { type: 'box', center, size: sides, rotation, material: 'white' };
      const eye = add(center, scale(inCube(random, 0.2), size));
      const direction = randomDirection(random);
      const up: Vec3 = Math.abs(direction[1]) > 0.9 ? [1, 0, 0] : [0, 1, 0];
      const camera: Camera = { eye, target: addScaled(eye, direction, size), up, verticalFov: 30 };
      for (const shell of [sphere, box]) {
        expect(onePixel(mirrors({ shell }, 0.9), camera, 40)).toBeCloseTo(0.8 * (1 - 0.9 ** 41), 9);
      }
    }
  });

  test('whispering gallery: grazing rays go round and round on the sphere (seed 8)', () => {
    const random = seededRandom(8);
    const scene = prepareScene(
      mirrors({ shell: { type: 'sphere', center: [3, 1, 2], radius: 2, material: 'white' } }, 1),
    );
    const ball = scene.spheres[0]!;
    for (let k = 0; k < 100; k++) {
      const eye = add(ball.center, [2 - 10 ** between(random, -14, -2), 0, 0]);
      let ray = cameraRay(eye, [0, 0, 1]);
      for (let reflection = 0; reflection < 64; reflection++) {
        const { t, shape } = closestHit(scene, ray);
        expect(shape).toBe(ball);
        const hit = surfaceAt(ball, ray, t);
        expect(Math.abs(length(subtract(hit.point, ball.center)) - 2)).toBeLessThan(1e-12);
        expect(dot(hit.outwardNormal, hit.geometricNormal)).toBeLessThan(0);
        ray = rayLeaving(hit, reflect(ray.direction, hit.geometricNormal), eye);
      }
    }
  });
});

test('convex shapes never mirror themselves (seed 9)', () => {
  const random = seededRandom(9);
  for (let k = 0; k < 500; k++) {
    const size = 10 ** between(random, -3, 4);
    const sphere: Shape = { type: 'sphere', center: [0, 0, 0], radius: size, material: 'white' };
    const rotation = scale(inCube(random, 1), 180);
    const box: Shape = { type: 'box', center: [0, 0, 0], size: [size, 2 * size, size], rotation, material: 'white' };
    const eye = scale(randomDirection(random), 5 * size);
    const camera: Camera = { eye, target: scale(inCube(random, 0.5), size), up: [0.3, 1, 0.1], verticalFov: 10 };
    for (const shape of [sphere, box]) expect(onePixel(mirrors({ shape }, 1), camera, 64)).toBe(1e6);
  }
});

test('visible light balls end a path, directly and in a mirror', () => {
  const ball = testLight({ center: [0, 1, 0], radius: 0.2, radiance: 5, diffuse: [1, 0.5, 0.25], visible: true });
  const scene = testScene(
    { floor: plane(0, 'white') },
    { ball },
    { materials: { white: testMaterial({ reflectivity: 0.5 }) } },
  );
  const look = (target: Vec3) =>
    prepareClassic(scene, { width: 1, height: 1, maxReflections: 1, camera: { ...upwards, eye: [2, 1, 0], target } });
  expect(tracePixel(look([0, 1, 0]), 0, 0)).toEqual([5, 2.5, 1.25]);
  const mirrored = tracePixel(look([1, 0, 0]), 0, 0);
  const shade = (1 - 0.5) * 5 * 0.04 * (1 / 2) * Math.SQRT1_2;
  expect(mirrored[0]).toBeCloseTo(shade + 0.5 * 5, 12);
});

test('a comparison gives each panel the picture of its own settings', () => {
  const scene = mirrors(between0and1, 0.7);
  const panels = [1, 2, 10].map((maxReflections) => ({ maxReflections, lightSamples: 1 }));
  const [a, b, c] = panels as [(typeof panels)[0], (typeof panels)[0], (typeof panels)[0]];
  const size = { width: 20, height: 2, camera: upwards };
  const film = traceClassic(scene, { ...size, comparison: { panels: [a, b, c], dividers: [0.31, 0.725] } });
  const alone = panels.map(({ maxReflections }) => traceClassic(scene, { ...size, maxReflections }));
  for (let i = 0; i < 20; i++) {
    const panel = i + 0.5 < 0.31 * 20 ? 0 : i + 0.5 < 0.725 * 20 ? 1 : 2;
    expect(film[(20 + i) * 4]).toBe(alone[panel]![(20 + i) * 4]);
  }
  const closed = prepareClassic(scene, { ...size, comparison: { panels: [a, b, c], dividers: [0, 1] } });
  expect([0, 10, 19].map((i) => panelAt(closed, i))).toEqual([b, b, b]);
});
