/** How likely each of several lights is to be chosen at a point: in proportion to an estimate of its irradiance there. */
import type { Color, Vec3 } from '../../scene/scene.ts';
import { add, addScaled, cross, dot, length, negate, normalize, scale, subtract } from '../../scene/vec3.ts';
import { type AreaEmitter, type Emitter, spotFalloff } from './emitter.ts';

const mean = ([r, g, b]: Color) => (r + g + b) / 3;

interface Ball {
  readonly center: Vec3;
  readonly radius: number;
}

export function boundsOf(e: AreaEmitter): Ball {
  if (e.kind === 'sphere') return e;
  if (e.kind === 'box') return { center: e.center, radius: length(e.halfSize) };
  const radius = Math.max(length(add(e.u, e.v)), length(subtract(e.u, e.v))) / 2;
  return { center: addScaled(addScaled(e.corner, e.u, 0.5), e.v, 0.5), radius };
}

/** The cosine to a ball with its radius added to either side: 0 when all of it is behind, right when it is far. */
const grownCosine = (height: number, distance: number, radius: number) =>
  Math.min(Math.max((height + radius) / (distance + radius), 0), 1);

/** `normal` null: light comes from both sides. */
function cosineTo(normal: Vec3 | null, toLight: Vec3, radius: number): number {
  return normal === null ? 1 : grownCosine(dot(normal, toLight), length(toLight), radius);
}

/** Without the cosine at the point: exact on the axis of a disc, and outside of a sphere. */
function unshadowed(e: AreaEmitter, toCenter: Vec3, radius: number): number {
  const distance2 = dot(toCenter, toCenter);
  if (e.kind === 'sphere') return (mean(e.radiance) * Math.PI * e.radius ** 2) / Math.max(distance2, e.radius ** 2);
  if (e.kind === 'box') {
    const [x, y, z] = scale(e.halfSize, 2);
    const area = 2 * (x * y + y * z + z * x);
    return (mean(e.radiance) * area) / 4 / Math.max(distance2, area / (4 * Math.PI));
  }
  const area = length(cross(e.u, e.v));
  const height = -dot(normalize(cross(e.u, e.v)), toCenter);
  const side = e.oneSided ? Math.max(height, 0) : Math.abs(height);
  if (side === 0) return 0;
  return (mean(e.radiance) * area * grownCosine(side, Math.sqrt(distance2), radius)) / (distance2 + area / Math.PI);
}

export function estimatedIrradiance(e: Emitter, point: Vec3, normal: Vec3 | null): number {
  if (e.kind === 'sky') return (Math.PI * (3 * mean(e.horizon) + mean(e.zenith))) / 4;
  if (e.kind === 'directional')
    return mean(e.irradiance) * cosineTo(normal, negate(e.direction), Math.sin(e.halfAngle));
  if (e.kind === 'point' || e.kind === 'spot') {
    const toLight = subtract(e.position, point);
    const falloff = e.kind === 'spot' ? spotFalloff(e, normalize(toLight)) : 1;
    return ((mean(e.intensity) * falloff) / dot(toLight, toLight)) * cosineTo(normal, toLight, 0);
  }
  const { center, radius } = boundsOf(e);
  const toCenter = subtract(center, point);
  return unshadowed(e, toCenter, radius) * cosineTo(normal, toCenter, radius);
}

export function choiceProbabilities(emitters: readonly Emitter[], point: Vec3, normal: Vec3 | null): number[] {
  if (emitters.length === 1) return [1];
  const weights = emitters.map((e) => estimatedIrradiance(e, point, normal));
  const total = weights.reduce((sum, w) => sum + w, 0);
  return weights.map((w) => (total > 0 ? w / total : 0));
}
