/** Bounds of a tree over triangles that moved: same triangles, same nodes. */
import { uniteUpwards } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';

/** The vertices of each leaf, each of them once: triangles of a leaf share about half of their corners. */
export interface RefitPlan {
  readonly vertices: Uint32Array;
  /** Where those of a node begin in `vertices`; those of an inner node end there too. One more than there are nodes. */
  readonly begins: Uint32Array;
}

function includes(vertices: Uint32Array, begin: number, end: number, vertex: number): boolean {
  for (let k = begin; k < end; k++) if (vertices[k] === vertex) return true;
  return false;
}

/** Made once for a tree. */
export function planRefit(bvh: Bvh, { indices }: Pick<TriangleMesh, 'indices'>): RefitPlan {
  const { nodeCount, primitiveCount, links, order } = bvh;
  if (indices.length !== 3 * primitiveCount) {
    throw new RangeError(`The tree has ${primitiveCount} triangles, the mesh ${indices.length / 3}`);
  }
  const vertices = new Uint32Array(indices.length);
  const begins = new Uint32Array(nodeCount + 1);
  let end = 0;
  for (let i = 0; i < nodeCount; i++) {
    begins[i] = end;
    for (let place = links[2 * i]!, left = links[2 * i + 1]!; left > 0; place++, left--) {
      for (let corner = 3 * order[place]!; corner < 3 * order[place]! + 3; corner++) {
        if (!includes(vertices, begins[i]!, end, indices[corner]!)) vertices[end++] = indices[corner]!;
      }
    }
  }
  begins[nodeCount] = end;
  return { vertices: vertices.slice(0, end), begins };
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

function boundLeaves(nodeCount: number, bounds: Float32Array, positions: Float32Array, plan: RefitPlan): number {
  const { vertices, begins } = plan;
  let sum = 0;
  for (let i = 0; i < nodeCount; i++) {
    const begin = begins[i]!;
    const end = begins[i + 1]!;
    if (end > begin) sum += boundVertices(positions, vertices, begin, end, bounds, 6 * i);
  }
  return sum;
}

/**
 * Writes the bounds anew. The tree stays correct however far the triangles went, but it was made for where they had been: its
 * `sahCost` tells when building anew pays. Throws a RangeError when a position is missing or not finite; then the bounds are of
 * no use.
 */
export function refit({ nodeCount, links, bounds }: Bvh, positions: Float32Array, plan: RefitPlan): void {
  if (!Number.isFinite(boundLeaves(nodeCount, bounds, positions, plan))) {
    throw new RangeError('A position is not finite, or an index leads nowhere');
  }
  uniteUpwards(nodeCount, links, bounds);
}
