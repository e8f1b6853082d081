/**
 * A binary tree → nodes of up to four children, as the kernels read them: struct `WideNode` of layout.ts. Four boxes as floats, least
 * and greatest apart, so that a ray takes near and far planes by the sign of its direction and compares nothing. docs/bvh.md says
 * what else was measured.
 *
 * A reference is a node's number, from 1 on since the root is nobody's child; or, with the highest bit, a leaf: 3 bits with the number of
 * triangles, 1 … 7, and 28 bits with the first one's place. A leaf of the tree over instances has the number 0 and names the instance.
 * Where there is no child, its box is one that no ray enters.
 */
import { type Bvh, firstChild, firstPlace, halfArea, leafCount, secondChild } from '../bvh/bvh.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';

export const WIDTH = 4;
const LEAF = 0x80000000;
const COUNT_SHIFT = 28;
export const MOST_IN_LEAF = 7;
export const MOST_PRIMITIVES = 2 ** COUNT_SHIFT;
/** Boxes grow by this share of the greatest coordinate: more than rounding does to a ray's distance from them. */
export const PADDING = 4e-7;
/** Beyond all, on the wrong side; times 1e18, as for a ray along an axis, it is still a number. */
const FAR = 1e19;

export interface WideBvh {
  readonly words: Uint32Array<ArrayBuffer>;
  /** What waits at most on a kernel's stack on the way through. */
  readonly stackNeed: number;
}

export const NODE_WORDS = geometryRows('WideNode') * GEOMETRY_ROW;
const LEAST = fieldOffset('WideNode', 'minX') / 4;
const GREATEST = fieldOffset('WideNode', 'maxX') / 4;
const CHILDREN = fieldOffset('WideNode', 'children') / 4;
export const NONE = 0xffffffff;

/** Throws a `RangeError` when a leaf has more than MOST_IN_LEAF primitives. */
export function encodeWideBvh(bvh: Bvh): WideBvh {
  const encoder = new WideEncoder();
  // Each wide node stands for at least one inner node, and a tree that is one leaf needs a node about it.
  const words = new Uint32Array(Math.max(bvh.nodeCount, 1) * NODE_WORDS);
  const { nodeCount, stackNeed } = encoder.encode(bvh, words, new Float32Array(words.buffer));
  return { words: words.slice(0, nodeCount * NODE_WORDS), stackNeed };
}

/** Encodes one tree after the other and keeps its arrays. */
export class WideEncoder {
  /** Of the tree before; at least one, a root without children. */
  nodeCount = 0;
  stackNeed = 0;
  /** Which node of the binary tree each of a node's four children is; NONE: there is no such child. */
  sources = new Uint32Array(WIDTH);
  #bvh!: Bvh;
  #words!: Uint32Array;
  #floats!: Float32Array;
  #named = false;

  /**
   * Into `words`, where there is room for as many nodes as the tree has, seen as `floats` too. Leaves refer to places in the tree's
   * order; or, when `named`, to the primitives that stand there, of which each leaf then has one.
   */
  encode(bvh: Bvh, words: Uint32Array, floats: Float32Array, named = false): this {
    this.#bvh = bvh;
    this.#named = named;
    this.#words = words;
    if (this.sources.length < bvh.nodeCount * WIDTH) this.sources = new Uint32Array(bvh.nodeCount * WIDTH);
    this.#floats = floats;
    this.nodeCount = 0;
    this.stackNeed = bvh.nodeCount === 0 ? this.#empty() : this.#node(0);
    writeBoxes(this.sources, this.nodeCount, bvh, floats);
    return this;
  }

  /** Writes the boxes of the tree before anew, whose bounds are others now. */
  fit(bvh: Bvh, floats: Float32Array): void {
    writeBoxes(this.sources, this.nodeCount, bvh, floats);
  }

