import { decode } from 'fast-png';
import { VIEW_NAMES } from '../../packages/renderer/src/display/views.ts';
import { backends, expect, test } from './fixtures.ts';

/** Shapes 1 to 6 and lamps 7, 8 of fixtures/aov-scene.ts; 0 is the sky. The classic integrator knows no quad lights. */
const IDS = { path: [0, 1, 2, 3, 4, 5, 6, 7, 8], classic: [0, 1, 2, 3, 4, 5, 6, 7] };

for (const backend of backends)
  test(`${backend}: what the camera sees first is as in double precision, by the rays of each integrator (seed 7)`, async ({
    harness,
  }) => {
    const reports = await harness.evaluate((b) => window.harness.aovFilms(b), backend);
    for (const [name, { pixels, off, examples }] of Object.entries(reports))
      expect(off, `${name}: ${examples}`).toBeLessThan(0.01 * pixels);
    expect(reports['path perspective data']!.ids).toEqual(IDS.path);
    expect(reports['classic perspective data']!.ids).toEqual(IDS.classic);
  });

const SIZE = [64, 48] as const;

for (const backend of backends)
  test(`${backend}: the canvas shows each view in the colours of TypeScript, and readFilm gives its values`, async ({
    harness,
  }) => {
    for (const view of VIEW_NAMES) {
      if (view === 'picture') continue;
      const args = [backend, view, SIZE] as const;
      const { bytes, film, picture } = await harness.evaluate(
        ([b, v, [w, h]]) => window.harness.displayedView(b, v, w, h),
        args,
      );
      expect([film.view, film.length, picture.view]).toEqual([view, 4 * SIZE[0] * SIZE[1], 'picture']);
      expect(film.off, `${view}: values that are off`).toBeLessThan(0.01 * film.length);
      expect(picture.brightest).toBeGreaterThan(0.1);
      const { data, width, height, channels } = decode(await harness.locator(`#view-${backend}`).screenshot());
      expect([width, height]).toEqual(SIZE);
      const off = Array.from({ length: width * height }, (_, pixel) =>
        Math.max(...[0, 1, 2].map((c) => Math.abs(data[pixel * channels + c]! - bytes[pixel * 3 + c]!))),
      );
      // Where a ray just meets something or just does not, rounding decides.
      expect.soft(off.filter((d) => d > 2).length, `${view}: pixels that are off`).toBeLessThan(0.01 * off.length);
    }
  });
