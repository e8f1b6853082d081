import { expect, test } from './fixtures.ts';

/** Fixed seeds, four scenes and two more projections of two of them: WebGPU = WebGL2 = the double-precision reference. */
const TIMES = [0, 1.3, 7.9];
const REFLECTIONS = [0, 1, 2, 10];
const SIZE = { width: 96, height: 72, seed: 20 };

/** Every time with every number of reflections, and each of these with both numbers of samples. */
const ALL = TIMES.flatMap((time, t) =>
  REFLECTIONS.map((maxReflections, r) => ({ time, maxReflections, lightSamples: (t + r) % 2 === 0 ? 9 : 1 })),
);
const FEW = [0, 3].map((maxReflections) => ({ time: 1.3, maxReflections, lightSamples: 9 }));

const names = ['cube-room', 'mirror-blocks', 'moving-shadows', 'baseline-room'];
const projections = ['orthographic', 'equirectangular'];
const projected = projections.flatMap((projection) =>
  ['cube-room', 'moving-shadows'].map((name) => `${name} ${projection}`),
);
for (const scene of [...names, ...projected])
  test(`${scene}: the same picture from WebGPU, WebGL2 and the reference`, async ({ harness }) => {
    for (const settings of projected.includes(scene) ? FEW : ALL) {
      const { time, maxReflections, lightSamples } = settings;
      const asked = [scene, { ...SIZE, ...settings }] as const;
      const differences = await harness.evaluate(([s, p]) => window.harness.parity(s, p), asked);
      const what = `${scene} at ${time} s, ${maxReflections} reflections, ${lightSamples} samples`;
      expect.soft(differences.backends.largestInside, `${what}: WebGPU − WebGL2, largest`).toBeLessThanOrEqual(1e-3);
      expect.soft(differences.backends.mean, `${what}: WebGPU − WebGL2, mean`).toBeLessThan(1e-5);
      for (const backend of ['webgpu', 'webgl2'] as const) {
        expect.soft(differences[backend].finite, `${what}: ${backend} is finite`).toBe(true);
        expect.soft(differences[backend].mean, `${what}: ${backend} − reference, mean`).toBeLessThan(1e-3);
        expect.soft(differences[backend].shareOff, `${what}: ${backend} − reference, pixels off`).toBeLessThan(0.005);
      }
    }
  });
