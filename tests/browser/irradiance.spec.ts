import type { Camera, Scene, Shape, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { dot, normalize, subtract } from '../../packages/renderer/src/scene/vec3.ts';
import { testLight, testScene } from '../fixtures/scenes.ts';
import { backends, expect, test } from './fixtures.ts';

/** Light on a floor, where closed forms know it: light.test.ts asks the same of the double-precision tracer. */
const floor: Shape = { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'white' };
const PICTURE = { width: 32, height: 32, time: 0, maxReflections: 0 };

/** All pixels within a millimetre of the point. */
const lookingAt = ([x, y, z]: Vec3): Camera => ({
  eye: [x + 0.3, y + 2, z - 0.2],
  target: [x, y, z],
  up: [0.1, 0.2, 1],
  verticalFov: 0.02,
});

for (const backend of backends) {
  test(`${backend}: a spherical light gives radiance · radius² / d² · cos θ (seed 7)`, async ({ harness }) => {
    // Height of the centre over the floor and distance aside, in radii of the light.
    for (const [height, aside] of [
      [1.1, 0],
      [1.05, 3],
      [2, 1],
      [5, 4],
      [20, 30],
    ] as const) {
      const radius = 0.5;
      const light = testLight({ center: [0, height * radius, 0], radius, radiance: 7 });
      const scene = testScene({ floor }, { light }, { camera: lookingAt([aside * radius, 0, 0]) });
      const measured = await harness.evaluate(([b, s, p]) => window.harness.shadeMean(b, s, p, 8), [
        backend,
        scene,
        { ...PICTURE, lightSamples: 16, seed: 7 },
      ] as const);
      const exact = (7 * height) / Math.hypot(height, aside) ** 3;
      const what = `height ${height}, aside ${aside} radii`;
      expect.soft([measured.leastSamples, measured.mostSamples], `${what}: film samples`).toEqual([8, 8]);
      expect.soft(Math.abs(measured.mean - exact), what).toBeLessThan(3 * measured.standardError + 1e-6 * exact);
      expect.soft(measured.standardError / exact, `${what}: noise`).toBeLessThan(0.02);
    }
  });

  test(`${backend}: behind a straight edge the share (1 + h / radius) / 2 of a light is seen (seed 8)`, async ({
    harness,
  }) => {
    const center: Vec3 = [0, 4, 0];
    const radius = 0.05;
    const light = testLight({ center, radius, radiance: 1000 });
    // Each covers x < 0 at height 2 and is as good as endless; its edge is the line x = 0, y = 2.
    const quad: Shape = { type: 'quad', corner: [-9, 2, -9], u: [9, 0, 0], v: [0, 0, 18], material: 'white' };
    const box: Shape = {
      type: 'box',
      center: [-4.5, 2, 0],
      size: [18, 1e-5, 9],
      rotation: [0, 90, 0],
      material: 'white',
    };
    for (const [name, occluder] of Object.entries({ quad, box }))
      for (const x of [-0.06, -0.045, -0.02, 0, 0.013, 0.04, 0.06]) {
        const camera = { ...lookingAt([x, 0, 0]), eye: [x + 0.3, 1, -0.2] as Vec3 };
        const scene: Scene = testScene({ floor, occluder }, { light }, { camera });
        const measured = await harness.evaluate(([b, s, p]) => window.harness.shadeMean(b, s, p, 2), [
          backend,
          scene,
          { ...PICTURE, lightSamples: 64, seed: 8 },
        ] as const);
        const h = dot(subtract(center, [x, 0, 0]), normalize([2, x, 0]));
        const share = Math.min(Math.max((1 + h / radius) / 2, 0), 1);
        const open = (1000 * radius ** 2 * 4) / (16 + x * x) ** 1.5;
        // The light is 1/80 of its distance wide, so that its points are alike up to the square of that.
        const tolerance = 3 * measured.standardError + 2e-4 * open;
        expect.soft(Math.abs(measured.mean - share * open), `${name} at x = ${x}`).toBeLessThan(tolerance);
      }
  });
}
