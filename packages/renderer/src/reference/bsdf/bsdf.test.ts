import { describe, expect, test, vi } from 'vitest';
import { COSINES, directionOf, hasInside, SURFACES } from '../../../../../tests/fixtures/bsdf-cases.ts';
import { chartsOf } from '../../../../../tests/fixtures/bsdf-charts.ts';
import { chiSquare } from '../../../../../tests/fixtures/chi-square.ts';
import { type Random, randomDirection, seededRandom } from '../../../../../tests/fixtures/random.ts';
import type { Vec3 } from '../../scene/scene.ts';
import { evaluateBsdf, isDelta, sampleBsdf } from './bsdf.ts';
import { type BsdfSample, type BsdfSurface, mapColor } from './surface.ts';

// Seconds of arithmetic: a busy machine may take its time.
vi.setConfig({ testTimeout: 60_000 });

const SAMPLES = 6000;
/** What the integral of a density may be off: its edge at the horizon cuts cells of the midpoint rule. */
const QUADRATURE = 0.008;
const seed = 7;

const randomPoint = (random: Random): Vec3 => [random(), random(), random()];
const cosinesOf = (s: BsdfSurface) => (hasInside(s) ? [...COSINES, ...COSINES.map((c) => -c)] : COSINES);

describe.each(Object.entries(SURFACES))('%s', (_, s) => {
  test(`χ²: directions are sampled with the density they claim, which integrates to what is not lost (seed ${seed})`, () => {
    const random = seededRandom(seed);
    for (const cosine of cosinesOf(s)) {
      const wo = directionOf(cosine);
      const drawn = Array.from({ length: SAMPLES }, () => sampleBsdf(s, wo, randomPoint(random)));
      const rough = drawn.map((d) => (d && !d.delta ? d.direction : null));
      if (isDelta(s)) expect(rough.every((d) => d === null)).toBe(true);
      else
        for (const chart of chartsOf(s, wo)) {
          const { z, degrees, integral, share } = chiSquare(chart, rough, (wi) => evaluateBsdf(s, wo, wi).pdf);
          expect(integral, `cosine ${cosine}`).toBeLessThan(1 + QUADRATURE);
          // Four standard errors of a share, and the quadrature's own.
          expect(Math.abs(integral - share), `cosine ${cosine}`).toBeLessThan(QUADRATURE + 2 / Math.sqrt(SAMPLES));
          expect(z, `cosine ${cosine}, ${degrees} degrees of freedom`).toBeLessThan(4.5);
        }
    }
  });

  test(`weights are f |cos| / pdf; no light is made, none is negative (seed ${seed})`, () => {
    for (const cosine of cosinesOf(s)) {
      const wo = directionOf(cosine);
      const drawn = stratified(2048, seed).flatMap((u) => sampleBsdf(s, wo, u) ?? []);
      // The light's power, not its radiance: behind a boundary of glass the same light is in another solid angle.
      const power = (c: 0 | 1 | 2) => drawn.reduce((sum, d) => sum + d.weight[c] * solidAngleRatio(s, wo, d), 0) / 2048;
      expect(Math.max(power(0), power(1), power(2)), `cosine ${cosine}`).toBeLessThan(mostLight(s));
      const leastWeight = Math.min(...drawn.map((d) => Math.min(...d.weight)));
      expect(leastWeight, `cosine ${cosine}`).toBeGreaterThanOrEqual(0);
      const lengthError = Math.max(...drawn.map((d) => Math.abs(Math.hypot(...d.direction) - 1)));
      expect(lengthError, `cosine ${cosine}`).toBeLessThan(1e-9);
      expect(drawn.every((d) => d.pdf > 0)).toBe(true);
    }
  });

  // Where light samples of the sky's map do not go, this is all that finds it.
  test(`samples may go wherever f is above 0 (seed ${seed})`, () => {
    const random = seededRandom(seed);
    for (const cosine of cosinesOf(s))
      for (let i = 0; i < 400; i++) {
        const { value, pdf } = evaluateBsdf(s, directionOf(cosine), randomDirection(random));
        if (Math.max(...value) > 0) expect(pdf, `cosine ${cosine}`).toBeGreaterThan(0);
      }
  });

  // Compensation is a factor of wo alone: Turquin gives up reciprocity on purpose.
  test.skipIf(s.energyCompensation)(`f is the same from both ends, for glass f / index² (seed ${seed})`, () => {
    const random = seededRandom(seed);
    for (let i = 0; i < 500; i++) {
      const [wo, wi] = [randomDirection(random), randomDirection(random)].map((d) =>
        hasInside(s) ? d : ([d[0], d[1], Math.abs(d[2])] as Vec3),
      ) as [Vec3, Vec3];
      if (wo[2] === 0 || wi[2] === 0) continue;
      const index2 = (w: Vec3) => (hasInside(s) && w[2] < 0 ? s.ior ** 2 : 1);
      const there = mapColor(evaluateBsdf(s, wo, wi).value, (x) => x / Math.abs(wi[2]) / index2(wo));
      const back = mapColor(evaluateBsdf(s, wi, wo).value, (x) => x / Math.abs(wo[2]) / index2(wi));
      there.forEach((x, c) => {
        expect(Math.abs(x - back[c]!)).toBeLessThanOrEqual(1e-8 * Math.abs(x));
      });
    }
  });
});

/** u in [0, 1)³ by Roberts' R3 sequence: even enough for means to 1e-3. */
function stratified(n: number, start: number): Vec3[] {
  const g = 1.2207440846057596;
  return Array.from({ length: n }, (_, i) => [1, 2, 3].map((p) => ((start + i + 1) / g ** p) % 1) as unknown as Vec3);
}

/**
 * Every BSDF keeps within 1, the sum's own error aside, except where glTF's appendix B itself does not: its matte part lets
 * through 1 − F at the half vector's cosine, while at grazing the gloss alone returns nearly all. Compensation is a fit.
 */
const mostLight = (s: BsdfSurface) =>
  s.type === 'metallicRoughness' && s.metallic < 1 ? 2 : s.energyCompensation ? 1.02 : 1.003;

function solidAngleRatio(s: BsdfSurface, wo: Vec3, { direction }: BsdfSample): number {
  const crossing = hasInside(s) && !s.thin && wo[2] < 0 !== direction[2] < 0;
  if (!crossing) return 1;
  return wo[2] < 0 ? 1 / s.ior ** 2 : s.ior ** 2;
}
