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
import type { Bvh } from '../bvh.ts';
import { addChild, type NodeSource } from '../trace/node-source.ts';
import { collapse } from './collapse.ts';
import { decodePlane, type Grid, gridAt, gridsOver, quantiseGreatest, quantiseLeast } from './quantise.ts';
import type { EncodedNodes } from './reference.ts';
import type { WideTree } from './wide-tree.ts';

const WORDS = 8;
const LIMIT = 255;
const MOST_PRIMITIVES = 15;

/** Of node i's children; a missing one counts as an inner node. */
function countsOf({ counts }: WideTree, i: number): readonly [number, number] {
  const [a, b] = [counts[2 * i]!, counts[2 * i + 1]!];
  const most = Math.max(a, b);
  if (most > MOST_PRIMITIVES) {
    throw new RangeError(`A leaf has ${most} primitives; this encoding holds 1 to ${MOST_PRIMITIVES}`);
  }
  return [a, b];
}

/** The union of the boxes of node i's children, into `union`. */
function uniteChildren({ bounds }: Bvh, { children }: WideTree, i: number, union: Float32Array): void {
  const [a, b] = [children[2 * i]!, children[2 * i + 1]!];
  for (let k = 0; k < 6; k++) {
    const first = a < 0 ? 0 : bounds[6 * a + k]!;
    const second = b < 0 ? first : bounds[6 * b + k]!;
    union[k] = first < second === k < 3 ? first : second;
  }
}

/** Least and greatest number of a child along an axis; of none, an end before the beginning. */
function planes({ bounds }: Bvh, child: number, axis: number, grid: Grid): number {
  if (child < 0) return LIMIT;
  return quantiseLeast(grid, bounds[6 * child + axis]!) | (quantiseGreatest(grid, bounds[6 * child + 3 + axis]!) << 8);
}

export function encodeFramed2(bvh: Bvh): EncodedNodes {
  const tree = collapse(bvh, 2);
  const words = new Uint32Array(tree.nodeCount * WORDS);
  const floats = new Float32Array(words.buffer);
  const union = new Float32Array(6);
  for (let i = 0; i < tree.nodeCount; i++) {
    const at = i * WORDS;
    const [a, b] = countsOf(tree, i);
    uniteChildren(bvh, tree, i, union);
    const grids = gridsOver(union, 0, LIMIT);
    words[at + 3] = (a << 24) | (b << 28);
    for (let axis = 0; axis < 3; axis++) {
      const grid = grids[axis]!;
      floats[at + axis] = grid.origin;
      words[at + 3]! |= (grid.exponent + 127) << (8 * axis);
      const first = planes(bvh, tree.children[2 * i]!, axis, grid);
      words[at + 4 + axis] = first | (planes(bvh, tree.children[2 * i + 1]!, axis, grid) << 16);
    }
    words[at + 7] = tree.indices[a > 0 ? 2 * i : 2 * i + 1]!;
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
      const grids = [0, 1, 2].map((axis) => gridAt(floats[at + axis]!, ((header >>> (8 * axis)) & 255) - 127));
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
