/**
 * 80 bytes a node: the compressed wide BVH of Ylitie, Karras and Laine (2017). Eight children on a grid of the node's own, 256 planes an
 * axis:
 *
 *     word 0   start of the grid: x, y, z as floats
 *     byte 12  exponents of a cell + 127: x, y, z       byte 15  bit s: slot s has an inner node
 *     word 4   number of the first inner child; the others follow in order of their slots
 *     word 5   first place of the leaves' primitives
 *     byte 24  eight bytes, what is in each slot: 0 nothing; 001 in the highest bits and 24 + s in the low five an inner node;
 *              else a leaf of 1, 2 or 3 primitives, 001, 011 or 111, with its first place after word 5 in the low five bits
 *     byte 32  least x of the eight   40  least y   48  least z   56  greatest x   64  greatest y   72  greatest z
 *
 * Inner children are neighbours, so nodes are in another order than that of the tree; so are primitives, for those of all leaves of a
 * node to be neighbours. Which child lies in which slot follows the paper: bits 2, 1, 0 of a slot are set for positive x, y, z, and a
 * child wants the slot whose direction points to it from the node's middle. A ray with bits r, set for negative direction, meets
 * slots roughly in rising order of s xor r. Leaves have at most three primitives.
 */
import { type Bvh, firstPlace, leafCount } from '../bvh.ts';
import { collapse } from './collapse.ts';
import { type Grid, gridsOver, quantiseGreatest, quantiseLeast } from './quantise.ts';
import type { EncodedNodes } from './reference.ts';
import { assignSlots } from './slots.ts';

export const WIDTH = 8;
export const WORDS = 20;
const LIMIT = 255;
const MOST_PRIMITIVES = 3;
const UNARY = [0, 0b001, 0b011, 0b111] as const;

export interface Wide8Nodes extends EncodedNodes {
  /** Which primitive stands at each place. */
  readonly order: Uint32Array;
}

const boxOf = (bvh: Bvh, node: number): number[] => [...bvh.bounds.subarray(6 * node, 6 * node + 6)];

/** A node while it is written. */
class Writer {
  readonly words: Uint32Array<ArrayBuffer>;
  readonly order: Uint32Array;
  nodes = 1;
  places = 0;
  private readonly bytes: Uint8Array;
  private readonly floats: Float32Array;

  constructor(
    private readonly bvh: Bvh,
    nodeCount: number,
  ) {
    this.words = new Uint32Array(nodeCount * WORDS);
    this.bytes = new Uint8Array(this.words.buffer);
    this.floats = new Float32Array(this.words.buffer);
    this.order = new Uint32Array(bvh.primitiveCount);
  }

  /** `slots`: eight binary nodes, −1 for none. Returns the inner ones in order of their slots. */
  write(index: number, box: readonly number[], slots: readonly number[]): number[] {
    const grids = gridsOver(box, LIMIT);
    const at = index * WORDS;
    grids.forEach(({ origin, exponent }, axis) => {
      this.floats[at + axis] = origin;
      this.bytes[4 * at + 12 + axis] = exponent + 127;
    });
    this.words[at + 4] = this.nodes;
    this.words[at + 5] = this.places;
    const firstOfLeaves = this.places;
    const inner = slots.filter((child) => child >= 0 && leafCount(this.bvh, child) === 0);
    slots.forEach((child, slot) => {
      this.bytes[4 * at + 24 + slot] = this.meta(child, slot, firstOfLeaves);
      if (inner.includes(child)) this.bytes[4 * at + 15]! |= 1 << slot;
      this.writePlanes(4 * at + 32 + slot, child, grids);
    });
    this.nodes += inner.length;
    return inner;
  }

  private meta(child: number, slot: number, firstOfLeaves: number): number {
    if (child < 0) return 0;
    const count = leafCount(this.bvh, child);
    if (count === 0) return (UNARY[1] << 5) | (24 + slot);
    if (count > MOST_PRIMITIVES) {
      throw new RangeError(`A leaf has ${count} primitives; this encoding holds 1 to ${MOST_PRIMITIVES}`);
    }
    const offset = this.places - firstOfLeaves;
    const first = firstPlace(this.bvh, child);
    this.order.set(this.bvh.order.subarray(first, first + count), this.places);
    this.places += count;
    return (UNARY[count]! << 5) | offset;
  }

  private writePlanes(at: number, child: number, grids: readonly Grid[]): void {
    grids.forEach((grid, axis) => {
      const plane = 6 * child + axis;
      this.bytes[at + 8 * axis] = child < 0 ? LIMIT : quantiseLeast(grid, this.bvh.bounds[plane]!);
      this.bytes[at + 24 + 8 * axis] = child < 0 ? 0 : quantiseGreatest(grid, this.bvh.bounds[plane + 3]!);
    });
  }
}

export function encodeWide8(bvh: Bvh): Wide8Nodes {
  const tree = collapse(bvh, WIDTH);
  const writer = new Writer(bvh, tree.nodeCount);
  const nothing = [0, 0, 0, 0, 0, 0];
  const waiting = [{ node: 0, index: 0 }];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const from = bvh.nodeCount > 0 ? tree.numbers[next.node]! * WIDTH : 0;
    const children = [...tree.children.subarray(from, from + WIDTH)].filter((child) => child >= 0);
    const box = bvh.nodeCount > 0 ? boxOf(bvh, next.node) : nothing;
    const slots = assignSlots(box, children, (child) => boxOf(bvh, child));
    const first = writer.nodes;
    const inner = writer.write(next.index, box, slots);
    inner.forEach((node, k) => {
      waiting.push({ node, index: first + k });
    });
  }
  const { words, order } = writer;
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth, order };
}
