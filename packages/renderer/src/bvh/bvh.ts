/**
 * The neutral tree: what every builder gives, what every encoder reads. A binary bounding volume hierarchy in flat arrays,
 * nodes in depth-first order, so that the first child of inner node i is i + 1 and a subtree is one piece of memory.
 * Primitives are numbers: triangles of a mesh or instances of a scene.
 */
export interface Bvh {
  /** 0 for no primitives. Arrays may be longer than what is in use: builders that work every frame keep theirs. */
  readonly nodeCount: number;
  /** Six floats a node: least x, y, z, greatest x, y, z. Exact: the union of what is below, nothing added. */
  readonly bounds: Float32Array;
  /**
   * Two words a node. Inner node: the number of its second child, 0. Leaf: its first place in `order`, and how many primitives
   * it has from there on, at least 1.
   */
  readonly links: Uint32Array;
  readonly primitiveCount: number;
  /** Which primitive stands at each place; a permutation. Leaves follow one another in it without gaps. */
  readonly order: Uint32Array;
  /** Most inner nodes on the way from the root to a leaf: what a stack needs that keeps one child while the other is entered. */
  readonly depth: number;
}

/** Three indices a triangle; three coordinates, x, y, z, a position. */
export interface TriangleMesh {
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
}

/** Primitives of node i; 0 when it is an inner node. */
export const leafCount = (bvh: Bvh, i: number): number => bvh.links[2 * i + 1]!;

/** First place in `order` of leaf i. */
export const firstPlace = (bvh: Bvh, i: number): number => bvh.links[2 * i]!;

export const firstChild = (i: number): number => i + 1;

export const secondChild = (bvh: Bvh, i: number): number => bvh.links[2 * i]!;

/** Half the surface of node i's box. */
export function halfArea(bvh: Bvh, i: number): number {
  const { bounds } = bvh;
  const dx = bounds[6 * i + 3]! - bounds[6 * i]!;
  const dy = bounds[6 * i + 4]! - bounds[6 * i + 1]!;
  const dz = bounds[6 * i + 5]! - bounds[6 * i + 2]!;
  return dx * (dy + dz) + dy * dz;
}

/** What tracing a ray costs; only the ratio counts. */
export interface TraceCosts {
  /** Of one inner node: both its children's boxes. */
  readonly node: number;
  readonly primitive: number;
}
export const DEFAULT_COSTS: TraceCosts = { node: 1, primitive: 1.25 };

/**
 * Expected cost of a random long ray that meets the root's box: the surface area heuristic (Goldsmith and Salmon 1987;
 * MacDonald and Booth 1990). Σ area(node)/area(root) · (node cost, or primitive cost × count at leaves).
 */
export function sahCost(bvh: Bvh, costs: TraceCosts = DEFAULT_COSTS): number {
  const { nodeCount, links, bounds } = bvh;
  const { node, primitive } = costs;
  let sum = 0;
  for (let i = 0, at = 0; i < nodeCount; i++, at += 6) {
    const count = links[2 * i + 1]!;
    const dx = bounds[at + 3]! - bounds[at]!;
    const dy = bounds[at + 4]! - bounds[at + 1]!;
    const dz = bounds[at + 5]! - bounds[at + 2]!;
    const area = dx * (dy + dz) + dy * dz;
    sum += count > 0 ? area * primitive * count : area * node;
  }
  return sum > 0 ? sum / halfArea(bvh, 0) : 0;
}
