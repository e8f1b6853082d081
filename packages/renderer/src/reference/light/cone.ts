import type { Vec3 } from '../../scene/scene.ts';
import { add, cross, normalize, scale } from '../../scene/vec3.ts';
import type { Square } from './emitter.ts';

/** All directions less than an angle from an axis. */
export interface Cone {
  /** Unit. */
  readonly axis: Vec3;
  /** 1 − cos of that angle; the cone's solid angle is 2π times this. */
  readonly width: number;
}

export const wholeSphere: Cone = { axis: [0, 0, 1], width: 2 };

/** 1 − cos a = 2 sin²(a / 2). */
export const inCone = (axis: Vec3, halfAngle: number): Cone => ({ axis, width: 2 * Math.sin(halfAngle / 2) ** 2 });

/** Two unit vectors that make a right-handed frame with `axis` as its third. */
export function frameOf(axis: Vec3): [Vec3, Vec3] {
  const aside: Vec3 = Math.abs(axis[0]) < 0.5 ? [1, 0, 0] : [0, 1, 0];
  const x = normalize(cross(aside, axis));
  return [x, cross(axis, x)];
}

/** A direction uniform in the cone, which has the same density everywhere. */
export function coneDirection({ axis, width }: Cone, [u1, u2]: Square): { direction: Vec3; pdf: number } {
  const cosine = 1 - u1 * width;
  const sine = Math.sqrt(Math.max(u1 * width * (1 + cosine), 0));
  const [x, y] = frameOf(axis);
  const phi = 2 * Math.PI * u2;
  const aside = add(scale(x, sine * Math.cos(phi)), scale(y, sine * Math.sin(phi)));
  return { direction: normalize(add(aside, scale(axis, cosine))), pdf: 1 / (2 * Math.PI * width) };
}
