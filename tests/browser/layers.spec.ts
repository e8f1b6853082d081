import type { Page } from '@playwright/test';
import { GGX_ALBEDO } from '../fixtures/ggx-albedo.ts';
import { LAYERED, type LayeredMaterial, layered } from '../fixtures/layers/layered-material.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/** The BSDFs of glTF's layers (docs/materials.md), in the kernels, against the specifications and the laws of light. */

const COSINES = [1, 0.6, 0.2, 0.05];
const mirror = { metallic: 1, roughness: 0 };
const wall = { transmission: 1, roughness: 0 };
const body = { transmission: 1, solid: true, roughness: 0 };

/** White, and nothing that absorbs or that a second facet would have to reflect once more. */
const LOSSLESS: Readonly<Record<string, LayeredMaterial>> = {
  'a smooth coat over a mirror': layered({ ...mirror, clearcoat: 0.8 }),
  'a smooth bent coat over a mirror': layered({ ...mirror, clearcoat: 0.8, coatNormal: [0.6, 0, 0.8] }),
  'a thin wall': layered(wall),
  'a thin wall under a smooth coat': layered({ ...wall, clearcoat: 1 }),
  'a weak gloss on a thin wall': layered({ ...wall, specular: 0.3 }),
  'a film on a thin wall, brightest colour': layered({ ...wall, iridescence: 1, iridescenceIor: 1.8 }),
  'a body': layered(body),
  'a body of index 2.4': layered({ ...body, ior: 2.4 }),
  'diffuse transmission without gloss': layered({ specular: 0, diffuseTransmission: 0.6 }),
};
/** White on top of a white mirror; what is lost is light that one facet or fibre sends to another, or what E is too much by. */
const ON_MIRRORS: Readonly<Record<string, LayeredMaterial>> = {
  'a rough coat': layered({ ...mirror, clearcoat: 1, clearcoatRoughness: 0.7 }),
  'a rough bent coat': layered({ ...mirror, clearcoat: 1, clearcoatRoughness: 0.7, coatNormal: [0.6, 0, 0.8] }),
  'coarse sheen': layered({ ...mirror, sheenColor: [1, 1, 1], sheenRoughness: 1 }),
  'fine sheen': layered({ ...mirror, sheenColor: [1, 1, 1], sheenRoughness: 0.3 }),
  'very fine sheen': layered({ ...mirror, sheenColor: [1, 1, 1], sheenRoughness: 0.1 }),
  'sheen under a coat': layered({ ...mirror, clearcoat: 0.7, sheenColor: [1, 1, 1], sheenRoughness: 0.5 }),
  'a film': layered({ ...mirror, iridescence: 1 }),
  'a film on rough metal': layered({ metallic: 1, roughness: 0.5, iridescence: 1, iridescenceThickness: 250 }),
  'a grain': layered({ metallic: 1, roughness: 0.2, anisotropy: 0.5 }),
  'a strong grain on a thin wall': layered({ ...wall, roughness: 0.3, anisotropy: 1 }),
  'a rough body': layered({ ...body, roughness: 0.6 }),
  'a leaf without gloss under sheen': layered({
    specular: 0,
    diffuseTransmission: 0.5,
    sheenColor: [1, 1, 1],
    sheenRoughness: 0.6,
  }),
};
/** A matte body below gloss, which glTF's own formulas let shine too bright at grazing angles; what lies on top may not add to that. */
const PLASTIC = layered({ ior: 1.51, roughness: 0.4 });
const ON_PLASTIC: Readonly<Record<string, LayeredMaterial>> = {
  'a coat': { ...PLASTIC, clearcoat: 1, clearcoatRoughness: 0.3 },
  sheen: { ...PLASTIC, sheenColor: [1, 1, 1], sheenRoughness: 0.5 },
  'diffuse transmission': { ...PLASTIC, diffuseTransmission: 0.5 },
  transmission: { ...PLASTIC, transmission: 1 },
};

const furnaces = (
  harness: Page,
  backend: Backend,
  materials: readonly LayeredMaterial[],
  cosines: readonly number[],
  energyCompensation = false,
) =>
  harness.evaluate(([b, m, c, e]) => window.harness.layerFurnaces(b, m, c, e), [
    backend,
    materials,
    cosines,
    energyCompensation,
  ] as const);

// What a switch leaves out is the same on both backends; whole paths by such programs: layered-scenes.spec.ts.
test('webgpu: programs for one kind of layer say the same of it (seed 305)', async ({ harness }) => {
  const reports = await harness.evaluate(() => window.harness.probeLayersAlone('webgpu', 305));
  expect(reports.map(({ examples }) => examples)).toEqual(reports.map(() => []));
  for (const { lit, asked } of reports) expect(lit, 'answers above 0').toBeGreaterThan(0.3 * asked);
});

