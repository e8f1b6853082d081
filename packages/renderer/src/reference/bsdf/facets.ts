/** Opaque facets: metals, and the gloss of glTF's metallic-roughness. */
import type { Color, Vec3 } from '../../scene/scene.ts';
import { dot } from '../../scene/vec3.ts';
import { conductorFresnel, schlick, schlickColor } from './fresnel.ts';
import { boundedReflectionDensity, facetDensity, halfVector, seenFromBoth, singleScatteringAlbedo } from './ggx.ts';
import { type BsdfSurface, type Evaluation, mapColor } from './surface.ts';

const DIELECTRIC_F0 = 0.04;

/** glTF 2.0, appendix B: Schlick's formula is linear in f0, so the mix of both BRDFs' gloss has the mix of their f0. */
const glossF0 = (s: BsdfSurface): Color =>
  mapColor(s.baseColor, (c) => DIELECTRIC_F0 * (1 - s.metallic) + c * s.metallic);

/** What facets reflect that are met at this cosine. */
export function facetReflectance(s: BsdfSurface, cosine: number): Color {
  if (s.type === 'metallicRoughness') return schlickColor(glossF0(s), cosine);
  const measured = [...s.eta, ...s.k].some((x) => x > 0);
  return measured ? mapColor(s.eta, (eta, c) => conductorFresnel(cosine, eta, s.k[c])) : s.baseColor;
}

/** Turquin 2019, equation 16. */
function compensation(s: BsdfSurface, cosine: number): Color {
  if (!s.energyCompensation) return [1, 1, 1];
  const albedo = singleScatteringAlbedo(cosine, s.alpha);
  return mapColor(facetReflectance(s, 1), (f0) => 1 + (f0 * (1 - albedo)) / albedo);
}

/** D F G / (4 cos cos), times cos. */
export function evaluateGloss(s: BsdfSurface, wo: Vec3, wi: Vec3): Evaluation {
  const h = halfVector(wo, wi);
  const fresnel = facetReflectance(s, dot(wo, h));
  const white = (facetDensity(h, s.alpha) * seenFromBoth(wo, wi, s.alpha, s.masking)) / (4 * wo[2]);
  const extra = compensation(s, wo[2]);
  return { value: mapColor(fresnel, (f, c) => f * white * extra[c]), pdf: boundedReflectionDensity(wo, h, s.alpha) };
}

/** Albedo of the matte part below the gloss: what the dielectric's facets let through. */
export function matteAlbedo(s: BsdfSurface, cosine: number): Color {
  if (s.type === 'diffuse') return s.baseColor;
  const through = s.type === 'metallicRoughness' ? (1 - s.metallic) * (1 - schlick(DIELECTRIC_F0, cosine)) : 0;
  return mapColor(s.baseColor, (c) => c * through);
}

/** Probability of sampling the gloss. Even seen at grazing the matte part meets most light at half vectors that are not. */
export function glossShare(s: BsdfSurface, wo: Vec3): number {
  if (s.type === 'diffuse') return 0;
  const total = ([r, g, b]: Color) => r + g + b;
  const gloss = total(facetReflectance(s, wo[2]));
  return s.type === 'conductor' ? 1 : gloss / Math.max(gloss + total(matteAlbedo(s, 1)), 1e-20);
}
