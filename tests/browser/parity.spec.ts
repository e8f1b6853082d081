import { expect, test } from './fixtures.ts';

/** Fixed seeds, three scenes × three times × four depths × two sample counts: WebGPU = WebGL2 = the double-precision reference. */
const TIMES = [0, 1.3, 7.9];
const REFLECTIONS = [0, 1, 2, 10];
const SAMPLES = [1, 9];
const SIZE = { width: 128, height: 96, seed: 20 };

const names = ['cube-room', 'mirror-blocks', 'moving-shadows', 'baseline-room'];
const projections = ['orthographic', 'equirectangular'];
const projected = projections.flatMap((projection) =>
  ['cube-room', 'moving-shadows'].map((name) => `${name} ${projection}`),
);
for (const scene of [...names, ...projected]) {
  const few = projected.includes(scene);
  test(`${scene}: the same picture from WebGPU, WebGL2 and the reference`, async ({ harness }) => {
    for (const time of few ? [1.3] : TIMES)
      for (const maxReflections of few ? [0, 3] : REFLECTIONS)
        for (const lightSamples of few ? [9] : SAMPLES) {
          const picture = { ...SIZE, time, maxReflections, lightSamples };
          const differences = await harness.evaluate(([s, p]) => window.harness.parity(s, p), [
            scene,
            picture,
          ] as const);
          const what = `${scene} at ${time} s, ${maxReflections} reflections, ${lightSamples} samples`;
          expect
            .soft(differences.backends.largestInside, `${what}: WebGPU − WebGL2, largest`)
            .toBeLessThanOrEqual(1e-3);
          expect.soft(differences.backends.mean, `${what}: WebGPU − WebGL2, mean`).toBeLessThan(1e-5);
          for (const backend of ['webgpu', 'webgl2'] as const) {
            expect.soft(differences[backend].finite, `${what}: ${backend} is finite`).toBe(true);
            expect.soft(differences[backend].mean, `${what}: ${backend} − reference, mean`).toBeLessThan(1e-3);
            expect
              .soft(differences[backend].shareOff, `${what}: ${backend} − reference, pixels off`)
              .toBeLessThan(0.005);
          }
        }
  });
}
