import { describe, expect, test } from 'vitest';
import { displacedSphere } from '../../../../tests/fixtures/meshes/landscapes.ts';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import { placementOf } from '../scene/placed.ts';
import type { Camera, Scene, Shape, SphereLight, Vec3 } from '../scene/scene.ts';
import { rotate, scale, subtract } from '../scene/vec3.ts';
import { type ClassicSettings, traceClassic } from './classic.ts';

/** One of each shape and more, in a closed room, so that no ray runs into the sky. */
const room: Scene = testScene(
  {
    ball: { type: 'sphere', center: [-0.6, 0.5, 0.2], radius: 0.5, material: 'mirror' },
    crate: {
      type: 'box',
      center: [0.7, 0.41, -0.4],
      size: [0.8, 0.5, 0.6],
      rotation: [20, 35, -15],
      material: 'gloss',
    },
    floor: { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'gloss' },
    panel: { type: 'quad', corner: [-1.6, 0.2, -1.5], u: [0.9, 0.1, 0.4], v: [-0.1, 1.2, 0.2], material: 'blue' },
    stone: {
      type: 'mesh',
      mesh: 'rock',
      translation: [0.1, 0.3, 0.9],
      rotation: [10, 70, -30],
      scale: [0.4, 0.25, 0.3],
      material: 'gloss',
    },
    shell: { type: 'box', center: [0, 1.9, 0], size: [5, 4, 7], rotation: [0, 0, 0], material: 'blue' },
  },
  {
    lamp: testLight({
      center: [0.9, 2.5, 1.1],
      radius: 0.4,
      radiance: 15,
      specular: [1, 1, 1],
      halo: 0.05,
      visible: true,
    }),
    bulb: testLight({
      center: [-1.2, 1.6, -0.7],
      radius: 0.1,
      radiance: 90,
      diffuse: [1, 0.6, 0.3],
      ambient: [0.1, 0.1, 0.1],
    }),
  },
  {
    camera: { eye: [0.3, 1.3, 3], target: [0.1, 0.7, -0.2], up: [0.1, 1, 0], verticalFov: 55 },
    materials: {
      mirror: testMaterial({ reflectivity: 0.8, specular: 0.5, roughness: 0.3 }),
      gloss: testMaterial({ baseColor: [0.7, 0.6, 0.4], reflectivity: 0.3 }),
      blue: testMaterial({ baseColor: [0.2, 0.4, 0.8], specular: 0.2, roughness: 0.6 }),
    },
    meshes: { rock: { data: displacedSphere({ triangles: 300 }) } },
    sky: { horizon: [9, 9, 9], zenith: [9, 9, 9] },
  },
);

/** A similarity of space: how it moves points, directions with length, and lengths; and how it turns a box. */
interface Similarity {
  point: (p: Vec3) => Vec3;
  vector: (v: Vec3) => Vec3;
  factor: number;
  rotation: (degrees: Vec3) => Vec3;
}

function moveShape(shape: Shape, { point, vector, factor, rotation }: Similarity): Shape {
  switch (shape.type) {
    case 'sphere':
      return { ...shape, center: point(shape.center), radius: shape.radius * factor };
    case 'box':
      return {
        ...shape,
        center: point(shape.center),
        size: scale(shape.size, factor),
        rotation: rotation(shape.rotation),
      };
    case 'plane':
      return { ...shape, point: point(shape.point), normal: vector(shape.normal) };
    case 'quad':
      return { ...shape, corner: point(shape.corner), u: vector(shape.u), v: vector(shape.v) };
    case 'mesh': {
      const m = placementOf(shape);
      const column = (c: number): Vec3 => [m[c]!, m[4 + c]!, m[8 + c]!];
      const moved = [...[0, 1, 2].map((c) => vector(column(c))), point(column(3))];
      const matrix = [0, 1, 2].flatMap((row) => moved.map((c) => c[row]!)).concat(0, 0, 0, 1);
      return { ...shape, translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1], matrix };
    }
  }
}
const moveLight = (light: SphereLight, { point, factor }: Similarity): SphereLight => ({
  ...light,
  center: point(light.center),
  radius: light.radius * factor,
  halo: light.halo / factor,
});
const moveCamera = (camera: Camera, { point, vector }: Similarity): Camera => ({
  ...camera,
  eye: point(camera.eye),
  target: point(camera.target),
  up: vector(camera.up),
});
const mapValues = <T>(record: Readonly<Record<string, T>>, f: (value: T) => T): Record<string, T> =>
  Object.fromEntries(Object.entries(record).map(([name, value]) => [name, f(value)]));

