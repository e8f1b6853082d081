/** The loop that splits nodes until all are leaves, depth first, with a stack of its own; it can pause between two nodes. */

import { sortByMorton } from './morton-order.ts';
import { gridScale, packBox, RECORD } from './packed-box.ts';
import { unionOfBoxes } from './primitive-boxes.ts';
import { LEAF, type SplitRules, split } from './split.ts';
import type { Workspace } from './workspace.ts';

/** Numbers a waiting node: begin, end, parent, depth. */
const ENTRY = 4;

function packBoxes(work: Workspace, boxes: Float32Array, count: number, union: Float64Array): void {
  const scale = gridScale(union);
  const { records, spare, order } = work;
  const [ox, oy, oz] = [union[0]!, union[1]!, union[2]!];
  for (let k = 0; k < count; k++) {
    const at = k * RECORD;
    packBox(boxes, spare[k]!, records, at, ox, oy, oz, scale);
    records[at + 3] = spare[k]!;
    order[k] = at;
  }
}

export class SahTree {
  nodeCount = 0;
  /** The deepest leaf so far. */
  depth = 0;
  /** Primitives that lie in leaves. */
  placed = 0;

  private boxes: Float32Array = new Float32Array(0);
  private count = 0;
  private readonly stack: Int32Array;
  private waiting = 0;
  private readonly union = new Float64Array(6);

  constructor(
    private readonly work: Workspace,
    private readonly rules: SplitRules,
  ) {
    this.stack = new Int32Array((rules.maxDepth + 34) * ENTRY);
  }

  start(boxes: Float32Array, count: number): void {
    this.boxes = boxes;
    this.count = count;
    this.nodeCount = 0;
    this.depth = 0;
    this.placed = 0;
    this.waiting = 0;
    this.work.fit(count);
    unionOfBoxes(boxes, count, this.union);
    sortByMorton(this.work, boxes, count, this.union);
    packBoxes(this.work, boxes, count, this.union);
    if (count > 0) this.wait(0, count, -1, 0);
  }

  /** Goes on until so many primitives more lie in leaves, or all do. */
  grow(more: number): void {
    const until = Math.min(this.count, this.placed + more);
    const { stack } = this;
    while (this.placed < until) {
      const top = --this.waiting * ENTRY;
      this.descend(stack[top]!, stack[top + 1]!, stack[top + 2]!, stack[top + 3]!);
    }
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
    const { links } = this.work;
    let end = nodeEnd;
    let depth = nodeDepth;
    if (parent >= 0) links[2 * parent] = this.nodeCount;
    for (;;) {
      const node = this.nodeCount++;
      const middle = this.middleOf(begin, end, depth);
      if (middle === LEAF) {
        links[2 * node] = begin;
        links[2 * node + 1] = end - begin;
        break;
      }
      links[2 * node + 1] = 0;
      depth++;
      this.wait(middle, end, node, depth);
      end = middle;
    }
    this.placed = end;
    if (depth > this.depth) this.depth = depth;
    this.placeLeaf(begin, end);
  }

  private middleOf(begin: number, end: number, depth: number): number {
    const count = end - begin;
    const { rules } = this;
    if (count <= rules.leafSize || count === 1) return LEAF;
    // Halving makes ⌈log₂ count⌉ levels. As soon as there are no more left than that, it begins.
    const levels = 32 - Math.clz32(count - 1);
    if (depth + levels >= rules.maxDepth) return count <= rules.maxLeafSize ? LEAF : (begin + end) >> 1;
    return split(this.work, this.boxes, begin, end, rules);
  }

  private placeLeaf(begin: number, end: number): void {
    const { order, records } = this.work;
    for (let k = begin; k < end; k++) order[k] = records[order[k]! + 3]!;
  }
}
