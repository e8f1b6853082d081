/**
 * Affine maps as the first three rows of a 4 × 4 matrix for column vectors, row by row: 12 numbers from a place of an array on. Plain
 * functions that write where they are told, so that a thousand matrices cost no object; what frames call writes each number out, as an
 * engine does not always see through a list that is taken apart at once.
 */
import type { Quaternion } from './nodes.ts';
import type { Vec3 } from './scene.ts';
import { SHORTEST, SMALLEST_SINE } from './well-formed.ts';

/** What can be read as numbers; what can be written too. */
export type Numbers = ArrayLike<number>;
export type WritableNumbers = { [index: number]: number; readonly length: number };

export const AFFINE_LENGTH = 12;
export const IDENTITY: readonly number[] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

/** out = translation · rotation · scale. The rotation need not have length 1; one of no length is no turn. */
export function composeAffine(
  out: WritableNumbers,
  at: number,
  t: Numbers,
  ti: number,
  q: Numbers,
  qi: number,
  s: Numbers,
  si: number,
): void {
  const x = q[qi]!;
  const y = q[qi + 1]!;
  const z = q[qi + 2]!;
  const w = q[qi + 3]!;
  const square = x * x + y * y + z * z + w * w;
  const two = square > 0 ? 2 / square : 0;
  const xx = x * x * two;
  const yy = y * y * two;
  const zz = z * z * two;
  const xy = x * y * two;
  const xz = x * z * two;
  const yz = y * z * two;
  const wx = w * x * two;
  const wy = w * y * two;
  const wz = w * z * two;
  const sx = s[si]!;
  const sy = s[si + 1]!;
  const sz = s[si + 2]!;
  out[at] = (1 - yy - zz) * sx;
  out[at + 1] = (xy - wz) * sy;
  out[at + 2] = (xz + wy) * sz;
  out[at + 3] = t[ti]!;
  out[at + 4] = (xy + wz) * sx;
  out[at + 5] = (1 - xx - zz) * sy;
  out[at + 6] = (yz - wx) * sz;
  out[at + 7] = t[ti + 1]!;
  out[at + 8] = (xz - wy) * sx;
  out[at + 9] = (yz + wx) * sy;
  out[at + 10] = (1 - xx - yy) * sz;
  out[at + 11] = t[ti + 2]!;
}

/** out = a · b. `out` may be the place of `b`, but not of `a`. */
export function multiplyAffine(out: WritableNumbers, at: number, a: Numbers, ai: number, b: Numbers, bi: number): void {
  for (let column = 0; column < 4; column++) {
    const [b0, b1, b2] = [b[bi + column]!, b[bi + 4 + column]!, b[bi + 8 + column]!];
    for (let row = 0; row < 3; row++) {
      const r = ai + 4 * row;
      const moved = column === 3 ? a[r + 3]! : 0;
      out[at + 4 * row + column] = a[r]! * b0 + a[r + 1]! * b1 + a[r + 2]! * b2 + moved;
    }
  }
}

/**
 * The same for what is multiplied by the thousand in a frame: one kind of array alone, or an engine makes an object of every number that it
 * reads.
 */
export function multiplyMatrices(
  out: Float64Array,
  at: number,
  a: Float64Array,
  ai: number,
  b: Float64Array,
  bi: number,
): void {
  for (let column = 0; column < 4; column++) {
    const x = b[bi + column]!;
    const y = b[bi + 4 + column]!;
    const z = b[bi + 8 + column]!;
    const w = column === 3 ? 1 : 0;
    out[at + column] = a[ai]! * x + a[ai + 1]! * y + a[ai + 2]! * z + a[ai + 3]! * w;
    out[at + 4 + column] = a[ai + 4]! * x + a[ai + 5]! * y + a[ai + 6]! * z + a[ai + 7]! * w;
    out[at + 8 + column] = a[ai + 8]! * x + a[ai + 9]! * y + a[ai + 10]! * z + a[ai + 11]! * w;
  }
}

export function copyAffine(out: WritableNumbers, at: number, from: Numbers, fi = 0): void {
  for (let i = 0; i < AFFINE_LENGTH; i++) out[at + i] = from[fi + i]!;
}

export const transformPoint = (m: Numbers, at: number, [x, y, z]: Vec3): Vec3 => [
  m[at]! * x + m[at + 1]! * y + m[at + 2]! * z + m[at + 3]!,
  m[at + 4]! * x + m[at + 5]! * y + m[at + 6]! * z + m[at + 7]!,
  m[at + 8]! * x + m[at + 9]! * y + m[at + 10]! * z + m[at + 11]!,
];

export const transformDirection = (m: Numbers, at: number, [x, y, z]: Vec3): Vec3 => [
  m[at]! * x + m[at + 1]! * y + m[at + 2]! * z,
  m[at + 4]! * x + m[at + 5]! * y + m[at + 6]! * z,
  m[at + 8]! * x + m[at + 9]! * y + m[at + 10]! * z,
];

