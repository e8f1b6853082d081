/** Nodes of a packed tree by how many levels are below them: those of a level can be fitted at once when all lower ones have been. */
import { isLeaf, NODE_WORDS, referenceAt, WIDTH } from './encode-wide-bvh.ts';

export interface NodeLevels {
  /** All nodes that have inner children, the lowest first. */
  readonly order: Uint32Array<ArrayBuffer>;
  /** Where each level begins in `order`, and the last one ends. A tree without inner children has no level. */
  readonly begins: Uint32Array<ArrayBuffer>;
}

/** Inner nodes below a node on the longest way down. Children come after their parents. */
function heightsOf(nodes: Uint32Array): Uint32Array {
  const heights = new Uint32Array(nodes.length / NODE_WORDS);
  for (let node = heights.length - 1; node >= 0; node--)
    for (let child = 0; child < WIDTH; child++) {
      const reference = referenceAt(nodes, node, child);
      if (reference !== 0 && !isLeaf(reference)) heights[node] = Math.max(heights[node]!, heights[reference]! + 1);
    }
  return heights;
}

/** `nodes`: the words of all, the root's first. */
export function nodeLevels(nodes: Uint32Array): NodeLevels {
  const heights = heightsOf(nodes);
  const begins = new Uint32Array((heights[0] ?? 0) + 1);
  for (const height of heights) if (height > 0) begins[height] = begins[height]! + 1;
  for (let level = 1; level < begins.length; level++) begins[level] = begins[level]! + begins[level - 1]!;
  const order = new Uint32Array(begins.at(-1)!);
  const next = begins.slice();
  for (let node = 0; node < heights.length; node++) {
    const level = heights[node]! - 1;
    if (level < 0) continue;
    order[next[level]!] = node;
    next[level] = next[level]! + 1;
  }
  return { order, begins };
}
