/** Boxes along the axes: around the vertices of a mesh, and around a box that is placed. */
import { type Numbers, transformPoint } from './affine.ts';
import type { Mesh } from './mesh.ts';
import type { Vec3 } from './scene.ts';

export interface Bounds {
  readonly min: Vec3;
  readonly max: Vec3;
}

/** A mesh does not change. */
const known = new WeakMap<Mesh, Bounds>();

/** Around all vertices, also such as no triangle uses. */
export function meshBounds(mesh: Mesh): Bounds {
  let bounds = known.get(mesh);
  if (bounds === undefined) {
    bounds = boundsOf(mesh.positions);
    known.set(mesh, bounds);
  }
  return bounds;
}

/** Around points, three numbers each; all of them, or those marked in `used`. Without a point it ends before it begins. */
export function boundsOf(positions: Numbers, used?: Uint8Array): Bounds {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < positions.length; k += 3) {
    if (used && !used[k / 3]) continue;
    for (let c = 0; c < 3; c++) {
      const p = positions[k + c]!;
      if (p < min[c]!) min[c] = p;
      if (p > max[c]!) max[c] = p;
    }
  }
  return { min, max };
}

export const cornersOf = ({ min, max }: Bounds): Vec3[] =>
  Array.from({ length: 8 }, (_, i) => [i & 1 ? max[0] : min[0], i & 2 ? max[1] : min[1], i & 4 ? max[2] : min[2]]);

/** The box around the eight corners of the box, placed by 12 numbers: at least as large as the one around the placed vertices. */
export function placedBounds(bounds: Bounds, placement: Numbers): Bounds {
  const placed = cornersOf(bounds).flatMap((corner) => transformPoint(placement, 0, corner));
  return boundsOf(placed);
}
