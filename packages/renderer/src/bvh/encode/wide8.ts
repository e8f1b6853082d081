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
 * slots roughly in rising order of s xor r. Leaves have at most three primitives; they are formed anew, best from a tree with one
 * primitive a leaf.
 */
import type { Bvh } from '../bvh.ts';
import { cheapestCollapse } from './cheapest-collapse.ts';
import { type Grid, gridsOver, NO_BOX, quantiseGreatest, quantiseLeast } from './quantise.ts';
import type { EncodedNodes } from './reference.ts';
import { assignSlots } from './slots.ts';
import type { WideTree } from './wide-tree.ts';

export const WIDTH = 8;
export const WORDS = 20;
const LIMIT = 255;
const MOST_PRIMITIVES = 3;
const UNARY = [0, 0b001, 0b011, 0b111] as const;

export interface Wide8Nodes extends EncodedNodes {
  /** Which primitive stands at each place. */
  readonly order: Uint32Array;
}

/** A child to be written is a slot of the wide tree, counted over all its nodes; −1 is none. */
class Writer {
  readonly words: Uint32Array<ArrayBuffer>;
  readonly order: Uint32Array;
  nodes = 1;
  private places = 0;
  private readonly bytes: Uint8Array;
  private readonly floats: Float32Array;

  constructor(
    private readonly bvh: Bvh,
    private readonly tree: WideTree,
  ) {
    this.words = new Uint32Array(tree.nodeCount * WORDS);
    this.bytes = new Uint8Array(this.words.buffer);
    this.floats = new Float32Array(this.words.buffer);
    this.order = new Uint32Array(bvh.primitiveCount);
  }

  /** `node`: the binary one; `slots`: eight children. Returns the inner ones in order of their slots. */
  write(index: number, node: number, slots: readonly number[]): number[] {
    const { bounds, nodeCount } = this.bvh;
    const grids = nodeCount > 0 ? gridsOver(bounds, 6 * node, LIMIT) : gridsOver(NO_BOX, 0, LIMIT);
    const at = index * WORDS;
    for (let axis = 0; axis < 3; axis++) {
      this.floats[at + axis] = grids[axis]!.origin;
      this.bytes[4 * at + 12 + axis] = grids[axis]!.exponent + 127;
    }
    this.words[at + 4] = this.nodes;
    this.words[at + 5] = this.places;
    const firstOfLeaves = this.places;
    for (let slot = 0; slot < WIDTH; slot++) {
      const child = slots[slot]!;
      this.bytes[4 * at + 24 + slot] = this.meta(child, slot, firstOfLeaves);
      if (this.isInner(child)) this.bytes[4 * at + 15]! |= 1 << slot;
      this.writePlanes(4 * at + 32 + slot, child, grids);
    }
    const inner = slots.filter((child) => this.isInner(child));
    this.nodes += inner.length;
    return inner;
  }

  private isInner(child: number): boolean {
    return child >= 0 && this.tree.counts[child] === 0;
  }

  private meta(child: number, slot: number, firstOfLeaves: number): number {
    if (child < 0) return 0;
    const count = this.tree.counts[child]!;
    if (count === 0) return (UNARY[1] << 5) | (24 + slot);
    const offset = this.places - firstOfLeaves;
    const first = this.tree.indices[child]!;
    this.order.set(this.bvh.order.subarray(first, first + count), this.places);
    this.places += count;
    return (UNARY[count]! << 5) | offset;
  }

  private writePlanes(at: number, child: number, grids: readonly Grid[]): void {
    const { bounds } = this.bvh;
    const node = child < 0 ? -1 : this.tree.children[child]!;
    for (let axis = 0; axis < 3; axis++) {
      const plane = 6 * node + axis;
      this.bytes[at + 8 * axis] = child < 0 ? LIMIT : quantiseLeast(grids[axis]!, bounds[plane]!);
      this.bytes[at + 24 + 8 * axis] = child < 0 ? 0 : quantiseGreatest(grids[axis]!, bounds[plane + 3]!);
    }
  }
}

/** The slots of wide node i in the order in which they are to be written. */
function arrange(bvh: Bvh, { children }: WideTree, i: number, node: number): number[] {
  const present: number[] = [];
  for (let slot = i * WIDTH; slot < (i + 1) * WIDTH; slot++) if (children[slot]! >= 0) present.push(slot);
  const nodes = present.map((slot) => children[slot]!);
  return assignSlots(bvh.bounds, node, nodes).map((c) => (c < 0 ? -1 : present[c]!));
}

export function encodeWide8(bvh: Bvh): Wide8Nodes {
  const tree = cheapestCollapse(bvh, WIDTH, MOST_PRIMITIVES);
  const writer = new Writer(bvh, tree);
  // `number` in the wide tree, `index` where it is written, `node` in the binary tree.
  const waiting = [{ number: 0, index: 0, node: 0 }];
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const first = writer.nodes;
    const inner = writer.write(next.index, next.node, arrange(bvh, tree, next.number, next.node));
    inner.forEach((child, k) => {
      waiting.push({ number: tree.indices[child]!, index: first + k, node: tree.children[child]! });
    });
  }
  const { words, order } = writer;
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth, order };
}
