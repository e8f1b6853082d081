/**
 * A tree that is there soon, to trace with until the better one is: a linear BVH (Lauterbach et al. 2009). Items in Morton's order
 * are split where the highest bit of their codes changes, so nothing is weighed and nothing is moved.
 */
import { uniteUpwards } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';
import { pairPrimitives } from './items.ts';
import { sortByMorton } from './morton-order.ts';
import { triangleBoxes } from './primitive-boxes.ts';
import { splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

/** Numbers a waiting node: begin, end, parent, depth. 30 bits of code and 32 halvings of equal ones at most. */
const ENTRY = 4;
const DEEPEST = 64;

/** Where the codes from begin to end first have the highest bit in which they differ; the middle when they are all the same. */
function changeOfBit(codes: Uint32Array, begin: number, end: number): number {
  const first = codes[begin]!;
  const differing = first ^ codes[end - 1]!;
  if (differing === 0) return (begin + end) >> 1;
  const shift = 31 - Math.clz32(differing);
  let before = begin;
  let after = end - 1;
  while (after - before > 1) {
    const middle = (before + after) >> 1;
    if ((codes[middle]! ^ first) >>> shift === 0) before = middle;
    else after = middle;
  }
  return after;
}

/** Links over items: leaves have their first item and how many. Returns the number of nodes and the depth. */
function linkItems(codes: Uint32Array, count: number, leafItems: number, links: Uint32Array): [number, number] {
  const stack = new Int32Array(DEEPEST * ENTRY);
  stack.set([0, count, -1, 0]);
  let nodeCount = 0;
  let deepest = 0;
  for (let top = 0; top >= 0; ) {
    const begin = stack[top]!;
    let end = stack[top + 1]!;
    const parent = stack[top + 2]!;
    let depth = stack[top + 3]!;
    if (parent >= 0) links[2 * parent] = nodeCount;
    top -= ENTRY;
    for (; end - begin > leafItems; depth++) {
      const middle = changeOfBit(codes, begin, end);
      top += ENTRY;
      stack[top] = middle;
      stack[top + 1] = end;
      stack[top + 2] = nodeCount;
      stack[top + 3] = depth + 1;
      links[2 * nodeCount + 1] = 0;
      nodeCount++;
      end = middle;
    }
    links[2 * nodeCount] = begin;
    links[2 * nodeCount + 1] = end - begin;
    nodeCount++;
    if (depth > deepest) deepest = depth;
  }
  return [nodeCount, deepest];
}

function boundLeaf(boxes: Float32Array, sorted: Uint32Array, begin: number, end: number, to: Float32Array, at: number) {
  let i = (sorted[begin]! >>> 1) * 6;
  let x0 = boxes[i]!;
  let y0 = boxes[i + 1]!;
  let z0 = boxes[i + 2]!;
  let x1 = boxes[i + 3]!;
  let y1 = boxes[i + 4]!;
  let z1 = boxes[i + 5]!;
  for (let k = begin + 1; k < end; k++) {
    i = (sorted[k]! >>> 1) * 6;
    if (boxes[i]! < x0) x0 = boxes[i]!;
    if (boxes[i + 1]! < y0) y0 = boxes[i + 1]!;
    if (boxes[i + 2]! < z0) z0 = boxes[i + 2]!;
    if (boxes[i + 3]! > x1) x1 = boxes[i + 3]!;
    if (boxes[i + 4]! > y1) y1 = boxes[i + 4]!;
    if (boxes[i + 5]! > z1) z1 = boxes[i + 5]!;
  }
  to[at] = x0;
  to[at + 1] = y0;
  to[at + 2] = z0;
  to[at + 3] = x1;
  to[at + 4] = y1;
  to[at + 5] = z1;
}

/** Writes the primitives of items from `place` on and returns the place behind them. */
function placeItems(sorted: Uint32Array, begin: number, end: number, order: Uint32Array, place: number): number {
  let next = place;
  for (let k = begin; k < end; k++) {
    const primitive = sorted[k]! >>> 1;
    order[next++] = primitive;
    if (sorted[k]! & 1) order[next++] = primitive + 1;
  }
  return next;
}

/** Leaves of items become leaves of primitives, in their order, with bounds. */
function finishLeaves(tree: Bvh, boxes: Float32Array, sorted: Uint32Array): void {
  const { links, order, bounds, nodeCount } = tree;
  let place = 0;
  for (let i = 0; i < nodeCount; i++) {
    const count = links[2 * i + 1]!;
    if (count === 0) continue;
    const first = links[2 * i]!;
    boundLeaf(boxes, sorted, first, first + count, bounds, 6 * i);
    links[2 * i] = place;
    place = placeItems(sorted, first, first + count, order, place);
    links[2 * i + 1] = place - links[2 * i]!;
  }
}

/** Throws a RangeError as `triangleBoxes` does. `leafSize`: most triangles of a leaf, default 4. */
export function buildFastBvh(mesh: TriangleMesh, { leafSize = 4 }: { readonly leafSize?: number } = {}): Bvh {
  const boxes = triangleBoxes(mesh);
  const primitiveCount = boxes.length / 6;
  const order = new Uint32Array(primitiveCount);
  const work = new Workspace();
  work.fitSorting(primitiveCount);
  const count = pairPrimitives(boxes, primitiveCount, splitRules({ maxLeafSize: leafSize }), work.order);
  sortByMorton(work, boxes, count);
  const roomy = new Uint32Array(4 * count);
  // An item has one or two triangles.
  const leafItems = Math.max(1, leafSize >> 1);
  const [nodeCount, depth] = count > 0 ? linkItems(work.sortedCodes, count, leafItems, roomy) : [0, 0];
  const links = roomy.slice(0, 2 * nodeCount);
  const tree = { nodeCount, bounds: new Float32Array(6 * nodeCount), links, primitiveCount, order, depth };
  finishLeaves(tree, boxes, work.sorted);
  uniteUpwards(nodeCount, links, tree.bounds);
  return tree;
}
