/**
 * A tree with up to `width` children a node from the binary one: from a node's two children on, the inner one with the largest
 * area, the one that rays meet most, is replaced by its own two until there is no more room (Wald, Benthin and Boulos 2008).
 * Nodes stay in depth-first order. Width 2 numbers the inner nodes, as leaves are not stored.
 */
import { type Bvh, firstChild, halfArea, leafCount, secondChild } from '../bvh.ts';

export interface WideTree {
  readonly width: number;
  readonly nodeCount: number;
  /** `width` binary nodes a wide node, −1 behind the last one. */
  readonly children: Int32Array;
  /** The number of the wide node that starts at an inner binary node; elsewhere 0. */
  readonly numbers: Uint32Array;
  readonly stackSize: number;
  readonly depth: number;
}

/** Fills `slots` with the children of a wide node. */
function openLargest(bvh: Bvh, node: number, slots: number[], width: number): void {
  slots.length = 0;
  slots.push(firstChild(node), secondChild(bvh, node));
  while (slots.length < width) {
    let largest = -1;
    let area = -1;
    for (let s = 0; s < slots.length; s++) {
      if (leafCount(bvh, slots[s]!) > 0 || halfArea(bvh, slots[s]!) <= area) continue;
      largest = s;
      area = halfArea(bvh, slots[s]!);
    }
    if (largest < 0) return;
    const opened = slots[largest]!;
    slots.splice(largest, 1, firstChild(opened), secondChild(bvh, opened));
  }
}

/** A root that is a leaf becomes the only child of a node; without primitives that has none. */
function rootOnly(bvh: Bvh, width: number): WideTree {
  const children = new Int32Array(width).fill(-1);
  if (bvh.nodeCount > 0) children[0] = 0;
  return { width, nodeCount: 1, children, numbers: new Uint32Array(bvh.nodeCount), stackSize: 0, depth: 1 };
}

export function collapse(bvh: Bvh, width: number): WideTree {
  if (bvh.nodeCount === 0 || leafCount(bvh, 0) > 0) return rootOnly(bvh, width);
  const children = new Int32Array(Math.ceil(bvh.nodeCount / 2) * width).fill(-1);
  const numbers = new Uint32Array(bvh.nodeCount);
  const slots: number[] = [];
  const waiting = [{ node: 0, others: 0, level: 1 }];
  let nodeCount = 0;
  let stackSize = 0;
  let depth = 0;
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    openLargest(bvh, next.node, slots, width);
    numbers[next.node] = nodeCount;
    children.set(slots, nodeCount * width);
    nodeCount++;
    const inner = slots.filter((slot) => leafCount(bvh, slot) === 0);
    const others = next.others + Math.max(0, inner.length - 1);
    stackSize = Math.max(stackSize, others);
    depth = Math.max(depth, next.level);
    for (const node of inner.reverse()) waiting.push({ node, others, level: next.level + 1 });
  }
  return { width, nodeCount, children: children.slice(0, nodeCount * width), numbers, stackSize, depth };
}
