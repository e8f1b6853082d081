/**
 * A binary tree → nodes of up to four children, as the kernels read them: struct `WideNode` of layout.ts. Four boxes as floats, least
 * and greatest apart, so that a ray takes near and far planes by the sign of its direction and compares nothing. docs/bvh.md says
 * what else was measured.
 *
 * A reference is a node's number, from 1 on since the root is nobody's child; or, with the highest bit, a leaf: 3 bits with the number of
 * triangles, 1 … 7, and 28 bits with the first one's place. A leaf of the tree over instances has number 0 and names the instance. Where
 * there is no child, its box is one that no ray enters.
 */
import { type Bvh, firstChild, firstPlace, halfArea, leafCount, secondChild } from '../bvh/bvh.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';

const WIDTH = 4;
const LEAF = 0x80000000;
const COUNT_SHIFT = 28;
export const MOST_IN_LEAF = 7;
export const MOST_PRIMITIVES = 2 ** COUNT_SHIFT;
/** Boxes grow by this share of the greatest coordinate: more than rounding does to a ray's distance from them. */
const PADDING = 4e-7;
/** Beyond all, on the wrong side; times 1e18, as a ray along an axis has it, it is still a number. */
const FAR = 1e19;

export interface WideBvh {
  readonly words: Uint32Array<ArrayBuffer>;
  /** What waits at most on a kernel's stack on the way through. */
  readonly stackNeed: number;
}

const NODE_WORDS = geometryRows('WideNode') * GEOMETRY_ROW;
const LEAST = fieldOffset('WideNode', 'minX') / 4;
const GREATEST = fieldOffset('WideNode', 'maxX') / 4;
const CHILDREN = fieldOffset('WideNode', 'children') / 4;

/** Over triangles or instances. Throws a `RangeError` when a leaf has more than MOST_IN_LEAF primitives. */
export function encodeWideBvh(bvh: Bvh, over: 'triangles' | 'instances'): WideBvh {
  // Each wide node stands for at least one inner node, and a tree that is one leaf needs a node about it.
  const words = new Uint32Array(Math.max(bvh.nodeCount, 1) * NODE_WORDS);
  const encoder = new Encoder(bvh, words, over === 'instances');
  const stackNeed = encoder.encode();
  return { words: words.slice(0, encoder.used * NODE_WORDS), stackNeed };
}

class Encoder {
  used = 0;
  readonly #bvh: Bvh;
  readonly #words: Uint32Array;
  readonly #floats: Float32Array;
  readonly #padding: number;
  readonly #ofInstances: boolean;

  constructor(bvh: Bvh, words: Uint32Array<ArrayBuffer>, ofInstances: boolean) {
    this.#bvh = bvh;
    this.#ofInstances = ofInstances;
    this.#words = words;
    this.#floats = new Float32Array(words.buffer);
    this.#padding = PADDING * bvh.bounds.subarray(0, 6).reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  }

  encode(): number {
    if (this.#bvh.nodeCount === 0) return this.#node([]);
    return this.#node(leafCount(this.#bvh, 0) > 0 ? [0] : this.#childrenOf(0));
  }

  /** Two children, of which the largest that are no leaves are opened until there are four. */
  #childrenOf(node: number): number[] {
    const bvh = this.#bvh;
    const children = [firstChild(node), secondChild(bvh, node)];
    while (children.length < WIDTH) {
      let [opened, largest] = [-1, -1];
      children.forEach((child, k) => {
        if (leafCount(bvh, child) === 0 && halfArea(bvh, child) > largest)
          [opened, largest] = [k, halfArea(bvh, child)];
      });
      if (opened < 0) break;
      const child = children[opened]!;
      children.splice(opened, 1, firstChild(child), secondChild(bvh, child));
    }
    return children;
  }

  /** Writes the node and all below it; gives what waits on the stack at most. */
  #node(children: readonly number[]): number {
    const at = this.used++ * NODE_WORDS;
    let deepest = 0;
    children.forEach((child, k) => {
      this.#box(at, k, child);
      const count = leafCount(this.#bvh, child);
      if (count > 0) {
        this.#words[at + CHILDREN + k] = leafReference(firstPlace(this.#bvh, child), this.#ofInstances ? 0 : count);
        return;
      }
      this.#words[at + CHILDREN + k] = this.used;
      deepest = Math.max(deepest, this.#node(this.#childrenOf(child)));
    });
    for (let k = children.length; k < WIDTH; k++) this.#noBox(at, k);
    return Math.max(children.length - 1, 0) + deepest;
  }

  #noBox(at: number, k: number): void {
    for (let axis = 0; axis < 3; axis++) {
      this.#floats[at + LEAST + axis * WIDTH + k] = FAR;
      this.#floats[at + GREATEST + axis * WIDTH + k] = -FAR;
    }
  }

  #box(at: number, k: number, node: number): void {
    const { bounds } = this.#bvh;
    for (let axis = 0; axis < 3; axis++) {
      this.#floats[at + LEAST + axis * WIDTH + k] = bounds[6 * node + axis]! - this.#padding;
      this.#floats[at + GREATEST + axis * WIDTH + k] = bounds[6 * node + 3 + axis]! + this.#padding;
    }
  }
}

export function leafReference(first: number, count: number): number {
  if (count > MOST_IN_LEAF || first + count > MOST_PRIMITIVES)
    throw new RangeError(`A leaf of ${count} primitives from ${first} on has no reference.`);
  return (LEAF | (count << COUNT_SHIFT) | first) >>> 0;
}
