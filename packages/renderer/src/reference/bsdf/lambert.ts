import type { Color, Vec3 } from '../../scene/scene.ts';
import { type Evaluation, mapColor } from './surface.ts';

/** albedo / π to all sides, sampled by the cosine. */
export function evaluateLambert(albedo: Color, wi: Vec3): Evaluation {
  return { value: mapColor(albedo, (a) => (a * wi[2]) / Math.PI), pdf: wi[2] / Math.PI };
}

/** Malley's method. */
export function sampleCosine(u: number, v: number): Vec3 {
  const radius = Math.sqrt(u);
  return [radius * Math.cos(2 * Math.PI * v), radius * Math.sin(2 * Math.PI * v), Math.sqrt(1 - u)];
}
