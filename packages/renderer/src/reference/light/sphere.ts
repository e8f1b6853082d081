/** Glowing spheres fill a cone: Shirley, Wang & Zimmerman 1996; pbrt-v4, section 6.2.4. From inside they fill everything. */
import type { Vec3 } from '../../scene/scene.ts';
import { addScaled, dot, length, normalize, scale, subtract } from '../../scene/vec3.ts';
import { type Cone, coneDirection, inCone, wholeSphere } from './cone.ts';
import type { LightSample, Meeting, SphereEmitter, Square } from './emitter.ts';

const isInside = ({ center, radius }: SphereEmitter, point: Vec3) => length(subtract(center, point)) <= radius;

function coneOf(e: SphereEmitter, point: Vec3): Cone {
  if (isInside(e, point)) return wholeSphere;
  const toCenter = subtract(e.center, point);
  const distance = length(toCenter);
  return inCone(scale(toCenter, 1 / distance), Math.asin(e.radius / distance));
}

export function metSphere(e: SphereEmitter, origin: Vec3, direction: Vec3): Meeting | null {
  const toCenter = subtract(e.center, origin);
  const along = dot(toCenter, direction);
  const across = addScaled(toCenter, direction, -along);
  const halfChord2 = e.radius ** 2 - dot(across, across);
  if (halfChord2 < 0) return null;
  const halfChord = Math.sqrt(halfChord2);
  const distance = isInside(e, origin) ? along + halfChord : along - halfChord;
  if (!(distance > 0)) return null;
  return { distance, normal: normalize(subtract(scale(direction, distance), toCenter)) };
}

export function sampleSphere(e: SphereEmitter, point: Vec3, u: Square): LightSample {
  const { direction, pdf } = coneDirection(coneOf(e, point), u);
  // At the cone's very rim rounding may miss the sphere.
  const rim = Math.max(dot(subtract(e.center, point), direction), 0);
  return {
    direction,
    pdf,
    distance: metSphere(e, point, direction)?.distance ?? rim,
    radiance: e.radiance,
    delta: false,
  };
}

export const spherePdf = (e: SphereEmitter, point: Vec3): number => 1 / (2 * Math.PI * coneOf(e, point).width);
