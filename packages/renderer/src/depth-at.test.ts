import { expect, test } from 'vitest';
import { depthAt } from './depth-at.ts';
import type { Camera } from './scene/scene.ts';
import { parseScene } from './scene-file/parse-scene.ts';
import { requireScene } from './scene-file/require-scene.ts';
import { DEFAULT_SETTINGS } from './view.ts';

const read = parseScene(
  JSON.stringify({
    version: 1,
    name: 'Depths',
    camera: { eye: [0, 0, 10], target: [0, 0, 0], verticalFov: 90 },
    materials: { grey: {} },
    shapes: {
      wall: { type: 'quad', corner: [-100, -5, 2], u: [200, 0, 0], v: [0, 105, 0], material: 'grey' },
      ball: { type: 'sphere', center: [0, 0, 5], radius: 1, material: 'grey' },
    },
    lights: { lamp: { type: 'quad', corner: [3, 3, 6], u: [1, 0, 0], v: [0, 1, 0], radiance: 1, visible: true } },
  }),
);
if (!read.ok) throw new Error(JSON.stringify(read.problems));
const scene = requireScene(read.scene);
const canvas = { width: 200, height: 100 } as HTMLCanvasElement;
const at = (x: number, y: number, camera: Partial<Camera> = {}, integrator: 'path' | 'classic' = 'path') =>
  depthAt(
    { scene, time: 0, camera: { ...scene.camera, ...camera }, canvas, settings: { ...DEFAULT_SETTINGS, integrator } },
    x,
    y,
  );

test('the depth of what is there lies along the line of sight, not along the ray', () => {
  expect(at(0.5, 0.5)).toBeCloseTo(4, 12);
  expect([at(0.1, 0.2), at(0.9, 0.5)].map((depth) => depth?.toFixed(9))).toEqual(['8.000000000', '8.000000000']);
});

test('nothing is there: null', () => {
  expect(at(0.5, 0.99)).toBeNull();
});

test('lamps that are seen count, where the integrator knows them', () => {
  // The ray to (3.5, 3.5, 6), 4 metres before the eye.
  const [x, y] = [(1 + 3.5 / 8) / 2, (1 - 3.5 / 4) / 2];
  expect(at(x, y)).toBeCloseTo(4, 12);
  expect(at(x, y, {}, 'classic')).toBeCloseTo(8, 12);
});

test('other projections', () => {
  expect(at(0.5, 0.5, { projection: 'orthographic', viewHeight: 8 })).toBeCloseTo(4, 12);
  expect(at(0.9, 0.4, { projection: 'orthographic', viewHeight: 8 })).toBeCloseTo(8, 12);
  expect(at(0.5, 0.5, { projection: 'equirectangular' })).toBeCloseTo(4, 12);
});
