import { backends, expect, test } from './fixtures.ts';

/**
 * The kernels' light sampling against closed forms and the double-precision one. Samples are jittered in 128 × 128 cells. What a
 * tolerance is not 0.3 % of a light's irradiance for comes from rounding at edges of lamps.
 */
for (const backend of backends) {
  test(`${backend}: lamps give the irradiance of closed forms, with the densities they tell (seed 51)`, async ({
    harness,
  }) => {
    for (const report of await harness.evaluate((b) => window.harness.probeLamps(b), backend)) {
      const { name, error, z, samples, missed, faults, examples } = report;
      expect.soft(examples, `${name}: ${faults} of ${samples} samples`).toEqual([]);
      expect.soft(Math.abs(error), `${name}: irradiance`).toBeLessThan(0.003);
      expect.soft(z, `${name}: distribution of directions`).toBeLessThan(4);
      expect.soft(missed, `${name}: rays that pass it by`).toBeLessThanOrEqual(0.01 * samples);
    }
  });

  test(`${backend}: meshes give the irradiance of Lambert's formula, with the densities they tell (seed 52)`, async ({
    harness,
  }) => {
    for (const report of await harness.evaluate((b) => window.harness.probeMeshLamps(b), backend)) {
      const { name, error, noise, z, samples, missed, faults, examples } = report;
      expect.soft(samples, `${name}: samples`).toBeGreaterThan(5000);
      expect.soft(examples, `${name}: ${faults} faults`).toEqual([]);
      // Where a part of the triangles is dark the grid of samples is no help.
      const most = name.startsWith('one-sided') ? 3.5 * noise : 0.003;
      expect.soft(noise, `${name}: noise`).toBeLessThan(0.04);
      expect.soft(Math.abs(error), `${name}: irradiance`).toBeLessThan(most);
      expect.soft(z, `${name}: distribution of directions`).toBeLessThan(4);
      expect.soft(missed, `${name}: rays that pass it by`).toBeLessThanOrEqual(0.001 * samples);
    }
  });

  test(`${backend}: a tree chooses lights as often as is told (seed 74)`, async ({ harness }) => {
    const report = await harness.evaluate((b) => window.harness.probeTree(b, 74), backend);
    expect(report.emitters).toBe(227);
    expect(report.different).toBe(0);
    // What is missing was led to lights none of which reaches the point.
    expect(report.leastSum).toBeGreaterThan(0.9);
    expect(report.mostSum).toBeLessThan(1 + 1e-5);
    // Two neighbouring numbers of 16,384 may fall on either side of an end.
    expect(report.worstFrequency).toBeLessThan(3e-4);
  });

  test(`${backend}: lights without surface shine as in double precision (seed 61)`, async ({ harness }) => {
    for (const { name, worst, meanError, faults } of await harness.evaluate(
      (b) => window.harness.probeFarLights(b),
      backend,
    )) {
      expect.soft(faults, `${name}: faults`).toBe(0);
      expect.soft(worst, `${name}: worst`).toBeLessThan(2e-4);
      // The double-precision sky takes other directions for the same random numbers: two sums over scattered points.
      expect.soft(Math.abs(meanError), `${name}: mean`).toBeLessThan(name === 'sky' ? 1e-3 : 2e-4);
    }
  });

  test(`${backend}: maps of the sky are sampled as often as is told, and look as in double precision (seeds 94, 95)`, async ({
    harness,
  }) => {
    for (const report of await harness.evaluate((b) => window.harness.probeEnvironments(b), backend)) {
      const { name, z, zOfEven, error, noise, faults, examples } = report;
      expect.soft(examples, `${name}: ${faults} faults`).toEqual([]);
      expect.soft(z, `${name}: distribution of directions`).toBeLessThan(4);
      // The sun of this one fills a single bin.
      if (name !== 'sunny') expect.soft(zOfEven, `${name}: directions of even points`).toBeLessThan(-3);
      expect.soft(noise, `${name}: noise of the mean`).toBeLessThan(0.01);
      expect.soft(Math.abs(error), `${name}: mean`).toBeLessThan(3.5 * noise + 1e-4);
    }
  });

  for (const seed of [71, 72, 73])
    test(`${backend}: lights are chosen as often as is told (seed ${seed})`, async ({ harness }) => {
      const report = await harness.evaluate(([b, s]) => window.harness.probeChoices(b, s), [backend, seed] as const);
      expect(report.different, `of ${report.choices} probabilities`).toBe(0);
      expect(report.worst).toBeLessThan(2e-4);
      expect(report.worstFrequency).toBeLessThan(3e-4);
      expect(report.alone).toEqual([0, 1, 1, 1]);
      expect(report.none).toEqual([0, 0, 0, 0]);
    });

  for (const seed of [81, 82, 83])
    test(`${backend}: no lamp of any size gives a wrong number at any point (seed ${seed})`, async ({ harness }) => {
      const report = await harness.evaluate(([b, s]) => window.harness.probeWildLamps(b, s), [backend, seed] as const);
      expect(report.examples, `${report.faults} of ${report.asked} answers`).toEqual([]);
    });
}