  #empty(): number {
    this.nodeCount = 1;
    this.sources.fill(NONE, 0, WIDTH);
    for (let k = 0; k < WIDTH; k++) this.#leaveOut(0, k);
    return 0;
  }

  /** Writes the node that stands for one of the binary tree and all below it; gives what waits on the stack at most. */
  #node(source: number): number {
    const bvh = this.#bvh;
    const node = this.nodeCount++;
    const count = this.#open(source, node * WIDTH);
    let deepest = 0;
    for (let k = 0; k < WIDTH; k++) {
      if (k >= count) {
        this.#leaveOut(node, k);
        continue;
      }
      const child = this.sources[node * WIDTH + k]!;
      const primitives = leafCount(bvh, child);
      const reference = primitives > 0 ? this.#leaf(firstPlace(bvh, child), primitives) : this.nodeCount;
      this.#words[node * NODE_WORDS + CHILDREN + k] = reference;
      if (primitives === 0) deepest = Math.max(deepest, this.#node(child));
    }
    return count - 1 + deepest;
  }

  /** Where there is no child. */
  #leaveOut(node: number, k: number): void {
    const at = node * NODE_WORDS + k;
    this.#words[at + CHILDREN] = 0;
    for (let axis = 0; axis < 3; axis++) {
      this.#floats[at + LEAST + axis * WIDTH] = FAR;
      this.#floats[at + GREATEST + axis * WIDTH] = -FAR;
    }
  }

  #leaf(place: number, count: number): number {
    return this.#named ? leafReference(this.#bvh.order[place]!, 0) : leafReference(place, count);
  }

  /** Two children, of which the largest that are no leaves are opened until there are four. Gives how many there are. */
  #open(source: number, at: number): number {
    const bvh = this.#bvh;
    const { sources } = this;
    sources.fill(NONE, at, at + WIDTH);
    sources[at] = source;
    if (leafCount(bvh, source) > 0) return 1;
    let count = 1;
    for (let opened = 0; opened >= 0; ) {
      const child = sources[at + opened]!;
      sources.copyWithin(at + opened + 2, at + opened + 1, at + count);
      sources[at + opened] = firstChild(child);
      sources[at + opened + 1] = secondChild(bvh, child);
      count++;
      opened = count < WIDTH ? this.#largest(at, count) : -1;
    }
    return count;
  }

  #largest(at: number, count: number): number {
    let found = -1;
    let largest = -1;
    for (let k = 0; k < count; k++) {
      const child = this.sources[at + k]!;
      if (leafCount(this.#bvh, child) > 0) continue;
      const area = halfArea(this.#bvh, child);
      if (area <= largest) continue;
      found = k;
      largest = area;
    }
    return found;
  }
}

/** Writes the boxes of all children anew, and nothing else: what a tree needs whose bounds have been refitted. */
export function writeBoxes(sources: Uint32Array, nodeCount: number, bvh: Bvh, floats: Float32Array): void {
  const { bounds } = bvh;
  let most = 0;
  for (let i = 0; bvh.nodeCount > 0 && i < 6; i++) most = Math.max(most, Math.abs(bounds[i]!));
  writePadded(sources, nodeCount * WIDTH, bounds, PADDING * most, floats);
}

function writePadded(
  sources: Uint32Array,
  slots: number,
  bounds: Float32Array,
  padding: number,
  floats: Float32Array,
): void {
  const least = LEAST | 0;
  const greatest = GREATEST | 0;
  const words = NODE_WORDS | 0;
  for (let slot = 0; slot < slots; slot++) {
    const from = sources[slot]! * 6;
    // NONE is a number beyond all nodes; the box that no ray enters stands there since it was encoded.
    if (from >= bounds.length) continue;
    const at = (slot >> 2) * words + (slot & 3);
    floats[at + least] = bounds[from]! - padding;
    floats[at + least + 4] = bounds[from + 1]! - padding;
    floats[at + least + 8] = bounds[from + 2]! - padding;
    floats[at + greatest] = bounds[from + 3]! + padding;
    floats[at + greatest + 4] = bounds[from + 4]! + padding;
    floats[at + greatest + 8] = bounds[from + 5]! + padding;
  }
}

/** Of a node's child; 0: there is none. */
export const referenceAt = (words: Uint32Array, node: number, child: number): number =>
  words[node * NODE_WORDS + CHILDREN + child]!;
export const isLeaf = (reference: number): boolean => reference >= LEAF;
export const placeOf = (leaf: number): number => leaf & (MOST_PRIMITIVES - 1);
export const countOf = (leaf: number): number => (leaf >>> COUNT_SHIFT) & MOST_IN_LEAF;

export function leafReference(first: number, count: number): number {
  if (count > MOST_IN_LEAF || first + count > MOST_PRIMITIVES)
    throw new RangeError(`A leaf of ${count} primitives from ${first} on has no reference.`);
  return (LEAF | (count << COUNT_SHIFT) | first) >>> 0;
}
