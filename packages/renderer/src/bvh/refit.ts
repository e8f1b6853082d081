/** Bounds of a tree over triangles that moved: same triangles, same nodes. */
import { uniteUpwards } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';

/**
 * The leaves, by the least number of their vertices: positions are then read nearly from the first to the last, whatever order the
 * triangles have. A read that misses the caches is waited for; a write is not. Triangles of a leaf share about half of their
 * corners, and each vertex of a leaf is there once.
 */
export interface RefitPlan {
  readonly leaves: Uint32Array;
  readonly vertices: Uint32Array;
  /** Where those of each leaf begin in `vertices`, and where the last ones end. */
  readonly begins: Uint32Array;
}

function leavesOf({ nodeCount, links }: Bvh): Uint32Array {
  const leaves = new Uint32Array(nodeCount);
  let count = 0;
  for (let i = 0; i < nodeCount; i++) if (links[2 * i + 1] !== 0) leaves[count++] = i;
  return leaves.slice(0, count);
}

function leastVertex({ links, order }: Bvh, leaf: number, indices: Uint32Array): number {
  let least = Infinity;
  for (let place = links[2 * leaf]!, left = links[2 * leaf + 1]!; left > 0; place++, left--) {
    const at = 3 * order[place]!;
    least = Math.min(least, indices[at]!, indices[at + 1]!, indices[at + 2]!);
  }
  return least;
}

/** A counting sort; those with the same key stay in their order. */
function sortByKey(items: Uint32Array, keys: Uint32Array): Uint32Array {
  const places = new Uint32Array(keys.reduce((most, key) => Math.max(most, key), 0) + 2);
  for (const key of keys) places[key + 1]!++;
  for (let key = 1; key < places.length; key++) places[key]! += places[key - 1]!;
  const sorted = new Uint32Array(items.length);
  for (let i = 0; i < items.length; i++) sorted[places[keys[i]!]!++] = items[i]!;
  return sorted;
}

function includes(vertices: Uint32Array, begin: number, end: number, vertex: number): boolean {
  for (let k = begin; k < end; k++) if (vertices[k] === vertex) return true;
  return false;
}

/** Made once for a tree and the mesh that it was built over. */
export function planRefit(bvh: Bvh, { indices }: Pick<TriangleMesh, 'indices'>): RefitPlan {
  const { primitiveCount, links, order } = bvh;
  if (indices.length !== 3 * primitiveCount) {
    throw new RangeError(`The tree has ${primitiveCount} triangles, the mesh ${indices.length / 3}`);
  }
  const unsorted = leavesOf(bvh);
  const leaves = sortByKey(
    unsorted,
    unsorted.map((leaf) => leastVertex(bvh, leaf, indices)),
  );
  const vertices = new Uint32Array(indices.length);
  const begins = new Uint32Array(leaves.length + 1);
  let end = 0;
  for (let k = 0; k < leaves.length; k++) {
    const leaf = leaves[k]!;
    begins[k] = end;
    for (let place = links[2 * leaf]!, left = links[2 * leaf + 1]!; left > 0; place++, left--) {
      for (let corner = 3 * order[place]!; corner < 3 * order[place]! + 3; corner++) {
        if (!includes(vertices, begins[k]!, end, indices[corner]!)) vertices[end++] = indices[corner]!;
      }
    }
  }
  begins[leaves.length] = end;
  return { leaves, vertices: vertices.slice(0, end), begins };
}

/** The box of some vertices. Returns the sum of all coordinates, which is finite if all of them are. */
function boundVertices(
  positions: Float32Array,
  vertices: Uint32Array,
  begin: number,
  end: number,
  bounds: Float32Array,
  to: number,
): number {
  let v = vertices[begin]! * 3;
  let x0 = positions[v]!;
  let y0 = positions[v + 1]!;
  let z0 = positions[v + 2]!;
  let x1 = x0;
  let y1 = y0;
  let z1 = z0;
  let sum = x0 + y0 + z0;
  for (let k = begin + 1; k < end; k++) {
    v = vertices[k]! * 3;
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

function boundLeaves(bounds: Float32Array, positions: Float32Array, { leaves, vertices, begins }: RefitPlan): number {
  let sum = 0;
  for (let k = 0; k < leaves.length; k++) {
    sum += boundVertices(positions, vertices, begins[k]!, begins[k + 1]!, bounds, 6 * leaves[k]!);
  }
  return sum;
}

/**
 * Writes the bounds anew. The tree stays correct however far the triangles went, but it was made for where they had been: its
 * `sahCost` tells when building anew pays. Throws a RangeError when a position is missing or not finite; then the bounds are of
 * no use.
 */
export function refit({ nodeCount, links, bounds }: Bvh, positions: Float32Array, plan: RefitPlan): void {
  if (!Number.isFinite(boundLeaves(bounds, positions, plan))) {
    throw new RangeError('A position is not finite, or an index leads nowhere');
  }
  uniteUpwards(nodeCount, links, bounds);
}
