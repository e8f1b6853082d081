/** The loop that splits nodes until all are leaves, depth first, with a stack of its own; it can pause between two nodes. */
import { boundItems, uniteUpwards } from './bounds.ts';
import { CAREFUL, QUICK } from './care.ts';
import { gatherItems, pairPrimitives, placeItem } from './items.ts';
import { sortByMorton } from './morton-order.ts';
import { LEAF, type SplitRules, split } from './split.ts';
import type { Workspace } from './workspace.ts';

/** Numbers a waiting node: begin, end, parent, depth. */
const ENTRY = 4;

function primitivesOf({ records, order }: Workspace, begin: number, end: number): number {
  let primitives = end - begin;
  for (let k = begin; k < end; k++) primitives += records[order[k]! + 3]! & 1;
  return primitives;
}

/** The tree so far has the parts of a `Bvh`; its arrays have room to grow. */
export class SahTree {
  nodeCount = 0;
  bounds: Float32Array = new Float32Array(0);
  links: Uint32Array = new Uint32Array(0);
  primitiveCount = 0;
  order: Uint32Array = new Uint32Array(0);
  depth = 0;

  itemCount = 0;
  /** Items that lie in leaves. */
  placed = 0;

  private nodeCapacity = 0;
  private readonly stack: Int32Array;
  private waiting = 0;
  private primitivesPlaced = 0;

  constructor(
    private readonly work: Workspace,
    private readonly rules: SplitRules,
  ) {
    this.stack = new Int32Array((rules.maxDepth + 34) * ENTRY);
  }

  /** Begins a tree over primitives with these boxes. */
  start(boxes: Float32Array, count: number): void {
    const { rules, work } = this;
    work.fit(count);
    const pairs = pairPrimitives(boxes, count, rules, work.order);
    sortByMorton(work, boxes, pairs);
    this.itemCount = gatherItems(work, boxes, pairs, rules);
    work.care = rules.maxLeafSize > 1 && this.itemCount === count ? QUICK : CAREFUL;
    this.primitiveCount = count;
    if (this.order.length < count) this.order = new Uint32Array(work.capacity);
    this.nodeCount = 0;
    this.depth = 0;
    this.placed = 0;
    this.primitivesPlaced = 0;
    this.waiting = 0;
    if (count > 0) this.wait(0, this.itemCount, -1, 0);
  }

  /** Goes on until so many items more lie in leaves, or all do; then all bounds are there too. */
  grow(more: number): void {
    const until = Math.min(this.itemCount, this.placed + more);
    const { stack } = this;
    while (this.placed < until) {
      const top = --this.waiting * ENTRY;
      this.descend(stack[top]!, stack[top + 1]!, stack[top + 2]!, stack[top + 3]!);
    }
    if (until === this.itemCount) uniteUpwards(this.nodeCount, this.links, this.bounds);
  }

  private wait(begin: number, end: number, parent: number, depth: number): void {
    const { stack } = this;
    const top = this.waiting++ * ENTRY;
    stack[top] = begin;
    stack[top + 1] = end;
    stack[top + 2] = parent;
    stack[top + 3] = depth;
  }

  /** From a node down along first children to a leaf; second children wait. */
  private descend(begin: number, nodeEnd: number, parent: number, nodeDepth: number): void {
    let end = nodeEnd;
    let depth = nodeDepth;
    if (parent >= 0) this.links[2 * parent] = this.nodeCount;
    for (;;) {
      const node = this.nodeCount++;
      if (node >= this.nodeCapacity) this.makeRoom();
      const middle = this.middleOf(begin, end, depth);
      if (middle === LEAF) {
        this.placeLeaf(begin, end, node);
        break;
      }
      this.links[2 * node + 1] = 0;
      depth++;
      this.wait(middle, end, node, depth);
      end = middle;
    }
    this.placed = end;
    if (depth > this.depth) this.depth = depth;
  }

  private middleOf(begin: number, end: number, depth: number): number {
    const { rules, work } = this;
    const count = end - begin;
    if (count === 1 || 2 * count <= rules.leafSize) return LEAF;
    let primitives = count <= rules.maxLeafSize ? primitivesOf(work, begin, end) : 0;
    if (primitives > rules.maxLeafSize) primitives = 0;
    if (primitives > 0 && primitives <= rules.leafSize) return LEAF;
    // Halving makes ⌈log₂ count⌉ levels. As soon as there are no more left than that, it begins.
    const levels = 32 - Math.clz32(count - 1);
    if (depth + levels >= rules.maxDepth) return primitives > 0 ? LEAF : (begin + end) >> 1;
    return split(work, begin, end, rules, primitives);
  }

  private placeLeaf(begin: number, end: number, node: number): void {
    const { order } = this;
    const { records, order: items, sorted } = this.work;
    let place = this.primitivesPlaced;
    this.links[2 * node] = place;
    for (let k = begin; k < end; k++) {
      place = placeItem(sorted, records[items[k]! + 3]!, order, place);
    }
    this.links[2 * node + 1] = place - this.primitivesPlaced;
    this.primitivesPlaced = place;
    boundItems(this.work, begin, end, this.bounds, node);
  }

  /** A binary tree over n items has at most 2n − 1 nodes, and mostly far fewer. */
  private makeRoom(): void {
    const capacity = Math.min(2 * this.itemCount, Math.max(64, this.itemCount >> 1, 2 * this.nodeCapacity));
    const { bounds, links } = this;
    this.bounds = new Float32Array(capacity * 6);
    this.bounds.set(bounds);
    this.links = new Uint32Array(capacity * 2);
    this.links.set(links);
    this.nodeCapacity = capacity;
  }
}
