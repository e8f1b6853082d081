import { expect, test } from 'vitest';
import { aovScene } from '../../../../tests/fixtures/aov-scene.ts';
import { testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import { aovIds } from '../integrator/aov/aov-ids.ts';
import type { Scene } from '../scene/scene.ts';
import { AOV_NAMES, AOVS, directSettings, FAR, type FirstHitAov, firstHitAov } from './aovs.ts';
import type { FilmJob } from './film-tracer.ts';
import { addReferenceSample, referenceRows } from './reference-film.ts';

/** A wall far from the origin, a mirror ball before it, the sky beside it; the camera looks along −z. */
const wall: Scene = testScene(
  {
    ball: { type: 'sphere', center: [1e5, 0, 7], radius: 1, material: 'mirror' },
    wall: { type: 'quad', corner: [1e5 - 2, -20, 0], u: [22, 0, 0], v: [0, 40, 0], material: 'red' },
  },
  {},
  {
    camera: { eye: [1e5, 0, 10], target: [1e5, 0, 0], up: [0, 1, 0], verticalFov: 60 },
    materials: { red: testMaterial({ baseColor: [0.7, 0.1, 0.1] }), mirror: testMaterial({ reflectivity: 1 }) },
  },
);
const [WIDTH, HEIGHT] = [17, 9];
const settings = { integrator: 'path', maxDepth: -1, maxReflections: 0, lightSamples: 1, seed: 3 } as const;

function aov(name: FirstHitAov, scene: Scene, samples = 1): Float32Array {
  const area = { x: 0, y: 0, width: WIDTH, height: HEIGHT };
  const content = AOVS[name].source;
  const job: FilmJob = { scene, settings, width: WIDTH, height: HEIGHT, area, content };
  const rows = referenceRows(job);
  const film = new Float32Array(WIDTH * HEIGHT * 8);
  for (let s = 0; s < samples; s++) addReferenceSample(film, rows(s, 0, HEIGHT), job);
  return firstHitAov(name, film, scene, 'path');
}
const middle = Math.floor((WIDTH * HEIGHT) / 2);
const right = middle + 6;
const left = middle - 8;

test('depth runs along the view axis: a wall across it is equally deep everywhere, and nothing is far', () => {
  const depth = aov('depth', wall, 4);
  expect(depth[right]).toBeCloseTo(10, 4);
  expect(depth[right + WIDTH]).toBeCloseTo(10, 4);
  expect(depth[middle]).toBeCloseTo(2, 1);
  expect(depth[left]).toBe(Math.fround(FAR));
});

test('depth of a panorama is the distance', () => {
  const camera = { ...wall.camera, projection: 'equirectangular' } as const;
  const scene = { ...wall, camera };
  const [depth, position] = [aov('depth', scene), aov('position', scene)];
  for (const pixel of [middle, middle + 1, middle + WIDTH]) {
    const [x, y, z] = position.subarray(3 * pixel, 3 * pixel + 3);
    if (depth[pixel] !== Math.fround(FAR)) expect(depth[pixel]).toBeCloseTo(Math.hypot(x! - 1e5, y!, z! - 10), 1);
  }
});

test('places are of the world, exact to float32 far from the origin', () => {
  const position = aov('position', wall);
  expect(position[3 * right]).toBeGreaterThan(1e5);
  expect(position[3 * right + 2]).toBeCloseTo(0, 5);
  expect(Array.from(position.subarray(3 * left, 3 * left + 3))).toEqual([0, 0, 0]);
});

test('numbers follow the file, and have names', () => {
  expect([middle, right, left].map((pixel) => aov('primitive-id', wall)[pixel])).toEqual([1, 2, 0]);
  expect([middle, right, left].map((pixel) => aov('material-id', wall)[pixel])).toEqual([2, 1, 0]);
  expect(aovIds(wall, 'path')).toEqual({
    primitives: [null, '/shapes/ball', '/shapes/wall'],
    materials: [null, '/materials/red', '/materials/mirror'],
    materialOf: [0, 2, 1],
  });
  expect(aovIds(aovScene, 'path').primitives.slice(-2)).toEqual(['/lights/lamp', '/lights/panel']);
  expect(aovIds(aovScene, 'classic').primitives.slice(-1)).toEqual(['/lights/lamp']);
});

test('albedo is 1 of a mirror and the base colour of a wall; normals look at the camera, geometric ones as the shape says', () => {
  const [albedo, normal, geometric] = (['albedo', 'normal', 'geometric-normal'] as const).map((name) =>
    aov(name, wall),
  );
  const at = (values: Float32Array, pixel: number) => Array.from(values.subarray(3 * pixel, 3 * pixel + 3));
  expect(at(albedo!, middle)).toEqual([1, 1, 1]);
  expect(at(albedo!, right)).toEqual([0.7, 0.1, 0.1].map(Math.fround));
  expect(at(albedo!, left)).toEqual([0, 0, 0]);
  expect(at(normal!, right)).toEqual([0, 0, 1]);
  expect(at(geometric!, right)).toEqual([0, 0, 1]);
  const turned: Scene = {
    ...wall,
    shapes: { wall: { type: 'quad', corner: [1e5 - 2, -20, 0], u: [0, 40, 0], v: [22, 0, 0], material: 'red' } },
  };
  expect(at(aov('normal', turned), right)).toEqual([0, 0, 1]);
  expect(at(aov('geometric-normal', turned), right).map((x) => x + 0)).toEqual([0, 0, -1]);
});

test('means count the samples that meet nothing', () => {
  const [coverage, albedo] = [aov('coverage', wall, 16), aov('albedo', wall, 16)];
  const edge = coverage.findIndex((share) => share > 0 && share < 1);
  expect(edge).toBeGreaterThan(-1);
  expect(albedo[3 * edge]).toBeCloseTo(0.7 * coverage[edge]!, 5);
});

test('direct light needs two segments at most, or no mirrors', () => {
  expect([-1, 1, 2, 9].map((maxDepth) => directSettings({ ...settings, maxDepth }).maxDepth)).toEqual([2, 1, 2, 2]);
  const classic = { ...settings, integrator: 'classic', maxReflections: 4 } as const;
  expect(directSettings(classic)).toEqual({ ...classic, maxReflections: 0 });
});

test('every name has a layer of its own', () => {
  expect(new Set(AOV_NAMES.map((name) => AOVS[name].layer)).size).toBe(AOV_NAMES.length);
});
