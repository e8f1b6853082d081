import { expect, test } from './fixtures.ts';

for (const backend of ['webgpu', 'webgl2'] as const)
  test(`${backend}: films without a canvas go on, have parts, also of huge pictures, and add up (seed 5)`, async ({
    harness,
  }) => {
    const films = await harness.evaluate((name) => window.harness.headlessFilms(name), backend);
    expect(films.samples).toBe(6);
    expect(films.brightest).toBeGreaterThan(0.1);
    expect(films.resumed).toEqual({ count: 0, largest: 0 });
    expect(films.part).toEqual({ count: 0, largest: 0 });
    expect(films.ranges.count).toBeGreaterThanOrEqual(0);
    expect(films.ranges.largest).toBeLessThan(1e-6 * films.brightest);
    // By the reference tracer, which knows no film: where a part lies in a picture that no device holds is told to the kernel.
    expect(films.huge.values, 'a value for each pixel').toBeGreaterThan(500);
    expect(films.huge.largest).toBeLessThan(1e-3);
  });
