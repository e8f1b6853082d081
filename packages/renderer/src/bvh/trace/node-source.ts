/** What a traversal sees of any tree: nodes with up to eight children, each a box with an inner node or a leaf in it. */
import { type Bvh, firstChild, firstPlace, leafCount, secondChild } from '../bvh.ts';

/** The children of one node. A child with more than 0 primitives is a leaf. */
export interface Children {
  count: number;
  /** Six numbers a child: least x, y, z, greatest x, y, z. */
  readonly bounds: Float64Array;
  /** Primitives in the leaf, or 0. */
  readonly primitives: Int32Array;
  /** First place in the order, or the inner node. */
  readonly index: Int32Array;
}

export interface NodeSource {
  readonly root: number;
  readonly order: Uint32Array;
  /** Entries that the encoding promises to suffice for a stack. */
  readonly stackSize: number;
  readChildren(node: number, into: Children): void;
}

export const roomForChildren = (): Children => ({
  count: 0,
  bounds: new Float64Array(48),
  primitives: new Int32Array(8),
  index: new Int32Array(8),
});

export function addChild(into: Children, bounds: ArrayLike<number>, primitives: number, index: number): void {
  into.bounds.set(bounds, 6 * into.count);
  into.primitives[into.count] = primitives;
  into.index[into.count] = index;
  into.count++;
}

/** The neutral tree itself. Its root may be a leaf, so there is a node above it, −1, with the root as its only child. */
export function bvhSource(bvh: Bvh): NodeSource {
  const add = (node: number, into: Children) => {
    const count = leafCount(bvh, node);
    addChild(into, bvh.bounds.subarray(6 * node, 6 * node + 6), count, count > 0 ? firstPlace(bvh, node) : node);
  };
  return {
    root: -1,
    order: bvh.order,
    stackSize: bvh.depth,
    readChildren(node, into) {
      into.count = 0;
      if (bvh.nodeCount === 0) return;
      if (node < 0) return add(0, into);
      add(firstChild(node), into);
      add(secondChild(bvh, node), into);
    },
  };
}
