/** shade(point) of docs/classic.md: what a surface sends back of the lights, before its reflectivity is counted. */
import type { Color, SphereLight, Vec3 } from '../scene/scene.ts';
import { add, addScaled, dot, length, normalize, scale, subtract } from '../scene/vec3.ts';
import { occluded, type SurfaceHit } from './cast.ts';
import { lightRandoms } from './hash.ts';
import type { PreparedScene } from './prepare.ts';
import { rayLeaving } from './ray.ts';
import { samplePoints } from './sample-points.ts';

export interface ShadeContext {
  readonly scene: PreparedScene;
  readonly eye: Vec3;
  /** Points on each light. */
  readonly lightSamples: number;
  /** h: the hash of pixel, film sample and seed. */
  readonly hash: number;
  /** Mirror rays that came before this point. */
  readonly reflection: number;
}

const multiply = (a: Color, b: Color): Color => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** The square bracket: diffuse and specular for light from direction `l`, with `v` back along the ray. */
function reflected(
  { shape: { material }, baseColor, shadingNormal: n }: SurfaceHit,
  light: SphereLight,
  l: Vec3,
  v: Vec3,
) {
  const diffuse = scale(multiply(baseColor, light.diffuse), dot(n, l));
  if (material.specular === 0) return diffuse;
  const h = normalize(add(l, v));
  const highlight = material.specular * Math.max(dot(n, h), 0) ** material.exponent;
  return addScaled(diffuse, light.specular, highlight);
}

/** One term of the sum over k: the light from the sample point pₖ, or black where the point cannot be seen. */
function fromSamplePoint(context: ShadeContext, hit: SurfaceHit, v: Vec3, light: SphereLight, pK: Vec3): Color | null {
  const toPoint = subtract(pK, hit.point);
  const distance = length(toPoint);
  const l = scale(toPoint, 1 / distance);
  if (!(dot(hit.shadingNormal, l) > 0 && dot(hit.geometricNormal, l) > 0)) return null;
  const shadowRay = rayLeaving(hit, l, context.eye);
  if (occluded(context.scene, shadowRay, distance)) return null;
  const w = (light.radiance * light.radius ** 2) / (distance * distance);
  return scale(reflected(hit, light, l, v), w);
}

/** `direction` is that of the ray which hit. */
export function shade(context: ShadeContext, hit: SurfaceHit, direction: Vec3): Color {
  const n = context.lightSamples;
  const v = scale(direction, -1);
  let sum: Color = [0, 0, 0];
  context.scene.lights.forEach((light, index) => {
    sum = add(sum, multiply(light.ambient, hit.baseColor));
    for (const offset of samplePoints(n, lightRandoms(context.hash, index, context.reflection))) {
      const term = fromSamplePoint(context, hit, v, light, addScaled(light.center, offset, light.radius));
      if (term !== null) sum = addScaled(sum, term, 1 / n);
    }
  });
  return sum;
}
