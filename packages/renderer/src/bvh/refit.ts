/** Bounds of a tree over triangles that moved: same triangles, same nodes, one pass from the last node to the first. */
import { uniteUpwards } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';

/** Returns 0, or NaN when a coordinate is none; see primitive-boxes.ts. */
function boundLeaf(
  positions: Float32Array,
  indices: Uint32Array,
  order: Uint32Array,
  begin: number,
  end: number,
  bounds: Float32Array,
  to: number,
): number {
  let x0 = Infinity;
  let y0 = Infinity;
  let z0 = Infinity;
  let x1 = -Infinity;
  let y1 = -Infinity;
  let z1 = -Infinity;
  let finite = 0;
  for (let k = begin; k < end; k++) {
    const i = order[k]! * 3;
    for (let corner = i; corner < i + 3; corner++) {
      const v = indices[corner]! * 3;
      const x = positions[v]!;
      const y = positions[v + 1]!;
      const z = positions[v + 2]!;
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
      if (z < z0) z0 = z;
      if (z > z1) z1 = z;
      finite += (x + y + z) * 0;
    }
  }
  bounds[to] = x0;
  bounds[to + 1] = y0;
  bounds[to + 2] = z0;
  bounds[to + 3] = x1;
  bounds[to + 4] = y1;
  bounds[to + 5] = z1;
  return finite;
}

function boundLeaves({ nodeCount, links, order, bounds }: Bvh, { positions, indices }: TriangleMesh): number {
  let finite = 0;
  for (let i = 0; i < nodeCount; i++) {
    const count = links[2 * i + 1]!;
    if (count === 0) continue;
    const first = links[2 * i]!;
    finite += boundLeaf(positions, indices, order, first, first + count, bounds, 6 * i);
  }
  return finite;
}

/**
 * Writes the bounds anew. The tree stays correct however far the triangles went, but it was made for where they had been: its
 * `sahCost` tells when building anew pays. Throws a RangeError when a position is no place; then the bounds are of no use.
 */
export function refit(bvh: Bvh, mesh: TriangleMesh): void {
  if (mesh.indices.length !== 3 * bvh.primitiveCount) {
    throw new RangeError(`The tree has ${bvh.primitiveCount} triangles, the mesh ${mesh.indices.length / 3}`);
  }
  if (boundLeaves(bvh, mesh) !== 0) throw new RangeError('A position is not finite, or an index leads nowhere');
  uniteUpwards(bvh.nodeCount, bvh.links, bvh.bounds);
}
