/**
 * Which binary nodes become the children of a wide node, quickly: from its two children on, the inner one with the largest area, the
 * one that rays meet most, is replaced by its own two until there is no more room (Wald, Benthin and Boulos 2008). Width 2 leaves the
 * tree as it is, without storing leaves.
 */
import { type Bvh, firstChild, halfArea, leafCount, secondChild } from '../bvh.ts';
import { type Opened, type WideTree, wideTree } from './wide-tree.ts';

/** Which of the nodes has the largest area and can be opened; −1 if none. */
function largestInner(bvh: Bvh, nodes: readonly number[]): number {
  let largest = -1;
  let area = -1;
  nodes.forEach((node, s) => {
    if (leafCount(bvh, node) > 0 || halfArea(bvh, node) <= area) return;
    largest = s;
    area = halfArea(bvh, node);
  });
  return largest;
}

function openLargest(bvh: Bvh, node: number, width: number): Opened[] {
  const nodes = [firstChild(node), secondChild(bvh, node)];
  while (nodes.length < width) {
    const largest = largestInner(bvh, nodes);
    if (largest < 0) break;
    const opened = nodes[largest]!;
    nodes.splice(largest, 1, firstChild(opened), secondChild(bvh, opened));
  }
  return nodes.map((child) => ({ node: child, isLeaf: leafCount(bvh, child) > 0 }));
}

export const collapse = (bvh: Bvh, width: number): WideTree =>
  wideTree(bvh, width, (node) => openLargest(bvh, node, width));
