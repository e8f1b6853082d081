/**
 * 128 bytes a node: four children, their boxes as floats, one coordinate of all four after another, so that a kernel tests four boxes
 * with six vectors:
 *
 *     0  least x of the four    4  least y    8  least z   12  greatest x   16  greatest y   20  greatest z
 *    24  four references       28  0, 0, 0, 0
 *
 * A missing child has a box that ends before it begins.
 */
import type { Bvh } from '../bvh.ts';
import { addChild, type NodeSource } from '../trace/node-source.ts';
import { collapse } from './collapse.ts';
import { type EncodedNodes, indexOf, NO_CHILD, primitivesOf } from './reference.ts';
import type { WideTree } from './wide-tree.ts';
import { referenceTo } from './wide2.ts';

const WORDS = 32;

/** `tree`: another way to collapse, as `cheapestCollapse(bvh, 4, 16)`. */
export function encodeWide4(bvh: Bvh, tree: WideTree = collapse(bvh, 4)): EncodedNodes {
  const words = new Uint32Array(tree.nodeCount * WORDS);
  const floats = new Float32Array(words.buffer);
  for (let i = 0; i < tree.nodeCount; i++) {
    for (let slot = 0; slot < 4; slot++) {
      const child = tree.children[4 * i + slot]!;
      for (let k = 0; k < 6; k++) {
        floats[i * WORDS + 4 * k + slot] = child < 0 ? (k < 3 ? 1 : -1) : bvh.bounds[6 * child + k]!;
      }
      words[i * WORDS + 24 + slot] = referenceTo(tree, 4 * i + slot);
    }
  }
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth };
}

export function wide4Source({ words, stackSize }: EncodedNodes, order: Uint32Array): NodeSource {
  const floats = new Float32Array(words.buffer);
  return {
    root: 0,
    order,
    stackSize,
    readChildren(node, into) {
      into.count = 0;
      for (let slot = 0; slot < 4; slot++) {
        const reference = words[node * WORDS + 24 + slot]!;
        const bounds = [0, 1, 2, 3, 4, 5].map((k) => floats[node * WORDS + 4 * k + slot]!);
        if (reference !== NO_CHILD) addChild(into, bounds, primitivesOf(reference), indexOf(reference));
      }
    },
  };
}