const move = (scene: Scene, by: Similarity): Scene => ({
  ...scene,
  camera: moveCamera(scene.camera, by),
  shapes: mapValues(scene.shapes, (shape) => moveShape(shape, by)),
  lights: mapValues(scene.lights as Record<string, SphereLight>, (light) => moveLight(light, by)),
});

const settings: ClassicSettings = { width: 40, height: 32, maxReflections: 5, lightSamples: 16, seed: 3 };

function expectSamePicture(a: Float64Array, b: Float64Array, tolerance: number): void {
  const worst = a.reduce((most, x, k) => Math.max(most, Math.abs(x - b[k]!)), 0);
  expect(worst).toBeLessThan(tolerance);
}
function flipped(film: Float64Array, width: number): Float64Array {
  return film.map((_, k) => {
    const pixel = Math.floor(k / 4);
    const i = pixel % width;
    return film[(pixel - i + width - 1 - i) * 4 + (k % 4)]!;
  });
}

/** Euler angles of Rz·Ry·Rx, read off the turned axes. */
function anglesOf(turn: (v: Vec3) => Vec3): Vec3 {
  const [x, y, z] = [turn([1, 0, 0]), turn([0, 1, 0]), turn([0, 0, 1])];
  return scale([Math.atan2(y[2], z[2]), Math.asin(-x[2]), Math.atan2(x[1], x[0])], 180 / Math.PI);
}

describe('the picture moves with the scene', () => {
  const film = traceClassic(room, settings);
  const same = { vector: (v: Vec3) => v, rotation: (d: Vec3) => d };

  test('it shows something', () => {
    expect(Math.max(...film)).toBeGreaterThan(1);
    expect(film.every((x) => x >= 0 && x <= 60)).toBe(true);
  });

  test.each([1e-3, 0.37, 1e4])('scaled by %f: radiance stays, haze is thinner by as much', (factor) => {
    const scaled = { ...same, factor, point: (p: Vec3) => scale(p, factor), vector: (v: Vec3) => scale(v, factor) };
    expectSamePicture(traceClassic(move(room, scaled), settings), film, 1e-9);
  });

  test.each([
    [1e4, 0, 0],
    [1e4, -1e4, 3e3],
    [0.1, 0.2, 0.3],
  ] as Vec3[])('moved by %f, %f, %f', (...by) => {
    const moved = { ...same, factor: 1, point: (p: Vec3) => subtract(p, by) };
    expectSamePicture(traceClassic(move(room, moved), settings), film, 1e-7);
  });

  test.each([
    [0, 90, 0],
    [0, 25, 0],
    [40, -70, 110],
  ] as Vec3[])('turned by %f, %f, %f degrees', (...by) => {
    // The lattice of sample points does not turn with the scene: one sample point, the centre.
    const turn = (v: Vec3) => rotate(v, by);
    const turned = { point: turn, vector: turn, factor: 1, rotation: (d: Vec3) => anglesOf((v) => turn(rotate(v, d))) };
    const one = { ...settings, lightSamples: 1 };
    expectSamePicture(traceClassic(move(room, turned), one), traceClassic(room, one), 1e-9);
  });

  test.each([1, 9])('mirrored left to right, %i light samples', (lightSamples) => {
    const flip = ([x, y, z]: Vec3): Vec3 => [-x, y, z];
    const mirrored = { point: flip, vector: flip, factor: 1, rotation: ([x, y, z]: Vec3): Vec3 => [x, -y, -z] };
    const fixed = { ...settings, lightSamples };
    expectSamePicture(flipped(traceClassic(move(room, mirrored), fixed), 40), traceClassic(room, fixed), 1e-9);
  });
});

test('another seed gives other noise around the same mean; the same seed the same film', () => {
  const film = (seed: number) => traceClassic(room, { ...settings, seed });
  const mean = (f: Float64Array) => f.reduce((a, b) => a + b) / f.length;
  expect(film(3)).toEqual(film(3));
  expect(film(4)).not.toEqual(film(3));
  expect(mean(film(4)) / mean(film(3))).toBeCloseTo(1, 2);
});

test('film samples taken in two parts are those taken at once', () => {
  const part = (firstSample: number, sampleCount: number) =>
    traceClassic(room, { ...settings, width: 12, height: 8, firstSample, sampleCount });
  const [whole, first, second] = [part(0, 4), part(0, 1), part(1, 3)];
  expectSamePicture(
    whole,
    first.map((x, k) => (k % 4 === 3 ? 4 : (x + 3 * second[k]!) / 4)),
    1e-12,
  );
});
