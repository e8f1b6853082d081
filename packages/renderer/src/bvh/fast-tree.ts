/**
 * A tree that is there soon, to trace with until the better one is: a linear BVH (Lauterbach et al. 2009). Primitives in Morton's
 * order are split where the highest bit of their codes changes, so nothing is weighed and nothing is moved.
 */
import { uniteUpwards } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';
import { eachAlone } from './items.ts';
import { sortByMorton } from './morton-order.ts';
import { triangleBoxes } from './primitive-boxes.ts';
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

function boundPlaces(
  boxes: Float32Array,
  order: Uint32Array,
  begin: number,
  end: number,
  to: Float32Array,
  at: number,
) {
  let x0 = Infinity;
  let y0 = Infinity;
  let z0 = Infinity;
  let x1 = -Infinity;
  let y1 = -Infinity;
  let z1 = -Infinity;
  for (let k = begin; k < end; k++) {
    const i = order[k]! * 6;
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

/** Fills `links` depth first; returns the number of nodes and the depth. */
function linkNodes(codes: Uint32Array, count: number, leafSize: number, links: Uint32Array): [number, number] {
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
    for (; end - begin > leafSize; depth++) {
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

function boundNodes(nodeCount: number, links: Uint32Array, order: Uint32Array, boxes: Float32Array): Float32Array {
  const bounds = new Float32Array(nodeCount * 6);
  for (let i = 0; i < nodeCount; i++) {
    const count = links[2 * i + 1]!;
    const first = links[2 * i]!;
    if (count > 0) boundPlaces(boxes, order, first, first + count, bounds, i * 6);
  }
  uniteUpwards(nodeCount, links, bounds);
  return bounds;
}

function primitivesOf(codes: Uint32Array, count: number): Uint32Array {
  const order = new Uint32Array(count);
  for (let k = 0; k < count; k++) order[k] = codes[k]! >>> 1;
  return order;
}

/** Throws a RangeError as `triangleBoxes` does. `leafSize`: most triangles of a leaf, default 4. */
export function buildFastBvh(mesh: TriangleMesh, { leafSize = 4 }: { readonly leafSize?: number } = {}): Bvh {
  const boxes = triangleBoxes(mesh);
  const count = boxes.length / 6;
  const work = new Workspace();
  work.fit(count);
  eachAlone(count, work.order);
  sortByMorton(work, boxes, count);
  const order = primitivesOf(work.sorted, count);
  const links = new Uint32Array(4 * count);
  const [nodeCount, depth] = count > 0 ? linkNodes(work.sortedCodes, count, leafSize, links) : [0, 0];
  const bounds = boundNodes(nodeCount, links, order, boxes);
  return { nodeCount, bounds, links: links.slice(0, 2 * nodeCount), primitiveCount: count, order, depth };
}