for (const backend of backends) {
  test(`${backend}: layered BSDFs are what the specifications say, in double precision (seed 301)`, async ({
    harness,
  }) => {
    const report = await harness.evaluate((b) => window.harness.probeLayers(b, 301), backend);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
    expect(report.lit, 'answers above 0').toBeGreaterThan(0.4 * report.asked);
    expect(report.open, 'what rounding leaves open').toBeLessThan(0.05 * report.lit);
  });

  test(`${backend}: layered BSDFs are finite where formulas divide by zero (seed 302)`, async ({ harness }) => {
    const report = await harness.evaluate((b) => window.harness.probeLayerEdges(b, 302), backend);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
  });

  for (const [cosine, seed] of [
    [0.8, 303],
    [0.25, 304],
  ] as const)
    test(`${backend}: χ² and weights of layered samples at cosine ${cosine} (seed ${seed})`, async ({ harness }) => {
      const asked = [backend, cosine, seed] as const;
      const reports = await harness.evaluate(([b, c, s]) => window.harness.layersOverSphere(b, c, s), asked);
      expect(reports.length).toBeGreaterThan(20);
      for (const { name, z, integral, share, albedo, weight, error, heaviest, unfound } of reports) {
        // Of 5 · 10⁻⁶ probability each; 4096 samples; the quadrature is good to 0.2 %.
        expect.soft(z, name).toBeLessThan(4.5);
        expect
          .soft(Math.abs(integral - share), name)
          .toBeLessThan(0.002 + 4.5 * Math.sqrt((share * (1 - share) + 1e-3) / 4096));
        expect.soft(Math.abs(albedo - weight), name).toBeLessThan(0.002 * albedo + 4.5 * error);
        // Light that leaves a body of index 1.7 in one colour of three has 3 · 1.7² of its radiance.
        expect.soft(heaviest, name).toBeLessThan(9);
        expect.soft(unfound, name).toBe(0);
      }
    });

  test(`${backend}: white layers lose nothing, or what the model loses, and make no light`, async ({ harness }) => {
    const lossless = await furnaces(harness, backend, Object.values(LOSSLESS), [...COSINES, -0.9, -0.3]);
    Object.keys(LOSSLESS).forEach((name, i) => {
      for (const means of lossless[i]!) {
        // Colours of a film are chosen by chance together: their own means are as good as 2048 even points.
        const tolerance = name.startsWith('a film') ? 2e-3 : 1e-4;
        expect.soft(Math.abs(Math.max(...means) - 1), name).toBeLessThan(tolerance);
      }
    });
    const covered = await furnaces(harness, backend, Object.values(ON_MIRRORS), COSINES);
    Object.keys(ON_MIRRORS).forEach((name, i) => {
      for (const means of covered[i]!) expect.soft(Math.max(...means), name).toBeLessThan(1.002);
      // The fit of E is at most 1 % too much; where E is above 1 the lobe is divided by more than it need be.
      if (name === 'coarse sheen' || name === 'fine sheen')
        for (const means of covered[i]!) expect.soft(means[0], name).toBeGreaterThan(0.988);
    });
    const [base, ...plastics] = await furnaces(harness, backend, [PLASTIC, ...Object.values(ON_PLASTIC)], COSINES);
    Object.keys(ON_PLASTIC).forEach((name, i) => {
      plastics[i]!.forEach(([red], c) => {
        expect.soft(red, name).toBeLessThan(Math.max(base![c]![0], 1) + 2e-3);
      });
    });
  });

  test(`${backend}: a rough white thin wall sends on what GGX does not lose, by an independent quadrature`, async ({
    harness,
  }) => {
    for (const alpha of [0.3, 0.6] as const) {
      const row = GGX_ALBEDO[alpha]!.filter(([cosine]) => cosine >= 0.1);
      const rough = layered({ ...wall, roughness: Math.sqrt(alpha) });
      const [means] = await furnaces(harness, backend, [rough], row.map(([cosine]) => cosine)); // biome-ignore format: one line
      row.forEach(([cosine, albedo], i) => {
        expect.soft(Math.abs(means![i]![0] - albedo), `α ${alpha}, cosine ${cosine}`).toBeLessThan(3e-3);
      });
    }
  });

  test(`${backend}: rough white metal with energy compensation is white under a coat too, within 1.2 %`, async ({
    harness,
  }) => {
    const metal = layered({ metallic: 1, roughness: 0.7, clearcoat: 0.6 });
    const [means] = await furnaces(harness, backend, [metal], COSINES, true);
    for (const [red] of means!) expect.soft(Math.abs(red - 1)).toBeLessThan(0.012);
  });

  test(`${backend}: layers are the same from both ends, but for what the specifications make otherwise`, async ({
    harness,
  }) => {
    // A coat counts by the angle to the viewer, and light that a solid's matte body lets in or out by that of the surface.
    const coated = Object.keys(LAYERED).filter((name) => LAYERED[name]!.clearcoat > 0);
    expect(coated.length).toBe(6);
    const bent = coated.filter((name) => LAYERED[name]!.coatNormal[2] < 1);
    const exceptions = { any: [...coated, 'wax'], alike: [...bent, 'wax'] };
    for (const alike of [false, true]) {
      const ends = await harness.evaluate(([b, a]) => window.harness.layersFromBothEnds(b, a), [
        backend,
        alike,
      ] as const);
      const checked = ends.filter(({ name }) => !exceptions[alike ? 'alike' : 'any'].includes(name));
      expect(checked.length).toBe(ends.length - exceptions[alike ? 'alike' : 'any'].length);
      for (const { name, difference, lit } of checked) {
        expect.soft(difference, name).toBeLessThan(1e-4);
        expect.soft(lit, name).toBeGreaterThan(300);
      }
    }
  });
}
