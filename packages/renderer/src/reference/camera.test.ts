import { describe, expect, test } from 'vitest';
import { inCube, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Camera, Projection, Vec3 } from '../scene/scene.ts';
import { addScaled, cross, dot, length, normalize, subtract } from '../scene/vec3.ts';
import { cameraFrame, rayThrough } from './camera.ts';
import { traceClassic } from './classic.ts';
import type { Ray } from './ray.ts';

const random = seededRandom(81);
const someCamera = (projection: Projection): Camera => {
  const [eye, target, up] = [inCube(random, 9), inCube(random, 9), inCube(random, 9)];
  return { eye, target, up, verticalFov: 20 + 100 * random(), projection, viewHeight: 0.5 + 9 * random() };
};
/** The ray at these shares of the picture's width and height, from its top left corner. */
function rayAt(camera: Camera, u: number, v: number, [width, height] = [160, 90]): Ray {
  return rayThrough(cameraFrame(camera, width!, height!), u * width!, v * height!, width!, height!);
}
const forward = ({ eye, target }: Camera) => normalize(subtract(target, eye));
const closeTo = (a: Vec3, b: Vec3) => expect(length(subtract(a, b))).toBeLessThan(1e-9);

test('orthographic: parallel rays, from a rectangle as high as viewHeight about the eye (seed 81)', () => {
  for (let k = 0; k < 50; k++) {
    const camera = someCamera('orthographic');
    closeTo(rayAt(camera, 0.5, 0.5).origin, camera.eye);
    for (const [u, v] of [
      [0, 0],
      [1, 0.2],
      [random(), random()],
    ] as [number, number][]) {
      const ray = rayAt(camera, u, v);
      closeTo(ray.direction, forward(camera));
      expect(dot(subtract(ray.origin, camera.eye), forward(camera))).toBeCloseTo(0, 9);
    }
    const upwards = subtract(rayAt(camera, 0.5, 0).origin, rayAt(camera, 0.5, 1).origin);
    const across = subtract(rayAt(camera, 1, 0.5).origin, rayAt(camera, 0, 0.5).origin);
    expect(length(upwards)).toBeCloseTo(camera.viewHeight!, 9);
    expect(length(across)).toBeCloseTo((camera.viewHeight! * 160) / 90, 9);
    expect(dot(upwards, camera.up)).toBeGreaterThan(0);
    closeTo(normalize(cross(across, upwards)), forward({ ...camera, eye: camera.target, target: camera.eye }));
  }
});

test('equirectangular: ahead in the middle, right at three quarters, up at the top, one pixel one angle (seed 81)', () => {
  for (let k = 0; k < 50; k++) {
    const camera = someCamera('equirectangular');
    const ahead = forward(camera);
    const right = normalize(cross(ahead, camera.up));
    closeTo(rayAt(camera, 0.5, 0.5).direction, ahead);
    closeTo(rayAt(camera, 0.75, 0.5).direction, right);
    closeTo(rayAt(camera, 0, 0.5).direction, addScaled([0, 0, 0], ahead, -1));
    closeTo(rayAt(camera, random(), 0).direction, cross(right, ahead));
    const [u, v] = [random(), random()];
    expect(length(rayAt(camera, u, v).direction)).toBeCloseTo(1, 12);
    closeTo(rayAt(camera, u, v).origin, camera.eye);
    const turn = dot(rayAt(camera, u, 0.5).direction, rayAt(camera, u + 0.1, 0.5).direction);
    expect(turn).toBeCloseTo(Math.cos(0.2 * Math.PI), 9);
    const lift = dot(rayAt(camera, u, 0.3).direction, rayAt(camera, u, 0.4).direction);
    expect(lift).toBeCloseTo(Math.cos(0.1 * Math.PI), 9);
  }
});

describe('closed forms', () => {
  const glowing = { ambient: [1, 1, 1], radiance: 0 } as const;
  const lamp = { type: 'sphere', center: [0, 50, 0], radius: 0.1, diffuse: [1, 1, 1], specular: [0, 0, 0] } as const;
  const lights = { lamp: { ...lamp, ...glowing, halo: 0, visible: false } };
  const materials = { white: testMaterial({ roughness: 1 }) };
  const size = { width: 200, height: 200, maxReflections: 0, lightSamples: 1 };
  const share = (camera: Camera, center: Vec3, radius: number) => {
    const ball = { type: 'sphere', center, radius, material: 'white' } as const;
    const film = traceClassic(testScene({ ball }, lights, { camera, materials }), size);
    return film.reduce((sum, value, k) => sum + (k % 4 === 0 ? value : 0), 0) / (size.width * size.height);
  };
  const view = { eye: [0, 0, 0], target: [0, 0, -1], up: [0, 1, 0], verticalFov: 60, viewHeight: 4 } as const;

  test('an orthographic ball covers π r², however far it is', () => {
    for (const distance of [1.5, 7, 400])
      expect(share({ ...view, projection: 'orthographic' }, [0.3, -0.2, -distance], 1)).toBeCloseTo(Math.PI / 16, 3);
  });

  test('from inside a half of the sphere, the panorama sees one half of it', () => {
    const camera: Camera = { ...view, projection: 'equirectangular' };
    const floor = { type: 'plane', point: [0, -1, 0], normal: [0, 1, 0], material: 'white' } as const;
    const film = traceClassic(testScene({ floor }, lights, { camera, materials }), size);
    const lit = (row: number) => film[row * size.width * 4]! > 0.5;
    expect([lit(0), lit(99), lit(100), lit(199)]).toEqual([false, false, true, true]);
  });

  test('an orthographic view that reaches below a floor shows both of its sides', () => {
    const floor = { type: 'plane', point: [0, -1, 0], normal: [0, 1, 0], material: 'white' } as const;
    // Rays that fall start between −2 and 2: those that start above the floor meet it, those below never.
    const look = (target: Vec3) => {
      const camera: Camera = { ...view, target, projection: 'orthographic' };
      const film = traceClassic(testScene({ floor }, lights, { camera, materials }), size);
      return [10, 190].map((row) => film[row * size.width * 4]! > 0.5);
    };
    expect(look([0, -0.1, -1])).toEqual([true, false]);
    expect(look([0, 0.1, -1])).toEqual([false, true]);
  });
});
