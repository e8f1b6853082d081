import { backends, expect, test } from './fixtures.ts';

/**
 * The kernels' BSDFs against the double-precision ones, which are proved by themselves in reference/bsdf. How far rounding
 * may go is worked out in harness/bsdf/expectation.ts.
 */
for (const backend of backends) {
  test(`${backend}: BSDF values and densities as in double precision (seed 201)`, async ({ harness }) => {
    const report = await harness.evaluate((b) => window.harness.probeEvaluation(b, 201), backend);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
    expect(report.lit, 'questions with an answer above 0').toBeGreaterThan(0.4 * report.asked);
    expect(report.open, 'what rounding leaves open').toBeLessThan(0.05 * report.lit);
  });

  test(`${backend}: BSDF samples say their own density and weight, as in double precision (seed 202)`, async ({
    harness,
  }) => {
    const report = await harness.evaluate((b) => window.harness.probeSamples(b, 202), backend);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
    // Leaving an index of 4 makes 16 of radiance 1; lobes chosen too seldom would weigh more.
    expect(report.heaviest, 'largest weight').toBeLessThan(20);
    expect(report.lit, 'samples of rough lobes').toBeGreaterThan(0.3 * report.asked);
    expect(report.open, 'what rounding leaves open').toBeLessThan(0.05 * report.lit);
  });

  test(`${backend}: BSDFs are finite where formulas divide by zero (seed 203)`, async ({ harness }) => {
    const report = await harness.evaluate((b) => window.harness.probeEdges(b, 203), backend);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
  });

  for (const [cosine, seed] of [
    [0.8, 204],
    [0.1, 205],
    [0.004, 206],
  ] as const)
    test(`${backend}: χ² of BSDF samples at cosine ${cosine} (seed ${seed})`, async ({ harness }) => {
      const asked = [backend, cosine, seed] as const;
      const reports = await harness.evaluate(([b, c, s]) => window.harness.chiSquareSamples(b, c, s), asked);
      expect(reports.length).toBeGreaterThan(25);
      // Of 5 · 10⁻⁶ probability each.
      expect(reports.filter((r) => !(r.z < 4.5))).toEqual([]);
      expect(reports.filter((r) => !(Math.abs(r.integral - r.share) < 0.008 + (0.5 * 4) / Math.sqrt(4096)))).toEqual(
        [],
      );
    });
}
