/**
 * The BSDFs of the path integrator in double precision, by the formulas of the papers: what shading/bsdf is compared with.
 * Local frame as there: +z is the outward normal; opaque surfaces are seen from above; at a dielectric wo.z < 0 means inside.
 */
import type { Vec3 } from '../../scene/scene.ts';
import { dot } from '../../scene/vec3.ts';
import { evaluateRoughGlass, LEAST_CONTRAST, reflectAt, sampleRoughGlass, sampleSmoothGlass } from './dielectric.ts';
import { evaluateGloss, facetReflectance, glossShare, matteAlbedo } from './facets.ts';
import { halfVector, reflectionBound, SMOOTH_ALPHA, sampleVisibleNormal } from './ggx.ts';
import { evaluateLambert, sampleCosine } from './lambert.ts';
import { type BsdfSample, type BsdfSurface, DARK, type Evaluation, grey, mapColor } from './surface.ts';

const UP: Vec3 = [0, 0, 1];

export function isSmooth(s: Pick<BsdfSurface, 'type' | 'alpha' | 'thin' | 'ior'>): boolean {
  if (s.alpha < SMOOTH_ALPHA) return true;
  return s.type === 'dielectric' && (s.thin || Math.abs(s.ior - 1) < LEAST_CONTRAST);
}

/** Whether it has delta lobes only. */
export function isDelta(s: BsdfSurface): boolean {
  if (s.reflectivity >= 1) return true;
  const matte = s.type === 'diffuse' || (s.type === 'metallicRoughness' && s.metallic < 1);
  return !matte && isSmooth(s);
}

/** f · |cos wi| and density of all but the delta lobes. */
export function evaluateBsdf(s: BsdfSurface, wo: Vec3, wi: Vec3): Evaluation {
  const { value, pdf } = evaluateBase(s, wo, wi);
  const base = 1 - s.reflectivity;
  return { value: mapColor(value, (x) => base * x), pdf: base * pdf };
}

function evaluateBase(s: BsdfSurface, wo: Vec3, wi: Vec3): Evaluation {
  if (s.type === 'dielectric') return isSmooth(s) ? DARK : evaluateRoughGlass(s, wo, wi);
  if (wo[2] < 0 || wi[2] <= 0) return DARK;
  const gloss = isSmooth(s) || s.type === 'diffuse' ? DARK : evaluateGloss(s, wo, wi);
  const matte = evaluateLambert(matteAlbedo(s, dot(wo, halfVector(wo, wi))), wi);
  const share = glossShare(s, wo);
  return {
    value: mapColor(gloss.value, (x, c) => x + matte.value[c]),
    pdf: share * gloss.pdf + (1 - share) * matte.pdf,
  };
}

/** u in [0, 1)³. null: no direction, the light is lost. */
export function sampleBsdf(s: BsdfSurface, wo: Vec3, [u, v, choice]: Vec3): BsdfSample | null {
  if (choice < s.reflectivity)
    return { direction: reflectAt(wo, UP), pdf: s.reflectivity, weight: grey(1), delta: true };
  const base = 1 - s.reflectivity;
  const rest = (choice - s.reflectivity) / base;
  const delta = isSmooth(s) ? sampleSmooth(s, wo, rest) : null;
  if (delta) return { ...delta, pdf: base * delta.pdf };
  const direction = sampleRough(s, wo, [u, v, rest]);
  if (!direction) return null;
  const { value, pdf } = evaluateBsdf(s, wo, direction);
  return pdf > 0 ? { direction, pdf, weight: mapColor(value, (x) => x / pdf), delta: false } : null;
}

function sampleSmooth(s: BsdfSurface, wo: Vec3, choice: number): BsdfSample | null {
  if (s.type === 'dielectric') return sampleSmoothGlass(s, wo, choice);
  const share = glossShare(s, wo);
  if (choice >= share) return null;
  const weight = mapColor(facetReflectance(s, wo[2]), (f) => f / share);
  return { direction: reflectAt(wo, UP), pdf: share, weight, delta: true };
}

function sampleRough(s: BsdfSurface, wo: Vec3, [u, v, choice]: Vec3): Vec3 | null {
  if (s.type === 'dielectric') return sampleRoughGlass(s, wo, u, v, choice);
  if (choice >= glossShare(s, wo)) return sampleCosine(u, v);
  return reflectAt(wo, sampleVisibleNormal(wo, s.alpha, reflectionBound(wo, s.alpha), u, v));
}
