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
