/** Bounds of a tree over triangles that moved: same triangles, same nodes. */
import { uniteUpwards } from './bounds.ts';
import type { Bvh } from './bvh.ts';

/** Indices in the order of the tree's places, as leaves want them, here and on a GPU: place k has corners 3 k … 3 k + 2. */
export function indicesByPlace(indices: Uint32Array, order: Uint32Array): Uint32Array<ArrayBuffer> {
  const placed = new Uint32Array(order.length * 3);
  for (let k = 0; k < order.length; k++) {
    const i = order[k]! * 3;
    placed[3 * k] = indices[i]!;
    placed[3 * k + 1] = indices[i + 1]!;
    placed[3 * k + 2] = indices[i + 2]!;
  }
  return placed;
}

/** The box of the corners from begin to end. Returns the sum of all coordinates, which is finite if all of them are. */
function boundCorners(
  positions: Float32Array,
  placed: Uint32Array,
  begin: number,
  end: number,
  bounds: Float32Array,
  to: number,
): number {
  let v = placed[begin]! * 3;
  let x0 = positions[v]!;
  let y0 = positions[v + 1]!;
  let z0 = positions[v + 2]!;
  let x1 = x0;
  let y1 = y0;
  let z1 = z0;
  let sum = x0 + y0 + z0;
  for (let corner = begin + 1; corner < end; corner++) {
    v = placed[corner]! * 3;
    const x = positions[v]!;
    const y = positions[v + 1]!;
    const z = positions[v + 2]!;
    if (x < x0) x0 = x;
    else if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    else if (y > y1) y1 = y;
    if (z < z0) z0 = z;
    else if (z > z1) z1 = z;
    sum += x + y + z;
  }
  bounds[to] = x0;
  bounds[to + 1] = y0;
  bounds[to + 2] = z0;
  bounds[to + 3] = x1;
  bounds[to + 4] = y1;
  bounds[to + 5] = z1;
  return sum;
}

function boundLeaves({ nodeCount, links, bounds }: Bvh, positions: Float32Array, placed: Uint32Array): number {
  let sum = 0;
  for (let i = 0; i < nodeCount; i++) {
    const count = links[2 * i + 1]!;
    if (count === 0) continue;
    const begin = 3 * links[2 * i]!;
    sum += boundCorners(positions, placed, begin, begin + 3 * count, bounds, 6 * i);
  }
  return sum;
}

/**
 * Writes the bounds anew, from positions and `indicesByPlace`. The tree stays correct however far the triangles went, but it was made
 * for where they had been: its `sahCost` tells when building anew pays. Throws a RangeError when a position is missing or not
 * finite; then the bounds are of no use.
 */
export function refit(bvh: Bvh, positions: Float32Array, placed: Uint32Array): void {
  if (placed.length < 3 * bvh.primitiveCount) {
    throw new RangeError(`${placed.length} indices are less than three for each of ${bvh.primitiveCount} triangles`);
  }
  if (!Number.isFinite(boundLeaves(bvh, positions, placed))) {
    throw new RangeError('A position is not finite, or an index leads nowhere');
  }
  uniteUpwards(bvh.nodeCount, bvh.links, bvh.bounds);
}
