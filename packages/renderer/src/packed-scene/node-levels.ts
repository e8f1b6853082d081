/**
 * Children of the nodes of a packed tree by how many levels are below them: the boxes of a level can be fitted at once when all lower ones have
 * been. Leaves are the lowest.
 */
import { isLeaf, NODE_WORDS, referenceAt, WIDTH } from './encode-wide-bvh.ts';

export interface NodeLevels {
  /** All children, two numbers each: its slot, which is four times its node and which child of it; and the reference that stands there. */
  readonly children: Uint32Array<ArrayBuffer>;
  /** Where each level begins in `children`, counted in children, and the last one ends. A tree of nothing has no level. */
  readonly begins: Uint32Array<ArrayBuffer>;
}

/** Levels of inner nodes from a node down, itself counted. Children come after their parents. */
function heightsOf(nodes: Uint32Array): Uint32Array {
  const heights = new Uint32Array(nodes.length / NODE_WORDS).fill(1);
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
  const levels: number[][] = Array.from({ length: heights[0] ?? 0 }, () => []);
  for (let slot = 0; slot < WIDTH * heights.length; slot++) {
    const reference = referenceAt(nodes, Math.floor(slot / WIDTH), slot % WIDTH);
    if (reference !== 0) levels[isLeaf(reference) ? 0 : heights[reference]!]!.push(slot, reference);
  }
  const begins = new Uint32Array(levels.length + 1);
  levels.forEach((level, i) => {
    begins[i + 1] = begins[i]! + level.length / 2;
  });
  const children = new Uint32Array(2 * begins.at(-1)!);
  levels.forEach((level, i) => {
    children.set(level, 2 * begins[i]!);
  });
  return { children, begins };
}
