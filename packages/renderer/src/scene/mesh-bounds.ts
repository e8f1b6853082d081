/** The box around a mesh, in its own space or in the world. */
import type { Mesh } from './mesh.ts';
import { type Placement, placePoint } from './placement.ts';
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

function boundsOf(positions: Float32Array): Bounds {
  const min = [Infinity, Infinity, Infinity] as [number, number, number];
  const max = [-Infinity, -Infinity, -Infinity] as [number, number, number];
  for (let k = 0; k < positions.length; k += 3)
    for (let c = 0; c < 3; c++) {
      const p = positions[k + c]!;
      if (p < min[c]!) min[c] = p;
      if (p > max[c]!) max[c] = p;
    }
  return { min, max };
}

/** The box around the eight corners of the box, placed: at least as large as the one around the placed vertices. */
export function placedBounds({ min, max }: Bounds, placement: Placement): Bounds {
  const low = [Infinity, Infinity, Infinity] as [number, number, number];
  const high = [-Infinity, -Infinity, -Infinity] as [number, number, number];
  for (let corner = 0; corner < 8; corner++) {
    const pick = (c: 0 | 1 | 2) => (corner & (1 << c) ? max[c] : min[c]);
    const p = placePoint(placement, [pick(0), pick(1), pick(2)]);
    for (let c = 0; c < 3; c++) {
      low[c] = Math.min(low[c]!, p[c]!);
      high[c] = Math.max(high[c]!, p[c]!);
    }
  }
  return { min: low, max: high };
}
