/** The words of a wide tree → a binary tree again, so that its boxes can be fitted to triangles that have moved. */
import type { Bvh } from '../bvh/bvh.ts';
import { countOf, isLeaf, NODE_WORDS, NONE, placeOf, referenceAt, WIDTH } from './encode-wide-bvh.ts';

export interface DecodedBvh {
  /** Has the nodes of the wide one, and more that unite some of them. Its bounds are zeros: `refit` finds them. */
  readonly bvh: Bvh;
  /** Which of its nodes each of a wide node's four children is, as in `WideEncoder`. */
  readonly sources: Uint32Array;
}

/** `order`: of the primitives. */
export function decodeWideBvh(words: Uint32Array, order: Uint32Array): DecodedBvh {
  const { sources, links, depth } = new Decoder(words);
  const nodeCount = links.length / 2;
  const bounds = new Float32Array(6 * nodeCount);
  return {
    bvh: { nodeCount, bounds, links: Uint32Array.from(links), primitiveCount: order.length, order, depth },
    sources,
  };
}

class Decoder {
  readonly links: number[] = [];
  readonly sources: Uint32Array;
  depth = 0;
  readonly #words: Uint32Array;

  constructor(words: Uint32Array) {
    this.#words = words;
    this.sources = new Uint32Array((words.length / NODE_WORDS) * WIDTH).fill(NONE);
    this.#node(0, 0);
  }

  #node(node: number, depth: number): void {
    let count = 0;
    while (count < WIDTH && referenceAt(this.#words, node, count) !== 0) count++;
    if (count > 0) this.#unite(node, 0, count, depth);
  }

  /** One child, or a node over two halves of those from `begin` on. */
  #unite(node: number, begin: number, end: number, depth: number): void {
    if (end - begin === 1) {
      this.#child(node, begin, depth);
      return;
    }
    const first = this.links.push(0, 0) - 2;
    const middle = (begin + end) >> 1;
    this.#unite(node, begin, middle, depth + 1);
    this.links[first] = this.links.length / 2;
    this.#unite(node, middle, end, depth + 1);
  }

  #child(node: number, child: number, depth: number): void {
    const reference = referenceAt(this.#words, node, child);
    this.sources[node * WIDTH + child] = this.links.length / 2;
    if (isLeaf(reference)) {
      this.links.push(placeOf(reference), countOf(reference));
      this.depth = Math.max(this.depth, depth);
    } else this.#node(reference, depth);
  }
}
