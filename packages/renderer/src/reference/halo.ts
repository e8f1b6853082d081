/** The glow of a light in haze: its falloff integrated along a ray. */
import type { Color, SphereLight } from '../scene/scene.ts';
import { add, addScaled, dot, length, scale, subtract } from '../scene/vec3.ts';
import { BLACK, type PreparedScene } from './prepare.ts';
import type { Ray } from './ray.ts';

/** How far a ray that hits nothing runs through the haze, metres. */
const HAZE_DEPTH = 1e5;

/** ∫₀ᵗ ds' / (b² + (s' − s)²), with b the ray's distance from the light (not below its radius) at the ray parameter s. */
export function falloffIntegral(light: SphereLight, ray: Ray, t: number): number {
  const toCenter = subtract(light.center, ray.origin);
  const s = dot(toCenter, ray.direction);
  const b = Math.max(length(addScaled(toCenter, ray.direction, -s)), light.radius);
  return (Math.atan((t - s) / b) + Math.atan(s / b)) / b;
}

/** halo(ray, distance): what all lights add between the ray's start and `distance`. */
export function halo(scene: PreparedScene, ray: Ray, distance: number): Color {
  let sum = BLACK;
  const t = Math.min(distance, HAZE_DEPTH);
  for (const light of scene.visibleLights) {
    if (light.halo === 0) continue;
    const strength = light.halo * light.radiance * light.radius ** 2 * falloffIntegral(light, ray, t);
    sum = add(sum, scale(light.diffuse, strength));
  }
  return sum;
}
