import { expect, test } from './fixtures.ts';

for (const backend of ['webgpu', 'webgl2'] as const)
  test(`${backend}: films without a canvas go on, have parts, and add up (seed 5)`, async ({ harness }) => {
    const films = await harness.evaluate((name) => window.harness.headlessFilms(name), backend);
    expect(films.samples).toBe(6);
    expect(films.brightest).toBeGreaterThan(0.1);
    expect(films.resumed).toEqual({ count: 0, largest: 0 });
    expect(films.part).toEqual({ count: 0, largest: 0 });
    expect(films.ranges.count).toBeGreaterThanOrEqual(0);
    expect(films.ranges.largest).toBeLessThan(1e-6 * films.brightest);
  });
