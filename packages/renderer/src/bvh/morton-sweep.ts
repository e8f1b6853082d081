/**
 * A tree over boxes that move every frame: in Morton's order, and each range split where the surface area heuristic finds it cheapest
 * among all places in that order. Nothing is sorted but once, and nothing moved, so it takes less than half of the good builder's time; trees
 * cost a sixth more, as docs/motion.md shows.
 */
import { uniteUpwards } from './bounds.ts';
import { gatherItems, pairPrimitives } from './items.ts';
import { sortByMorton } from './morton-order.ts';
import { minLanes, NOTHING, packedArea, RECORD } from './packed-box.ts';
import { splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

/** Numbers a waiting node: begin, end, parent, depth. */
const ENTRY = 4;
/** Each item by itself. */
const RULES = splitRules({ leafSize: 1, maxLeafSize: 1 });

/** Of what begins at each place and ends with the range: packed half area × count. */
function sweepFromRight(records: Int32Array, costs: Float64Array, begin: number, end: number): void {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  for (let k = end - 1; k > begin; k--) {
    const at = k * RECORD;
    w0 = minLanes(w0, records[at]!);
    w1 = minLanes(w1, records[at + 1]!);
    w2 = minLanes(w2, records[at + 2]!);
    costs[k] = packedArea(w0, w1, w2) * (end - k);
  }
}

/** Returns where the second part is to begin. */
function sweepFromLeft(records: Int32Array, costs: Float64Array, begin: number, end: number): number {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  let least = Infinity;
  let best = begin + 1;
  for (let k = begin + 1; k < end; k++) {
    const at = (k - 1) * RECORD;
    w0 = minLanes(w0, records[at]!);
    w1 = minLanes(w1, records[at + 1]!);
    w2 = minLanes(w2, records[at + 2]!);
    const cost = packedArea(w0, w1, w2) * (k - begin) + costs[k]!;
    if (cost < least) {
      least = cost;
      best = k;
    }
  }
  return best;
}

/** The levels that halving a range makes. */
const levelsOf = (count: number): number => 32 - Math.clz32(count - 1);

/** The tree before has the parts of a `Bvh`; its arrays have room to grow. */
export class MortonSweep {
  nodeCount = 0;
  bounds: Float32Array = new Float32Array(0);
  links: Uint32Array = new Uint32Array(0);
  primitiveCount = 0;
  order: Uint32Array = new Uint32Array(0);
  depth = 0;
  readonly #work = new Workspace();
  #costs = new Float64Array(0);
  #stack = new Int32Array(0);

  /** One box a leaf. */
  build(boxes: Float32Array, count: number): this {
    const work = this.#work;
    work.fit(count);
    this.#makeRoom(work.capacity);
    this.primitiveCount = count;
    this.nodeCount = 0;
    this.depth = 0;
    if (count === 0) return this;
    pairPrimitives(boxes, count, RULES, work.order);
    sortByMorton(work, boxes, count);
    gatherItems(work, boxes, count, RULES);
    this.#grow(count);
    uniteUpwards(this.nodeCount, this.links, this.bounds);
    return this;
  }

  /** Deeper than twice what halving makes is no better, and ranges of equal boxes would be split one by one. */
  #grow(count: number): void {
    const stack = this.#stack;
    const { records } = this.#work;
    const costs = this.#costs;
    const maxDepth = 2 * levelsOf(count) + 4;
    let top = 0;
    this.#wait(0, 0, count, -1, 0);
    while (top >= 0) {
      const begin = stack[top]!;
      let end = stack[top + 1]!;
      const parent = stack[top + 2]!;
      let depth = stack[top + 3]!;
      top -= ENTRY;
      if (parent >= 0) this.links[2 * parent] = this.nodeCount;
      for (; end - begin > 1; depth++) {
        let middle = (begin + end) >> 1;
        if (end - begin > 2 && depth + levelsOf(end - begin) < maxDepth) {
          sweepFromRight(records, costs, begin, end);
          middle = sweepFromLeft(records, costs, begin, end);
        }
        top += ENTRY;
        this.#wait(top, middle, end, this.nodeCount, depth + 1);
        this.links[2 * this.nodeCount + 1] = 0;
        this.nodeCount++;
        end = middle;
      }
      this.#placeLeaf(begin);
      if (depth > this.depth) this.depth = depth;
    }
  }

  #wait(top: number, begin: number, end: number, parent: number, depth: number): void {
    const stack = this.#stack;
    stack[top] = begin;
    stack[top + 1] = end;
    stack[top + 2] = parent;
    stack[top + 3] = depth;
  }

  #placeLeaf(k: number): void {
    const { sorted, boxes } = this.#work;
    const node = this.nodeCount++;
    this.order[k] = sorted[k]! >>> 1;
    this.links[2 * node] = k;
    this.links[2 * node + 1] = 1;
    for (let i = 0; i < 6; i++) this.bounds[6 * node + i] = boxes[6 * k + i]!;
  }

  #makeRoom(count: number): void {
    if (count <= this.order.length) return;
    this.order = new Uint32Array(count);
    this.links = new Uint32Array(4 * count);
    this.bounds = new Float32Array(12 * count);
    this.#costs = new Float64Array(count);
    this.#stack = new Int32Array((2 * levelsOf(count) + 8) * ENTRY);
  }
}
