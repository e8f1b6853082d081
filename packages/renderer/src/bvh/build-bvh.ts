/** A tree by the surface area heuristic over the triangles of a mesh. */
import { boundNodes } from './bounds.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';
import { triangleBoxes } from './primitive-boxes.ts';
import { SahTree } from './sah-tree.ts';
import { type SahOptions, splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

/** Primitives between two pauses, a few milliseconds. */
const PACE = 8192;

/** Yields the share that is done, 0 … 1, and returns the tree. Throws a RangeError as `triangleBoxes` does. */
export function* buildInSteps(mesh: TriangleMesh, options?: SahOptions): Generator<number, Bvh, void> {
  const boxes = triangleBoxes(mesh);
  const count = boxes.length / 6;
  yield 0.05;
  const work = new Workspace();
  const tree = new SahTree(work, splitRules(options));
  tree.start(boxes, count);
  while (tree.placed < count) {
    yield 0.2 + (0.75 * tree.placed) / count;
    tree.grow(PACE);
  }
  const { nodeCount, depth } = tree;
  const bounds = new Float32Array(nodeCount * 6);
  boundNodes(nodeCount, work.links, work.order, boxes, bounds);
  return {
    nodeCount,
    bounds,
    links: work.links.slice(0, nodeCount * 2),
    primitiveCount: count,
    order: work.order,
    depth,
  };
}

/** At once, on this thread. The same mesh and options give the same tree, bit for bit. */
export function buildBvh(mesh: TriangleMesh, options?: SahOptions): Bvh {
  const steps = buildInSteps(mesh, options);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value;
  }
}
