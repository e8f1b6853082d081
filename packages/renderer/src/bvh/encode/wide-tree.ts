/** A tree with more than two children a node, made of a binary one whose nodes it takes as children: what encoders write down. */
import { type Bvh, halfArea, leafCount } from '../bvh.ts';

export interface WideTree {
  readonly width: number;
  readonly nodeCount: number;
  /** `width` binary nodes a wide node, −1 where there is none. Wide nodes stand in depth-first order. */
  readonly children: Int32Array;
  /** One for each of `children`: 0 for an inner node, else the primitives of the leaf. */
  readonly counts: Uint32Array;
  /** One for each of `children`: the number of the wide node, or the first place of the leaf. */
  readonly indices: Uint32Array;
  readonly stackSize: number;
  readonly depth: number;
}

/** Makes a wide node's children of an inner binary node: nodes, and whether each is to be a leaf. */
export interface Opened {
  readonly node: number;
  readonly isLeaf: boolean;
}
export type Open = (node: number) => readonly Opened[];

/** Primitives below each node, and the first place they have. */
export function placesBelow(bvh: Bvh): { readonly first: Uint32Array; readonly count: Uint32Array } {
  const { nodeCount, links } = bvh;
  const first = new Uint32Array(nodeCount);
  const count = new Uint32Array(nodeCount);
  for (let i = nodeCount - 1; i >= 0; i--) {
    const second = links[2 * i]!;
    const isLeaf = leafCount(bvh, i) > 0;
    first[i] = isLeaf ? second : first[i + 1]!;
    count[i] = isLeaf ? leafCount(bvh, i) : count[i + 1]! + count[second]!;
  }
  return { first, count };
}

interface Waiting {
  readonly node: number;
  /** The slot that will have its number; −1 for the root. */
  readonly slot: number;
  readonly others: number;
  readonly level: number;
}

/** A root that is a leaf becomes the only child of a node; without primitives that has none. */
function rootOnly(bvh: Bvh, width: number): WideTree {
  const children = new Int32Array(width).fill(-1);
  const counts = new Uint32Array(width);
  if (bvh.nodeCount > 0) {
    children[0] = 0;
    counts[0] = leafCount(bvh, 0);
  }
  return { width, nodeCount: 1, children, counts, indices: new Uint32Array(width), stackSize: 0, depth: 1 };
}

export function wideTree(bvh: Bvh, width: number, open: Open): WideTree {
  if (bvh.nodeCount === 0 || leafCount(bvh, 0) > 0) return rootOnly(bvh, width);
  const { first, count } = placesBelow(bvh);
  const room = Math.ceil(bvh.nodeCount / 2) * width;
  const [children, counts, indices] = [new Int32Array(room).fill(-1), new Uint32Array(room), new Uint32Array(room)];
  const waiting: Waiting[] = [{ node: 0, slot: -1, others: 0, level: 1 }];
  let [nodeCount, stackSize, depth] = [0, 0, 0];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const { node, slot, level } = next;
    const opened = open(node);
    const from = nodeCount * width;
    if (slot >= 0) indices[slot] = nodeCount;
    const others = next.others + Math.max(0, opened.filter(({ isLeaf }) => !isLeaf).length - 1);
    for (let s = opened.length - 1; s >= 0; s--) {
      const child = opened[s]!;
      children[from + s] = child.node;
      if (child.isLeaf) {
        counts[from + s] = count[child.node]!;
        indices[from + s] = first[child.node]!;
      } else waiting.push({ node: child.node, slot: from + s, others, level: level + 1 });
    }
    nodeCount++;
    stackSize = Math.max(stackSize, others);
    depth = Math.max(depth, level);
  }
  const used = nodeCount * width;
  return {
    width,
    nodeCount,
    children: children.slice(0, used),
    counts: counts.slice(0, used),
    indices: indices.slice(0, used),
    stackSize,
    depth,
  };
}

/** As `sahCost`, of a wide tree: what one of its nodes costs and what a primitive costs, each times its share of the root's area. */
export function wideCost(
  bvh: Bvh,
  tree: WideTree,
  costs: { readonly node: number; readonly primitive: number },
): number {
  if (bvh.nodeCount === 0) return 0;
  let sum = costs.node * halfArea(bvh, 0);
  tree.children.forEach((child, k) => {
    if (child >= 0)
      sum += halfArea(bvh, child) * (tree.counts[k]! > 0 ? costs.primitive * tree.counts[k]! : costs.node);
  });
  return sum / halfArea(bvh, 0);
}
