import { describe, expect, test, vi } from 'vitest';
import { directionOf, glass, surface, whiteMetal } from '../../../../../tests/fixtures/bsdf-cases.ts';
import { GGX_ALBEDO } from '../../../../../tests/fixtures/ggx-albedo.ts';
import type { Vec3 } from '../../scene/scene.ts';
import { evaluateBsdf, sampleBsdf } from './bsdf.ts';
import { conductorFresnel, dielectricFresnel } from './fresnel.ts';
import type { BsdfSurface } from './surface.ts';

// Seconds of arithmetic: a busy machine may take its time.
vi.setConfig({ testTimeout: 60_000 });

/** u in [0, 1)³, spread evenly (Roberts' R3 sequence): means of smooth functions to a few 1e-4 with some thousand. */
function evenPoints(n: number): Vec3[] {
  const g = 1.2207440846057596;
  return Array.from(
    { length: n },
    (_, i) => [(i + 1) / g, (i + 1) / g ** 2, (i + 1) / g ** 3].map((x) => x % 1) as never,
  );
}

/** Red light that comes back when radiance 1 comes from everywhere. */
function furnace(s: BsdfSurface, cosine: number, points: readonly Vec3[]): number {
  const wo = directionOf(cosine);
  return points.reduce((sum, u) => sum + (sampleBsdf(s, wo, u)?.weight[0] ?? 0), 0) / points.length;
}

const COSINES = [1, 0.6, 0.2, 0.05];
const few = evenPoints(512);
const many = evenPoints(4096);

test('white furnace: diffuse 1, a mirror layer over it 1, a smooth white metal 1', () => {
  for (const cosine of COSINES)
    for (const s of [surface({}), surface({ reflectivity: 0.4 }), whiteMetal(0)])
      expect(furnace(s, cosine, few)).toBeCloseTo(1, 9);
});

test('white furnace: glass, in radiance over index², 1 from both sides; a thin pane 1', () => {
  for (const cosine of COSINES)
    for (const inside of [false, true]) {
      const wo = directionOf(inside ? -cosine : cosine);
      for (const s of [glass(1.5, 0), glass(4, 0), glass(1, 0.5), { ...glass(1.5, 0.2), thin: true }]) {
        let sum = 0;
        for (const u of few) {
          const { direction, weight } = sampleBsdf(s, wo, u)!;
          const index2 = (w: Vec3) => (w[2] < 0 && !s.thin ? s.ior ** 2 : 1);
          sum += (weight[0] * index2(direction)) / index2(wo);
        }
        expect(sum / few.length).toBeCloseTo(1, 9);
      }
    }
});

test('GGX returns the albedo of an independent quadrature, within 2e-3', () => {
  for (const [alpha, row] of Object.entries(GGX_ALBEDO))
    for (const [cosine, albedo] of row)
      expect(
        Math.abs(furnace(whiteMetal(Number(alpha)), cosine, many) - albedo),
        `alpha ${alpha}, ${cosine}`,
      ).toBeLessThan(2e-3);
});

describe('energy compensation', () => {
  const roughnesses = [0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1];
  const cosines = [0.05, 0.1, 0.2, 0.4, 0.7, 1];
  const white = { energyCompensation: true, metallic: 1 };

  test('white metals return 1 within 1 %, every roughness from 0.05, every cosine from 0.05', () => {
    const points = evenPoints(2048);
    for (const roughness of roughnesses)
      for (const cosine of cosines)
        for (const type of ['conductor', 'metallicRoughness'] as const) {
          const s = surface({ ...white, type, alpha: roughness ** 2 });
          const name = `${type}, roughness ${roughness}, cosine ${cosine}`;
          expect(Math.abs(furnace(s, cosine, points) - 1), name).toBeLessThan(0.01);
        }
  });

  test('coloured metals return no more than the light that came', () => {
    for (const roughness of roughnesses)
      for (const f0 of [0.05, 0.5, 0.95]) {
        const s = surface({ ...white, type: 'metallicRoughness', alpha: roughness ** 2, baseColor: [f0, f0, f0] });
        for (const cosine of cosines) expect(furnace(s, cosine, few)).toBeLessThan(1.01);
      }
  });
});

test('a thin pane is alike from both sides, at grazing angles too', () => {
  const pane = { ...glass(1.5, 0), thin: true };
  for (const cosine of [0.01, 0.1, 0.5, 0.74, 1])
    for (const choice of [0, 0.9999]) {
      const outside = sampleBsdf(pane, directionOf(cosine), [0, 0, choice])!;
      const inside = sampleBsdf(pane, directionOf(-cosine), [0, 0, choice])!;
      expect(inside.pdf).toBeCloseTo(outside.pdf, 12);
      expect(Math.abs(inside.direction[2])).toBeCloseTo(Math.abs(outside.direction[2]), 12);
    }
});

test('a thin pane sums what runs to and fro between its faces: 2 R / (1 + R)', () => {
  for (const cosine of COSINES) {
    const r = dielectricFresnel(cosine, 1.5);
    const back = sampleBsdf({ ...glass(1.5, 0), thin: true }, directionOf(cosine), [0, 0, 0])!;
    expect(back.pdf).toBeCloseTo((2 * r) / (1 + r), 12);
    const through = sampleBsdf({ ...glass(1.5, 0), thin: true }, directionOf(cosine), [0, 0, 0.9999])!;
    expect(through.direction).toEqual(directionOf(cosine).map((x) => -x));
  }
});

describe('Fresnel', () => {
  test('normal incidence, Brewster’s angle, grazing, total reflection', () => {
    expect(dielectricFresnel(1, 1.5)).toBeCloseTo(0.04, 12);
    expect(dielectricFresnel(0, 1.5)).toBe(1);
    expect(dielectricFresnel(Math.sqrt(1 - 0.7 ** 2), 1 / 1.5)).toBe(1);
    const brewster = Math.atan(1.5);
    // Only light polarised across the plane of incidence is reflected: half of sin²(angle − refracted angle).
    const refracted = Math.PI / 2 - brewster;
    expect(dielectricFresnel(Math.cos(brewster), 1.5)).toBeCloseTo(Math.sin(brewster - refracted) ** 2 / 2, 12);
  });

  test('a conductor without extinction is a dielectric; at normal incidence ((n − 1)² + k²) / ((n + 1)² + k²)', () => {
    for (const cosine of COSINES)
      expect(conductorFresnel(cosine, 1.5, 0)).toBeCloseTo(dielectricFresnel(cosine, 1.5), 12);
    expect(conductorFresnel(1, 0.2, 3.9)).toBeCloseTo((0.8 ** 2 + 3.9 ** 2) / (1.2 ** 2 + 3.9 ** 2), 12);
  });
});

test('matte below gloss: glTF’s mix of both BRDFs, at metallic 0.5', () => {
  const s = surface({ type: 'metallicRoughness', metallic: 0.5, baseColor: [0.8, 0.4, 0.1], alpha: 0.3 });
  const black = { ...s, baseColor: [0, 0, 0] as const };
  const [wo, wi] = [directionOf(0.8), directionOf(0.5, 3)];
  const dielectric = evaluateBsdf({ ...s, metallic: 0 }, wo, wi).value;
  const metal = evaluateBsdf({ ...s, metallic: 1 }, wo, wi).value;
  evaluateBsdf(s, wo, wi).value.forEach((x, c) => {
    expect(x).toBeCloseTo((dielectric[c]! + metal[c]!) / 2, 12);
  });
  expect(evaluateBsdf({ ...black, metallic: 0 }, wo, wi).value[0]).toBeLessThan(dielectric[0]);
});