/** The normal of a surface where the surface has gone; not of length 1. `back` is the inverse of the way it went: an outward one stays so. */
export const transformNormal = (back: Numbers, at: number, [x, y, z]: Vec3): Vec3 => [
  back[at]! * x + back[at + 4]! * y + back[at + 8]! * z,
  back[at + 1]! * x + back[at + 5]! * y + back[at + 9]! * z,
  back[at + 2]! * x + back[at + 6]! * y + back[at + 10]! * z,
];

/** The cofactors, row by row: what normals are multiplied with, as they need the inverse transposed up to a factor. */
export const cofactors = (m: Numbers, at: number): number[] => {
  const [a, b, c] = [m[at]!, m[at + 1]!, m[at + 2]!];
  const [d, e, f] = [m[at + 4]!, m[at + 5]!, m[at + 6]!];
  const [g, h, i] = [m[at + 8]!, m[at + 9]!, m[at + 10]!];
  return [e * i - f * h, f * g - d * i, d * h - e * g, c * h - b * i, a * i - c * g, b * g - a * h, b * f - c * e, c * d - a * f, a * e - b * d]; // biome-ignore format: a matrix
};

/** The determinant: negative where the map makes mirror images, whose triangles are seen the other way round. */
export function determinant(m: Numbers, at = 0): number {
  const c = cofactors(m, at);
  return m[at]! * c[0]! + m[at + 1]! * c[1]! + m[at + 2]! * c[2]!;
}

/** Whether it keeps three dimensions, so that there is a way back. */
export function isSolid(m: Numbers, at = 0): boolean {
  const a = m[at]!;
  const b = m[at + 1]!;
  const c = m[at + 2]!;
  const d = m[at + 4]!;
  const e = m[at + 5]!;
  const f = m[at + 6]!;
  const g = m[at + 8]!;
  const h = m[at + 9]!;
  const i = m[at + 10]!;
  const x = Math.sqrt(a * a + d * d + g * g);
  const y = Math.sqrt(b * b + e * e + h * h);
  const z = Math.sqrt(c * c + f * f + i * i);
  if (!(x >= SHORTEST && y >= SHORTEST && z >= SHORTEST)) return false;
  const volume = (a / x) * (e * i - f * h) + (b / x) * (f * g - d * i) + (c / x) * (d * h - e * g);
  return Math.abs(volume) >= SMALLEST_SINE * y * z;
}

/** The inverse, or null when there is none. */
export function invertAffine(m: Numbers, at = 0): number[] | null {
  const c = cofactors(m, at);
  const d = m[at]! * c[0]! + m[at + 1]! * c[1]! + m[at + 2]! * c[2]!;
  if (d === 0 || !Number.isFinite(1 / d)) return null;
  const out: number[] = [];
  for (let row = 0; row < 3; row++) {
    const r = [c[row]! / d, c[row + 3]! / d, c[row + 6]! / d] as const;
    out.push(...r, -(r[0] * m[at + 3]! + r[1] * m[at + 7]! + r[2] * m[at + 11]!));
  }
  return out;
}

/** The turn between a and b by the share u of the shorter arc (Shoemake 1985); both of length 1. Written into `out`. */
export function slerp(
  out: WritableNumbers,
  at: number,
  a: Numbers,
  ai: number,
  b: Numbers,
  bi: number,
  u: number,
): void {
  let dot = a[ai]! * b[bi]! + a[ai + 1]! * b[bi + 1]! + a[ai + 2]! * b[bi + 2]! + a[ai + 3]! * b[bi + 3]!;
  const sign = dot < 0 ? -1 : 1;
  dot *= sign;
  let wa = 1 - u;
  let wb = u * sign;
  // Closer than this the sines lose their digits, and a straight line is as good.
  if (dot < 0.9999) {
    const angle = Math.acos(dot);
    const s = 1 / Math.sin(angle);
    wa = Math.sin(wa * angle) * s;
    wb = Math.sin(u * angle) * s * sign;
  }
  for (let i = 0; i < 4; i++) out[at + i] = wa * a[ai + i]! + wb * b[bi + i]!;
  normalizeQuaternion(out, at);
}

/** Gives a quaternion length 1; one of no length, or with what is no number, becomes no turn. */
export function normalizeQuaternion(q: WritableNumbers, at: number): void {
  const x = q[at]!;
  const y = q[at + 1]!;
  const z = q[at + 2]!;
  const w = q[at + 3]!;
  const square = x * x + y * y + z * z + w * w;
  const good = square > 0 && square < Number.POSITIVE_INFINITY;
  const f = good ? 1 / Math.sqrt(square) : 0;
  q[at] = good ? x * f : 0;
  q[at + 1] = good ? y * f : 0;
  q[at + 2] = good ? z * f : 0;
  q[at + 3] = good ? w * f : 1;
}

export const toQuaternion = (x: number, y: number, z: number, w: number): Quaternion => {
  const q: [number, number, number, number] = [x, y, z, w];
  normalizeQuaternion(q, 0);
  return q;
};
