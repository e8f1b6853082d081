/** A tree by the surface area heuristic over the triangles of a mesh. */
import type { Bvh, TriangleMesh } from './bvh.ts';
import { triangleBoxes } from './primitive-boxes.ts';
import { SahTree } from './sah-tree.ts';
import { type SahOptions, splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

/** Items between two pauses, a few milliseconds. */
const PACE = 8192;

/** Yields the share that is done, 0 … 1, and returns the tree. Throws a RangeError as `triangleBoxes` does. */
export function* buildInSteps(mesh: TriangleMesh, options?: SahOptions): Generator<number, Bvh, void> {
  const rules = splitRules(options);
  const boxes = triangleBoxes(mesh);
  yield 0.05;
  const tree = new SahTree(new Workspace(), rules);
  tree.start(boxes, boxes.length / 6);
  while (tree.placed < tree.itemCount) {
    yield 0.2 + (0.75 * tree.placed) / tree.itemCount;
    tree.grow(PACE);
  }
  const { nodeCount, primitiveCount, order, depth } = tree;
  const bounds = tree.bounds.slice(0, nodeCount * 6);
  const links = tree.links.slice(0, nodeCount * 2);
  return { nodeCount, bounds, links, primitiveCount, order, depth };
}

/** At once, on this thread. The same mesh and options give the same tree, bit for bit. */
export function buildBvh(mesh: TriangleMesh, options?: SahOptions): Bvh {
  const steps = buildInSteps(mesh, options);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
