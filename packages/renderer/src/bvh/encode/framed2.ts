/**
 * 32 bytes a node: a grid of its own, 256 planes an axis, with the boxes of both children on it:
 *
 *     0  start of the grid: x, y, z as floats
 *     3  exponents of a cell + 127: x + 2⁸ · y + 2¹⁶ · z, + 2²⁴ · primitives of child 0, + 2²⁸ · primitives of child 1
 *     4  x: least of child 0 + 2⁸ · greatest of child 0 + 2¹⁶ · least of child 1 + 2²⁴ · greatest of child 1
 *     5  y      6  z
 *     7  a reference
 *
 * 0 primitives is an inner node. One reference suffices in depth-first order: where child 0 is an inner node, it is the next one, and
 * word 7 has child 1 (number or first place). Where child 0 is a leaf, word 7 has its first place; then child 1 is the next node, or a
 * leaf whose places follow. A missing child is an inner node whose box ends before it begins.
 */
import { type Bvh, firstPlace, leafCount } from '../bvh.ts';
import { addChild, type NodeSource } from '../trace/node-source.ts';
import { collapse, type WideTree } from './collapse.ts';
import { decodePlane, type Grid, gridsOver, quantiseGreatest, quantiseLeast } from './quantise.ts';
import type { EncodedNodes } from './reference.ts';

const WORDS = 8;
const LIMIT = 255;
const MOST_PRIMITIVES = 15;

/** Of both children; none, for −1, is an inner node. */
function countsOf(bvh: Bvh, children: readonly number[]): number[] {
  const counts = children.map((child) => (child < 0 ? 0 : leafCount(bvh, child)));
  const most = Math.max(...counts);
  if (most > MOST_PRIMITIVES) {
    throw new RangeError(`A leaf has ${most} primitives; this encoding holds 1 to ${MOST_PRIMITIVES}`);
  }
  return counts;
}

function word7(bvh: Bvh, { numbers }: WideTree, children: readonly number[], counts: readonly number[]): number {
  const [a, b] = children as [number, number];
  if (counts[0]! > 0) return firstPlace(bvh, a);
  if (b < 0) return 0;
  return counts[1]! > 0 ? firstPlace(bvh, b) : numbers[b]!;
}

/** The box of one child. */
const boxOf = (bvh: Bvh, child: number): number[] => [...bvh.bounds.subarray(6 * child, 6 * child + 6)];

function boxOfBoth(bvh: Bvh, children: readonly number[]): number[] {
  const boxes = children.filter((child) => child >= 0).map((child) => boxOf(bvh, child));
  if (boxes.length === 0) return [0, 0, 0, 0, 0, 0];
  return boxes.reduce((u, box) => u.map((x, k) => (k < 3 ? Math.min(x, box[k]!) : Math.max(x, box[k]!))));
}

function planesAlong(bvh: Bvh, axis: number, grid: Grid, children: readonly number[]): number {
  let word = 0;
  children.forEach((child, slot) => {
    const least = child < 0 ? LIMIT : quantiseLeast(grid, bvh.bounds[6 * child + axis]!);
    const greatest = child < 0 ? 0 : quantiseGreatest(grid, bvh.bounds[6 * child + 3 + axis]!);
    word |= (least | (greatest << 8)) << (16 * slot);
  });
  return word;
}

export function encodeFramed2(bvh: Bvh): EncodedNodes {
  const tree = collapse(bvh, 2);
  const words = new Uint32Array(tree.nodeCount * WORDS);
  const floats = new Float32Array(words.buffer);
  for (let i = 0; i < tree.nodeCount; i++) {
    const at = i * WORDS;
    const children = [tree.children[2 * i]!, tree.children[2 * i + 1]!];
    const counts = countsOf(bvh, children);
    const grids = gridsOver(boxOfBoth(bvh, children), LIMIT);
    const [ex, ey, ez] = grids.map((grid) => grid.exponent + 127) as [number, number, number];
    grids.forEach((grid, axis) => {
      floats[at + axis] = grid.origin;
      words[at + 4 + axis] = planesAlong(bvh, axis, grid, children);
    });
    words[at + 3] = ex | (ey << 8) | (ez << 16) | (counts[0]! << 24) | (counts[1]! << 28);
    words[at + 7] = word7(bvh, tree, children, counts);
  }
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth };
}

export function framed2Source({ words, stackSize }: EncodedNodes, order: Uint32Array): NodeSource {
  const floats = new Float32Array(words.buffer);
  return {
    root: 0,
    order,
    stackSize,
    readChildren(node, into) {
      const at = node * WORDS;
      const header = words[at + 3]!;
      const counts = [(header >>> 24) & 15, header >>> 28] as const;
      const grids = [0, 1, 2].map((axis) => ({
        origin: floats[at + axis]!,
        exponent: ((header >>> (8 * axis)) & 255) - 127,
      }));
      const reference = words[at + 7]!;
      const second = counts[0] === 0 ? reference : counts[1] === 0 ? node + 1 : reference + counts[0];
      const indices = [counts[0] === 0 ? node + 1 : reference, second] as const;
      into.count = 0;
      for (const slot of [0, 1] as const) {
        const bytes = grids.map((_, axis) => words[at + 4 + axis]! >>> (16 * slot));
        const least = bytes.map((byte, axis) => decodePlane(grids[axis]!, byte & LIMIT));
        const greatest = bytes.map((byte, axis) => decodePlane(grids[axis]!, (byte >>> 8) & LIMIT));
        if ((bytes[0]! & LIMIT) > ((bytes[0]! >>> 8) & LIMIT)) continue;
        addChild(into, [...least, ...greatest], counts[slot], indices[slot]);
      }
    },
  };
}
