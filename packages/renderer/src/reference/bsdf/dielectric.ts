/** Glass: exact Fresnel; rough after Walter et al. 2007 with height-correlated masking. Radiance transport. */
import type { Vec3 } from '../../scene/scene.ts';
import { add, dot, negate, normalize, scale } from '../../scene/vec3.ts';
import { dielectricFresnel } from './fresnel.ts';
import { facetDensity, halfVector, lambda, sampleVisibleNormal, seenFromBoth, visibleNormalDensity } from './ggx.ts';
import { type BsdfSample, type BsdfSurface, DARK, type Evaluation, grey } from './surface.ts';

/** Indices closer than this to 1 make a smooth boundary of any: the bend is too small for a density in 32-bit floats. */
export const LEAST_CONTRAST = 1e-3;

export const flip = ([x, y, z]: Vec3): Vec3 => [x, y, -z];
/** The index beyond the boundary over the one on wo's side. A thin pane has air on both sides. */
export const indexRatio = (s: BsdfSurface, wo: Vec3): number => (wo[2] < 0 && !s.thin ? 1 / s.ior : s.ior);

/** Walter et al. 2007, equations 20 (reflection) and 21 (transmission, divided by ratio² for radiance). */
export function evaluateRoughGlass(s: BsdfSurface, wo: Vec3, wi: Vec3): Evaluation {
  const ratio = indexRatio(s, wo);
  // Everything seen with wo above; facets look alike from both sides.
  return wo[2] < 0 ? evaluateFrom(s, flip(wo), flip(wi), ratio) : evaluateFrom(s, wo, wi, ratio);
}

function evaluateFrom({ alpha, masking }: BsdfSurface, wo: Vec3, wi: Vec3, ratio: number): Evaluation {
  if (wi[2] === 0) return DARK;
  const reflects = wi[2] > 0;
  const sum = reflects ? halfVector(wo, wi) : normalize(add(wo, scale(wi, ratio)));
  const h = sum[2] < 0 ? negate(sum) : sum;
  const oh = dot(wo, h);
  const ih = dot(wi, h);
  // A facet shows a direction the side that the surface shows it; one that reflects always does.
  if (!reflects && (oh <= 0 || ih * wi[2] <= 0)) return DARK;
  const fresnel = dielectricFresnel(Math.abs(oh), ratio);
  const seen = seenFromBoth(wo, reflects ? wi : flip(wi), alpha, masking);
  if (reflects) {
    const value = (fresnel * facetDensity(h, alpha) * seen) / (4 * wo[2]);
    // The density of h over 4 cos, the cosine of which is in both.
    return { value: grey(value), pdf: (fresnel * facetDensity(h, alpha)) / (4 * wo[2] * (1 + lambda(wo, alpha))) };
  }
  const jacobian = (ratio ** 2 * Math.abs(ih)) / (oh + ratio * ih) ** 2;
  const value = ((1 - fresnel) * facetDensity(h, alpha) * seen * oh * jacobian) / wo[2] / ratio ** 2;
  return { value: grey(value), pdf: (1 - fresnel) * visibleNormalDensity(wo, h, alpha) * jacobian };
}

/** Snell's law at a facet on wo's side. */
export function refract(wo: Vec3, h: Vec3, ratio: number): Vec3 {
  const cosine = dot(wo, h);
  const inside = Math.sqrt(1 - (1 - cosine ** 2) / ratio ** 2);
  return add(scale(wo, -1 / ratio), scale(h, cosine / ratio - inside));
}

export const reflectAt = (wo: Vec3, h: Vec3): Vec3 => add(scale(h, 2 * dot(wo, h)), negate(wo));

/** A direction by visible normals and Fresnel; null when a facet sends light to the wrong side of the surface. */
export function sampleRoughGlass(s: BsdfSurface, wo: Vec3, u: number, v: number, choice: number): Vec3 | null {
  const ratio = indexRatio(s, wo);
  const up = wo[2] < 0 ? flip(wo) : wo;
  const h = sampleVisibleNormal(up, s.alpha, 1, u, v);
  const reflects = choice < dielectricFresnel(dot(up, h), ratio);
  const wi = reflects ? reflectAt(up, h) : refract(up, h, ratio);
  if (reflects !== wi[2] > 0) return null;
  return wo[2] < 0 ? flip(wi) : wi;
}

export function sampleSmoothGlass(s: BsdfSurface, wo: Vec3, choice: number): BsdfSample {
  const ratio = indexRatio(s, wo);
  const normal: Vec3 = [0, 0, wo[2] < 0 ? -1 : 1];
  const once = dielectricFresnel(Math.abs(wo[2]), ratio);
  // Light runs to and fro between the faces of a pane: R + T²·R·(1 + R² + R⁴ + …).
  const fresnel = s.thin && once < 1 ? once + ((1 - once) ** 2 * once) / (1 - once ** 2) : once;
  if (choice < fresnel) return { direction: reflectAt(wo, normal), pdf: fresnel, weight: grey(1), delta: true };
  const direction = s.thin ? negate(wo) : refract(wo, normal, ratio);
  return { direction, pdf: 1 - fresnel, weight: grey(s.thin ? 1 : 1 / ratio ** 2), delta: true };
}
