/**
 * 64 bytes a node: the boxes of both children as floats, then two references. Four times four words, in the order of Aila and Laine
 * (2009), so that a kernel reads four vectors:
 *
 *     0  child 0: least x, greatest x, least y, greatest y
 *     4  child 1: least x, greatest x, least y, greatest y
 *     8  least z, greatest z of child 0, least z, greatest z of child 1
 *    12  reference of child 0, of child 1, 0, 0
 *
 * A missing child has a box that ends before it begins.
 */
import type { Bvh } from '../bvh.ts';
import { addChild, type NodeSource } from '../trace/node-source.ts';
import { collapse } from './collapse.ts';
import { type EncodedNodes, indexOf, leafReference, NO_CHILD, primitivesOf } from './reference.ts';
import type { WideTree } from './wide-tree.ts';

const WORDS = 16;
/** Where the twelve numbers of a node lie: least x, y, z, greatest x, y, z of child 0, the same of child 1. */
const PLACES = [0, 2, 8, 1, 3, 9, 4, 6, 10, 5, 7, 11] as const;

/** To what is in a slot of a wide tree, counted over all its nodes. */
export function referenceTo({ children, counts, indices }: WideTree, slot: number): number {
  if (children[slot]! < 0) return NO_CHILD;
  return counts[slot]! > 0 ? leafReference(indices[slot]!, counts[slot]!) : indices[slot]!;
}

export function encodeWide2(bvh: Bvh): EncodedNodes {
  const tree = collapse(bvh, 2);
  const words = new Uint32Array(tree.nodeCount * WORDS);
  const floats = new Float32Array(words.buffer);
  for (let i = 0; i < tree.nodeCount; i++) {
    for (let slot = 0; slot < 2; slot++) {
      const child = tree.children[2 * i + slot]!;
      for (let k = 0; k < 6; k++) {
        floats[i * WORDS + PLACES[6 * slot + k]!] = child < 0 ? (k < 3 ? 1 : -1) : bvh.bounds[6 * child + k]!;
      }
      words[i * WORDS + 12 + slot] = referenceTo(tree, 2 * i + slot);
    }
  }
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth };
}

export function wide2Source({ words, stackSize }: EncodedNodes, order: Uint32Array): NodeSource {
  const floats = new Float32Array(words.buffer);
  return {
    root: 0,
    order,
    stackSize,
    readChildren(node, into) {
      into.count = 0;
      for (let slot = 0; slot < 2; slot++) {
        const reference = words[node * WORDS + 12 + slot]!;
        const bounds = PLACES.slice(6 * slot, 6 * slot + 6).map((place) => floats[node * WORDS + place]!);
        if (reference !== NO_CHILD) addChild(into, bounds, primitivesOf(reference), indexOf(reference));
      }
    },
  };
}
