/**
 * 32 bytes a node: the boxes of both children on a grid of 65536 planes an axis over the whole tree, then two references:
 *
 *     0  child 0: least x + 65536 · greatest x    1  the same of y    2  of z
 *     3  child 1: the same three words            6  reference of child 0      7  of child 1
 *
 * A kernel need not decode planes: in units of the grid, with the origin (o − start) / cell and the direction d / cell, a ray meets them
 * as they are, at the same distances. Cells are powers of two, so only the difference o − start is rounded; boxes have to be widened by
 * as much. A grid over all is too coarse where triangles are smaller than 1/65536 of the mesh: boxes are right then, but large.
 */
import type { Bvh } from '../bvh.ts';
import { addChild, type NodeSource } from '../trace/node-source.ts';
import { collapse } from './collapse.ts';
import { decodePlane, type Grid, gridsOver, NO_BOX, quantiseGreatest, quantiseLeast } from './quantise.ts';
import { type EncodedNodes, indexOf, NO_CHILD, primitivesOf } from './reference.ts';
import { referenceTo } from './wide2.ts';

const WORDS = 8;
const LIMIT = 65535;

export interface QuantisedNodes extends EncodedNodes {
  /** Of x, y and z. */
  readonly grids: readonly Grid[];
}

export function encodeQuantised2(bvh: Bvh): QuantisedNodes {
  const tree = collapse(bvh, 2);
  const grids = gridsOver(bvh.nodeCount > 0 ? bvh.bounds : NO_BOX, 0, LIMIT);
  const words = new Uint32Array(tree.nodeCount * WORDS);
  for (let i = 0; i < tree.nodeCount; i++) {
    for (let slot = 0; slot < 2; slot++) {
      const child = tree.children[2 * i + slot]!;
      for (let axis = 0; axis < 3; axis++) {
        const at = 6 * child + axis;
        // Nothing lies between the last plane and the first.
        const least = child < 0 ? LIMIT : quantiseLeast(grids[axis]!, bvh.bounds[at]!);
        const greatest = child < 0 ? 0 : quantiseGreatest(grids[axis]!, bvh.bounds[at + 3]!);
        words[i * WORDS + 3 * slot + axis] = least | (greatest << 16);
      }
      words[i * WORDS + 6 + slot] = referenceTo(tree, 2 * i + slot);
    }
  }
  return { words, nodeCount: tree.nodeCount, stackSize: tree.stackSize, depth: tree.depth, grids };
}

export function quantised2Source({ words, stackSize, grids }: QuantisedNodes, order: Uint32Array): NodeSource {
  return {
    root: 0,
    order,
    stackSize,
    readChildren(node, into) {
      into.count = 0;
      for (let slot = 0; slot < 2; slot++) {
        const reference = words[node * WORDS + 6 + slot]!;
        const packed = [0, 1, 2].map((axis) => words[node * WORDS + 3 * slot + axis]!);
        const least = packed.map((word, axis) => decodePlane(grids[axis]!, word & LIMIT));
        const greatest = packed.map((word, axis) => decodePlane(grids[axis]!, word >>> 16));
        if (reference !== NO_CHILD)
          addChild(into, [...least, ...greatest], primitivesOf(reference), indexOf(reference));
      }
    },
  };
}
