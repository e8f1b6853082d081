/**
 * The watertight triangle test of Woop, Benthin and Wald (2013), in double precision: space is sheared so that the ray is the z axis
 * and starts at 0; then the signs of three cross products say on which side of the edges it passes. An edge gives exactly opposite
 * numbers for the two triangles that share it, so no ray slips between them. For tests: kernels have their own.
 */
export interface Ray {
  readonly origin: readonly [number, number, number];
  /** Not zero; any length. Distances are in units of it. */
  readonly direction: readonly [number, number, number];
  /** Hits count from tMin to tMax, both included. */
  readonly tMin: number;
  readonly tMax: number;
}

/** A ray with what is the same for all triangles. */
export interface ShearedRay extends Ray {
  readonly axes: readonly [number, number, number];
  readonly shear: readonly [number, number, number];
}

export function shearRay(ray: Ray): ShearedRay {
  const { direction } = ray;
  const [dx, dy, dz] = direction.map(Math.abs) as [number, number, number];
  const kz = dx > dy ? (dx > dz ? 0 : 2) : dy > dz ? 1 : 2;
  let kx = (kz + 1) % 3;
  let ky = (kx + 1) % 3;
  if (direction[kz]! < 0) [kx, ky] = [ky, kx];
  const shear = [direction[kx]! / direction[kz]!, direction[ky]! / direction[kz]!, 1 / direction[kz]!] as const;
  return { ...ray, axes: [kx, ky, kz], shear };
}

/** Seen from its edge, or from too far to be seen at all, a triangle has nothing but roundings for an area, and is missed. */
const EDGE_ON = 16 * 2 ** -53;

export interface TriangleHit {
  readonly t: number;
  /** Barycentric weights of the second and third corner. */
  readonly u: number;
  readonly v: number;
}

/** `corners`: nine coordinates. */
export function hitTriangle(ray: ShearedRay, corners: ArrayLike<number>): TriangleHit | null {
  const [kx, ky, kz] = ray.axes;
  const [sx, sy, sz] = ray.shear;
  const seen = (corner: number): readonly [number, number, number] => {
    const x = corners[3 * corner + kx]! - ray.origin[kx]!;
    const y = corners[3 * corner + ky]! - ray.origin[ky]!;
    const z = corners[3 * corner + kz]! - ray.origin[kz]!;
    return [x - sx * z, y - sy * z, sz * z];
  };
  const [ax, ay, az] = seen(0);
  const [bx, by, bz] = seen(1);
  const [cx, cy, cz] = seen(2);
  const [p, q, r] = [cx * by, ax * cy, bx * ay];
  const [p2, q2, r2] = [cy * bx, ay * cx, by * ax];
  const [a, b, c] = [p - p2, q - q2, r - r2];
  if ((a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0)) return null;
  const sum = a + b + c;
  const largest = Math.max(Math.abs(p), Math.abs(q), Math.abs(r), Math.abs(p2), Math.abs(q2), Math.abs(r2));
  if (Math.abs(sum) <= EDGE_ON * largest) return null;
  const t = (a * az + b * bz + c * cz) / sum;
  return t >= ray.tMin && t <= ray.tMax ? { t, u: b / sum, v: c / sum } : null;
}
