/** Unit vectors as two numbers of 16 bits, which shading/mesh/octahedral.wesl reads: Meyer et al. 2010. Off by at most 6.5e-5 radians. */
const HALF = 32767;

/** `normals[at]` and the two after it: any length but 0; a vector of length 0 counts as +Z. */
export function toOctahedral(normals: ArrayLike<number>, at: number): number {
  const x = normals[at]!;
  const y = normals[at + 1]!;
  const z = normals[at + 2]!;
  const size = Math.abs(x) + Math.abs(y) + Math.abs(z);
  if (!(size > 0)) return code(0, 0);
  const u = x / size;
  const v = y / size;
  if (z >= 0) return code(u, v);
  return code((1 - Math.abs(v)) * (x < 0 ? -1 : 1), (1 - Math.abs(u)) * (y < 0 ? -1 : 1));
}

const code = (u: number, v: number): number =>
  (Math.round(u * HALF + HALF) | (Math.round(v * HALF + HALF) << 16)) >>> 0;
