import type { Page } from '@playwright/test';
import type { Camera, Quad, QuadLight, Scene, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { GGX_ALBEDO, LAMP_OVER_FLOOR, PENUMBRA, penumbraIrradiance } from '../fixtures/closed-forms.ts';
import { testLight, testMaterial, testScene } from '../fixtures/scenes.ts';
import { blocksOfBatches, WHOLE } from '../reference/blocks.ts';
import { referenceScene } from '../reference/references.ts';
import { pathFilms } from './films.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/** The path integrator where the exact answer is known. Pixels all look at one point, within a millimetre. */
const SIZE = { width: 16, height: 16, batches: 16 };
const SEED = 70;

const floor: Quad = { type: 'quad', corner: [-50, 0, 50], u: [100, 0, 0], v: [0, 0, -100], material: 'white' };
const RENDER = {
  integrator: 'path',
  maxReflections: 0,
  lightSamples: 1,
  maxDepth: 2,
  exposure: 0,
  toneMapping: 'none',
} as const;
const black = testMaterial({ baseColor: [0, 0, 0] });

/** From low above the floor, so that nothing stands between. */
const lookingAt = ([x, y, z]: Vec3): Camera => ({
  eye: [x + 0.3, y + 1, z - 0.2],
  target: [x, y, z],
  up: [0.1, 0.2, 1],
  verticalFov: 0.04,
});

/** Mean radiance of the picture and its standard error, red, green, blue. */
async function measure(harness: Page, backend: Backend, scene: Scene, samples: number) {
  const films = await pathFilms(harness, backend, scene, { ...SIZE, samples, seed: SEED });
  const { mean, variance } = blocksOfBatches(films, WHOLE);
  return [0, 1, 2].map((c) => ({ mean: mean[c]!, error: Math.sqrt(variance[c]!) }));
}

/** The bound is part of the answer: a measurement too noisy to tell fails too. */
function expectShare(measured: { mean: number; error: number }, exact: number, share: number, what: string): void {
  expect.soft(measured.error, `${what}: noise`).toBeLessThan((share * exact) / 3 + 1e-9);
  expect.soft(Math.abs(measured.mean - exact), what).toBeLessThan(share * exact + 1e-9);
}

const seeds = `seeds ${SEED} to ${SEED + SIZE.batches - 1}`;
for (const backend of backends) {
  test(`${backend}: a spherical lamp over a floor, within 0.3 % (${seeds})`, async ({ harness }) => {
    const { center, radius, radiance, albedo, points } = LAMP_OVER_FLOOR;
    const lamp = testLight({ center, radius, radiance, visible: true });
    const materials = { white: testMaterial({ baseColor: [albedo, albedo, albedo] }) };
    for (const point of points) {
      const scene = testScene({ floor }, { lamp }, { camera: lookingAt(point.at), materials, render: RENDER });
      const [red] = await measure(harness, backend, scene, 4);
      expectShare(red!, point.radiance, 0.003, `at ${point.at.join(', ')}`);
    }
  });

  test(`${backend}: white furnaces are 1, within 1e-3 (${seeds})`, async ({ harness }) => {
    for (const name of ['F1_diffuse', 'F1_glass']) {
      const furnace = referenceScene(name);
      // So near that every pixel sees the ball; and from so far that hits are rounded to its centre, where a sphere has no normal.
      const near: Camera = { ...furnace.camera, verticalFov: 18 };
      const far: Camera = { ...near, eye: [6e8, 5e8, 6e8], projection: 'orthographic', viewHeight: 1 };
      for (const camera of [near, far])
        for (const [c, { mean, error }] of (await measure(harness, backend, { ...furnace, camera }, 16)).entries()) {
          const what = `${name}, from ${camera.eye.join(', ')}, channel ${c}`;
          expect.soft(error, `${what}: noise`).toBeLessThan(5e-4);
          expect.soft(Math.abs(mean - 1), what).toBeLessThan(1e-3);
        }
    }
  });

  // The long ones on one backend: reference.spec.ts shows that the other one's films are the same, or judges them.
  if (backend === 'webgpu') continue;

  test(`${backend}: the penumbra of a square lamp behind an edge, within 0.3 % (${seeds})`, async ({ harness }) => {
    const lamp: QuadLight = { type: 'quad', ...PENUMBRA.lamp, color: [1, 1, 1], visible: true };
    const materials = { white: testMaterial({ baseColor: PENUMBRA.albedo }), black };
    for (const x of PENUMBRA.places) {
      const shapes = { floor, screen: PENUMBRA.screen };
      const scene = testScene(shapes, { lamp }, { camera: lookingAt([x, 0, 0]), materials, render: RENDER });
      const channels = await measure(harness, backend, scene, 64);
      for (const [c, measured] of channels.entries()) {
        const exact = (PENUMBRA.albedo[c]! * penumbraIrradiance(x)) / Math.PI;
        expectShare(measured, exact, 0.003, `at x = ${x}, channel ${c}`);
      }
    }
  });

  test(`${backend}: GGX gives back its directional albedo, within 2e-3 (${seeds})`, async ({ harness }) => {
    for (const { alpha, albedo } of GGX_ALBEDO) {
      const metal = testMaterial({ type: 'conductor', baseColor: [1, 1, 1], roughness: Math.sqrt(alpha) });
      for (const [cosine, exact] of albedo) {
        const camera: Camera = {
          eye: [Math.sqrt(1 - cosine ** 2), cosine, 0],
          target: [0, 0, 0],
          up: [0, 0, 1],
          verticalFov: 0.02,
        };
        const sky = { horizon: [1, 1, 1], zenith: [1, 1, 1] } as const;
        const scene = testScene({ floor }, {}, { camera, sky, materials: { white: metal }, render: RENDER });
        const [red] = await measure(harness, backend, scene, 8);
        const what = `alpha ${alpha}, cosine ${cosine}`;
        expect.soft(red!.error, `${what}: noise`).toBeLessThan(1e-3);
        expect.soft(Math.abs(red!.mean - exact), what).toBeLessThan(2e-3);
      }
    }
  });
}
