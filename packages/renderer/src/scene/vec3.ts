/** Vector algebra: plain functions on the scene's own `Vec3`, in double precision. */
import type { Quaternion } from './nodes.ts';
import type { Vec3 } from './scene.ts';

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vec3): number => Math.sqrt(dot(a, a));
export const negate = (a: Vec3): Vec3 => [-a[0], -a[1], -a[2]];

export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** a + s·b: the point at distance s along a ray, among other things. */
export const addScaled = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s];

export const normalize = (a: Vec3): Vec3 => scale(a, 1 / length(a));

/** `direction` mirrored at a surface with this unit normal; either side's normal gives the same. */
export const reflect = (direction: Vec3, normal: Vec3): Vec3 =>
  addScaled(direction, normal, -2 * dot(direction, normal));

/** Turns `v` about the world's X, then Y, then Z axis: R = Rz·Ry·Rx, degrees. */
export function rotate(v: Vec3, degrees: Vec3): Vec3 {
  const [cx, cy, cz] = degrees.map((d) => Math.cos((d * Math.PI) / 180)) as [number, number, number];
  const [sx, sy, sz] = degrees.map((d) => Math.sin((d * Math.PI) / 180)) as [number, number, number];
  const [x, y, z] = v;
  const aboutX: Vec3 = [x, cx * y - sx * z, sx * y + cx * z];
  const aboutY: Vec3 = [cy * aboutX[0] + sy * aboutX[2], aboutX[1], cy * aboutX[2] - sy * aboutX[0]];
  return [cz * aboutY[0] - sz * aboutY[1], sz * aboutY[0] + cz * aboutY[1], aboutY[2]];
}

/** The same turn as `rotate` makes, as a quaternion. */
export function quaternionOf(degrees: Vec3): Quaternion {
  const [cx, cy, cz] = degrees.map((d) => Math.cos((d * Math.PI) / 360)) as [number, number, number];
  const [sx, sy, sz] = degrees.map((d) => Math.sin((d * Math.PI) / 360)) as [number, number, number];
  return [
    sx * cy * cz - cx * sy * sz,
    cx * sy * cz + sx * cy * sz,
    cx * cy * sz - sx * sy * cz,
    cx * cy * cz + sx * sy * sz,
  ];
}
