import { backends, expect, test } from './fixtures.ts';
import type { PictureSettings } from './harness/parity.ts';

/** No speckles, no dotted faces, no light leaks: harness/hard-scenes.ts says where they are looked for. */
// Odd, so that the middle row and column run exactly along the view.
const PICTURE = { width: 81, height: 61, time: 0, seed: 5 };

for (const backend of backends) {
  test(`${backend}: no speckles in scenes that provoke them (seed 5)`, async ({ harness }) => {
    const { scenes } = await harness.evaluate(() => window.harness.hardNames());
    for (const name of scenes) {
      const picture = { ...PICTURE, maxReflections: 6, lightSamples: 9 };
      const found = await harness.evaluate(([b, n, p]) => window.harness.hardPicture(b, n, p), [
        backend,
        name,
        picture,
      ] as const);
      expect.soft(found.good, `${name}: finite and not negative`).toBe(true);
      expect.soft(found.speckles, `${name}: speckles`).toEqual([]);
      expect.soft(found.mean, `${name}: mean difference from the reference`).toBeLessThan(1e-3);
      expect.soft(found.shareOff, `${name}: pixels off the reference`).toBeLessThan(0.005);
    }
  });

  test(`${backend}: no light gets into a closed room (seed 5)`, async ({ harness }) => {
    const { rooms } = await harness.evaluate(() => window.harness.hardNames());
    const film = (name: string, picture: Partial<PictureSettings>, ambient: number) =>
      harness.evaluate(([b, n, p, a]) => window.harness.leaks(b, n, p, a), [
        backend,
        name,
        { ...PICTURE, maxReflections: 0, lightSamples: 1, ...picture },
        ambient,
      ] as const);
    for (const name of rooms) {
      for (const lightSamples of [1, 16]) {
        const dark = await film(name, { lightSamples }, 0);
        expect.soft(dark.good, `${name}: finite and not negative`).toBe(true);
        expect.soft(dark.lit, `${name}, ${lightSamples} samples: pixels with light`).toBe(0);
      }
      // Two lights of ambient 0.25, of which 1 − reflectivity = 0.1 is kept.
      for (const value of (await film(name, { lightSamples: 9 }, 0.25)).spread)
        expect.soft(value, `${name}: ambient`).toBeCloseTo(0.05, 6);
      // A mirror ray that starts within tMin of another quad passes it: docs/classic.md, "Where a ray starts".
      const mirrored = await film(name, { maxReflections: 12 }, 0);
      expect
        .soft(mirrored.lit, `${name} of mirrors: pixels with light`)
        .toBeLessThanOrEqual(name === 'six quads' ? 3 : 0);
    }
  });

  test(`${backend}: 10,000 m away, or a thousand times smaller, it is the same picture (seed 5)`, async ({
    harness,
  }) => {
    const { scenes } = await harness.evaluate(() => window.harness.hardNames());
    for (const name of scenes.filter((s) => !/far light|paper/.test(s)))
      for (const place of [
        [1, 1e4],
        [1e-3, 1e4],
      ] as [number, number][]) {
        const found = await harness.evaluate(([b, n, p, q]) => window.harness.movedPicture(b, n, p, q), [
          backend,
          name,
          place,
          { ...PICTURE, maxReflections: 3, lightSamples: 9 },
        ] as const);
        const what = `${name}, scaled by ${place[0]} and moved by ${place[1]}`;
        expect.soft(found.good, `${what}: finite and not negative`).toBe(true);
        expect.soft(found.speckles, `${what}: speckles`).toEqual([]);
        expect.soft(found.shareOff, `${what}: pixels that differ`).toBeLessThan(0.005);
      }
  });
}
