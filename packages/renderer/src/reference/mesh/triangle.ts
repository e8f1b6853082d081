/**
 * Where a ray meets a triangle, without gaps between neighbours: S. Woop, C. Benthin and I. Wald, "Watertight Ray/Triangle
 * Intersection", JCGT 2(1), 2013, in double precision. Both neighbours of an edge work out the very same number for it, so that one
 * of them is met by every ray through it.
 */
import type { Vec3 } from '../../scene/scene.ts';

/** A ray in the mesh's own space; its direction need not have length 1, and t counts in it. */
export interface MeshRay {
  readonly origin: Vec3;
  readonly direction: Vec3;
  /** The axis along which the direction is longest, and the two after it, right-handed as seen along the ray. */
  readonly axes: readonly [x: Axis, y: Axis, z: Axis];
  readonly shear: Vec3;
}
type Axis = 0 | 1 | 2;

export function meshRay(origin: Vec3, direction: Vec3): MeshRay {
  const [x, y, z] = direction.map(Math.abs) as [number, number, number];
  const along: Axis = x > y ? (x > z ? 0 : 2) : y > z ? 1 : 2;
  const next = ((along + 1) % 3) as Axis;
  const last = ((along + 2) % 3) as Axis;
  const d = direction[along];
  // Turned the other way round when the ray goes backwards, so that triangles keep their sense.
  const axes = d < 0 ? ([last, next, along] as const) : ([next, last, along] as const);
  return { origin, direction, axes, shear: [direction[axes[0]] / d, direction[axes[1]] / d, 1 / d] };
}

export interface TriangleHit {
  readonly t: number;
  /** How much each vertex counts; together 1. */
  readonly weights: Vec3;
}

/** `a`, `b`, `c`: where the triangle's vertices begin in `positions`. The hit may lie behind the origin. */
export function intersectTriangle(
  { origin, axes: [kx, ky, kz], shear: [sx, sy, sz] }: MeshRay,
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
): TriangleHit | null {
  const az = positions[a + kz]! - origin[kz];
  const bz = positions[b + kz]! - origin[kz];
  const cz = positions[c + kz]! - origin[kz];
  const ax = positions[a + kx]! - origin[kx] - sx * az;
  const ay = positions[a + ky]! - origin[ky] - sy * az;
  const bx = positions[b + kx]! - origin[kx] - sx * bz;
  const by = positions[b + ky]! - origin[ky] - sy * bz;
  const cx = positions[c + kx]! - origin[kx] - sx * cz;
  const cy = positions[c + ky]! - origin[ky] - sy * cz;
  const u = cx * by - cy * bx;
  const v = ax * cy - ay * cx;
  const w = bx * ay - by * ax;
  if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return null;
  const sum = u + v + w;
  if (sum === 0) return null;
  const t = (sz * (u * az + v * bz + w * cz)) / sum;
  return { t, weights: [u / sum, v / sum, w / sum] };
}
