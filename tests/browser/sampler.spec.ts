import { backends, expect, test } from './fixtures.ts';

/** What the CPU draws is proved in reference/sampler*.test.ts; here, that a GPU draws the same. */
for (const backend of backends)
  test(`${backend}: random numbers are those of the CPU to the last bit, filter offsets to 2e-6 pixels (seeds in harness/sampler)`, async ({
    harness,
  }) => {
    const report = await harness.evaluate((b) => window.harness.probeSampler(b), backend);
    expect(report.faults).toEqual([]);
    expect(report.numbers).toBe(64 * 64 * (11 * (1 + 2 + 3) + 4 * 2));
    expect(report.largestDifference).toBeLessThan(2e-6);
  });
