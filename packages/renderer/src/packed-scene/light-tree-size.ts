/** How large a light tree is: light-tree.ts builds it. */

/** Children of a node. */
export const WIDTH = 4;

/** Levels of nodes for so many lights. */
export function treeDepth(lights: number): number {
  let depth = 1;
  while (WIDTH ** depth < lights) depth++;
  return depth;
}

/** Nodes of that many levels. */
export const treeNodes = (lights: number): number => (WIDTH ** treeDepth(lights) - 1) / (WIDTH - 1);
