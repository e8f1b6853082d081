/** Where a mesh stands: affine maps from its own space to the world, and what they do to points, directions and normals. */
import type { Matrix4, MeshShape, Vec3 } from './scene.ts';
import { cross, dot, length, rotate, scale } from './vec3.ts';
import { SHORTEST, SMALLEST_SINE } from './well-formed.ts';

/** p ↦ x · p.x + y · p.y + z · p.z + origin: where the axes and the origin go. */
export interface Placement {
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
  readonly origin: Vec3;
}

export const AT_HOME: Placement = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], origin: [0, 0, 0] };

/** From the mesh's own space to the world (or, where the shape names a node, to the node's). */
export function placementOf({ translation, rotation, scale: [sx, sy, sz], matrix }: MeshShape): Placement {
  const outer: Placement = {
    x: rotate([sx, 0, 0], rotation),
    y: rotate([0, sy, 0], rotation),
    z: rotate([0, 0, sz], rotation),
    origin: translation,
  };
  return matrix ? after(outer, fromMatrix(matrix)) : outer;
}

/** The columns of a matrix given row by row. Its last row is taken for 0 0 0 1. */
export function fromMatrix(m: Matrix4): Placement {
  const column = (c: number): Vec3 => [m[c]!, m[4 + c]!, m[8 + c]!];
  return { x: column(0), y: column(1), z: column(2), origin: column(3) };
}

/** Row by row, as `fromMatrix` reads it. */
export function toMatrix({ x, y, z, origin }: Placement): Matrix4 {
  const row = (r: 0 | 1 | 2) => [x[r], y[r], z[r], origin[r]];
  return [...row(0), ...row(1), ...row(2), 0, 0, 0, 1];
}

/** First `inner`, then `outer`. */
export const after = (outer: Placement, inner: Placement): Placement => ({
  x: placeDirection(outer, inner.x),
  y: placeDirection(outer, inner.y),
  z: placeDirection(outer, inner.z),
  origin: placePoint(outer, inner.origin),
});

export const placeDirection = ({ x, y, z }: Placement, d: Vec3): Vec3 => [
  x[0] * d[0] + y[0] * d[1] + z[0] * d[2],
  x[1] * d[0] + y[1] * d[1] + z[1] * d[2],
  x[2] * d[0] + y[2] * d[1] + z[2] * d[2],
];

export function placePoint(placement: Placement, p: Vec3): Vec3 {
  const [a, b, c] = placeDirection(placement, p);
  const { origin } = placement;
  return [a + origin[0], b + origin[1], c + origin[2]];
}

/** Below 0: mirrored, so that triangles change the sense in which their vertices follow one another. */
export const determinant = ({ x, y, z }: Placement): number => dot(x, cross(y, z));

/**
 * The way back. Its rows are what normals go by (the inverse transpose): an outward normal stays outward, mirrored or not. The
 * placement must not be flat.
 */
export function inverse(placement: Placement): Placement {
  const { x, y, z, origin } = placement;
  const volume = determinant(placement);
  const [a, b, c] = [scale(cross(y, z), 1 / volume), scale(cross(z, x), 1 / volume), scale(cross(x, y), 1 / volume)];
  const back = (p: Vec3): Vec3 => [dot(a, p), dot(b, p), dot(c, p)];
  return {
    x: [a[0], b[0], c[0]],
    y: [a[1], b[1], c[1]],
    z: [a[2], b[2], c[2]],
    origin: back([-origin[0], -origin[1], -origin[2]]),
  };
}

/** A normal of the mesh in the world, not of length 1; `back` is the inverse of the mesh's placement. */
export const placeNormal = ({ x, y, z }: Placement, n: Vec3): Vec3 => [dot(x, n), dot(y, n), dot(z, n)];

/** Whether it keeps three dimensions, so that there is a way back. */
export function isSolid({ x, y, z }: Placement): boolean {
  const [a, b, c] = [length(x), length(y), length(z)];
  if (!(Math.min(a, b, c) >= SHORTEST)) return false;
  return Math.abs(determinant({ ...AT_HOME, x: scale(x, 1 / a), y: scale(y, 1 / b), z: scale(z, 1 / c) })) >= SMALLEST_SINE; // biome-ignore format: one thought
}
