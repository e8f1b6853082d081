/**
 * Which binary nodes become the children of a wide node, at the least cost of the whole tree: the dynamic programme of Ylitie, Karras
 * and Laine (2017), section 3.2. C(n, i) is the least cost of what is below node n as a forest of at most i wide trees:
 *
 *     D(n, i) = min over 0 < k < i of C(left, k) + C(right, i − k)
 *     C(n, 1) = min(area · primitives · primitive cost, if a leaf may have so many;  D(n, width) + area · node cost)
 *     C(n, i) = min(D(n, i), C(n, i − 1))
 *
 * So leaves are formed anew too, best from a tree with one primitive a leaf.
 */
import { type Bvh, firstChild, halfArea, leafCount, secondChild, type TraceCosts } from '../bvh.ts';
import { type Opened, placesBelow, type WideTree, wideTree } from './wide-tree.ts';

/** As in the paper: a node of eight boxes against a triangle. */
export const WIDE_COSTS: TraceCosts = { node: 1, primitive: 0.3 };

/** In place of a number of trees for the left side: one tree less is as good; a single tree is a leaf. */
const FEWER = 0;
const AS_LEAF = 255;

/** Decisions: for node n and i trees, how many of them the left child gets. */
class Programme {
  private readonly costs: Float64Array;
  private readonly decisions: Uint8Array;

  constructor(
    private readonly bvh: Bvh,
    private readonly width: number,
    mostPrimitives: number,
    costs: TraceCosts,
  ) {
    const { nodeCount } = bvh;
    this.costs = new Float64Array(nodeCount * (width + 1));
    this.decisions = new Uint8Array(nodeCount * (width + 1));
    const { count } = placesBelow(bvh);
    for (let n = nodeCount - 1; n >= 0; n--) {
      const asLeaf = count[n]! <= mostPrimitives ? halfArea(bvh, n) * count[n]! * costs.primitive : Infinity;
      if (leafCount(bvh, n) > 0) this.decideLeaf(n, asLeaf);
      else this.decide(n, asLeaf, halfArea(bvh, n) * costs.node);
    }
  }

  private decideLeaf(n: number, asLeaf: number): void {
    const at = n * (this.width + 1);
    for (let i = 1; i <= this.width; i++) this.costs[at + i] = asLeaf;
    this.decisions[at + 1] = AS_LEAF;
  }

  private decide(n: number, asLeaf: number, asNode: number): void {
    const { width, costs, decisions } = this;
    const at = n * (width + 1);
    const left = firstChild(n) * (width + 1);
    const right = secondChild(this.bvh, n) * (width + 1);
    for (let i = 2; i <= width; i++) {
      costs[at + i] = Infinity;
      for (let k = 1; k < i; k++) {
        const cost = costs[left + k]! + costs[right + i - k]!;
        if (cost >= costs[at + i]!) continue;
        costs[at + i] = cost;
        decisions[at + i] = k;
      }
    }
    // What node n is split into when it is a wide node itself is kept at 0; i = width is free for a forest then.
    decisions[at] = decisions[at + width]!;
    const asWide = costs[at + width]! + asNode;
    costs[at + 1] = Math.min(asLeaf, asWide);
    decisions[at + 1] = asLeaf <= asWide ? AS_LEAF : 0;
    for (let i = 2; i <= width; i++) {
      if (costs[at + i - 1]! > costs[at + i]!) continue;
      costs[at + i] = costs[at + i - 1]!;
      decisions[at + i] = FEWER;
    }
  }

  /** The children of node n as a wide one. */
  open(n: number): Opened[] {
    const opened: Opened[] = [];
    const k = this.decisions[n * (this.width + 1)]!;
    this.gather(firstChild(n), k, opened);
    this.gather(secondChild(this.bvh, n), this.width - k, opened);
    return opened;
  }

  /** The trees of node n's forest of at most i. */
  private gather(n: number, most: number, opened: Opened[]): void {
    const at = n * (this.width + 1);
    let i = most;
    while (i > 1 && this.decisions[at + i] === FEWER) i--;
    if (i === 1) {
      opened.push({ node: n, isLeaf: this.decisions[at + 1] === AS_LEAF });
      return;
    }
    const k = this.decisions[at + i]!;
    this.gather(firstChild(n), k, opened);
    this.gather(secondChild(this.bvh, n), i - k, opened);
  }
}

/** Throws a RangeError when the tree has larger leaves than `mostPrimitives`. */
export function cheapestCollapse(
  bvh: Bvh,
  width: number,
  mostPrimitives: number,
  costs: TraceCosts = WIDE_COSTS,
): WideTree {
  for (let i = 0; i < bvh.nodeCount; i++) {
    if (leafCount(bvh, i) <= mostPrimitives) continue;
    throw new RangeError(`A leaf has ${leafCount(bvh, i)} primitives; this encoding holds 1 to ${mostPrimitives}`);
  }
  const programme = new Programme(bvh, width, mostPrimitives, costs);
  return wideTree(bvh, width, (node) => programme.open(node));
}
