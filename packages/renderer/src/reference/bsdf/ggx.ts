/**
 * GGX facets and Smith's masking as in Walter et al. 2007 and Heitz 2014, by the formulas of the papers. All directions are on
 * the side of +z; no cosine may be 0.
 */
import type { Masking, Vec3 } from '../../scene/scene.ts';
import { add, dot, length, normalize, scale } from '../../scene/vec3.ts';

/** Narrower than this a highlight is taken for a mirror's. */
export const SMOOTH_ALPHA = 1e-3;

/** tan² of the angle to +z. */
const tangent2 = ([x, y, z]: Vec3) => (x * x + y * y) / (z * z);

/** D(h), Walter et al. 2007, equation 33. */
export function facetDensity(h: Vec3, alpha: number): number {
  return alpha ** 2 / (Math.PI * h[2] ** 4 * (alpha ** 2 + tangent2(h)) ** 2);
}

/** Smith's Lambda, Heitz 2014, equation 72. */
export const lambda = (w: Vec3, alpha: number): number => (Math.sqrt(1 + alpha ** 2 * tangent2(w)) - 1) / 2;

/** Share of facets that is seen from both: heights being correlated, Heitz 2014, equation 99, or not, his equation 98. */
export function seenFromBoth(a: Vec3, b: Vec3, alpha: number, masking: Masking): number {
  const [hidden, other] = [lambda(a, alpha), lambda(b, alpha)];
  return masking === 'separable' ? 1 / ((1 + hidden) * (1 + other)) : 1 / (1 + hidden + other);
}

/** Density of the normals that wo sees, Heitz 2018, equation 3. */
export function visibleNormalDensity(wo: Vec3, h: Vec3, alpha: number): number {
  const seen = 1 / (1 + lambda(wo, alpha));
  return (seen * Math.max(dot(wo, h), 0) * facetDensity(h, alpha)) / wo[2];
}

/** k of Eto and Tokuyoshi 2023: the part of the cap's lower half that can still reflect upwards. */
export function reflectionBound(wo: Vec3, alpha: number): number {
  const s = 1 + Math.hypot(wo[0], wo[1]);
  return ((1 - alpha ** 2) * s ** 2) / (s ** 2 + alpha ** 2 * wo[2] ** 2);
}

/** Density of the reflected direction when normals are sampled with that bound, per solid angle: same paper, equation 8. */
export function boundedReflectionDensity(wo: Vec3, h: Vec3, alpha: number): number {
  const seenLength = Math.hypot(alpha * wo[0], alpha * wo[1], wo[2]);
  return facetDensity(h, alpha) / (2 * (reflectionBound(wo, alpha) * wo[2] + seenLength));
}

/** A normal that wo sees: a cap of the sphere, shifted (Dupuy and Benyoub 2023). Without a bound, 1, by `visibleNormalDensity`. */
export function sampleVisibleNormal(wo: Vec3, alpha: number, bound: number, u: number, v: number): Vec3 {
  const stretched = normalize([alpha * wo[0], alpha * wo[1], wo[2]]);
  const z = 1 - v * (1 + bound * stretched[2]);
  const sine = Math.sqrt(Math.max(1 - z * z, 0));
  const onCap: Vec3 = [sine * Math.cos(2 * Math.PI * u), sine * Math.sin(2 * Math.PI * u), z];
  const h = add(stretched, onCap);
  return normalize([alpha * h[0], alpha * h[1], h[2]]);
}

export function halfVector(a: Vec3, b: Vec3): Vec3 {
  const sum = add(a, b);
  return scale(sum, 1 / length(sum));
}

/** Fit of the directional albedo, by powers of cosine / (cosine + alpha) in rows, of alpha in columns. */
const ALBEDO_FIT = [
  [0.887807, 0.309386, -0.270728, 0.0252433],
  [1.08526, -3.21434, -1.87718, 1.61195],
  [-5.18071, 10.7648, 6.30913, -8.09265],
  [7.80474, -12.743, -24.1046, 25.2536],
  [-3.60041, 4.60906, 23.1225, -22.9342],
];

/** Directional albedo of GGX whose facets reflect all: what is missing from 1 met a second facet. */
export function singleScatteringAlbedo(cosine: number, alpha: number): number {
  const x = cosine / (cosine + alpha);
  let sum = 0;
  ALBEDO_FIT.forEach((row, i) => {
    row.forEach((coefficient, j) => {
      sum += coefficient * x ** i * alpha ** j;
    });
  });
  return Math.min(sum, 1);
}
