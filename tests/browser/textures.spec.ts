import { backends, expect, test } from './fixtures.ts';

const SEED = 31;

for (const backend of backends)
  test(`${backend}: textures of all sizes, wraps, filters and transforms as in double precision (seed ${SEED})`, async ({
    harness,
  }) => {
    const report = await harness.evaluate(([b, s]) => window.harness.probeLookups(b, s), [backend, SEED] as const);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
    expect(report.open, 'where rounding decides').toBeLessThan(0.001 * report.asked);
  });
