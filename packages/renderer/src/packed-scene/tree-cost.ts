/** What a tree of packed nodes costs by the surface area heuristic: `weighTree` of bend.wesl works out the same for a bent mesh. */
import { DEFAULT_COSTS } from '../bvh/bvh.ts';
import { countOf, isLeaf, NODE_WORDS, PADDING, referenceAt, WIDTH } from './encode-wide-bvh.ts';
import { fieldOffset } from './layout.ts';
import { floatsOf } from './packed-mesh.ts';

const LEAST = fieldOffset('WideNode', 'minX') / 4;
const GREATEST = fieldOffset('WideNode', 'maxX') / 4;
/**
 * Of the padding on both sides. It is more than two by what rounding may have added, so that boxes which were points have no surface: a tree
 * over triangles in one place is no measure for any other.
 */
const PADDED = 2.5;

/** Σ area(child) / area(all) · (1, or 1.25 × triangles of a leaf); 0 where nothing has a surface. `nodes`: the root's first. */
export function treeCost(nodes: Uint32Array<ArrayBuffer>): number {
  const floats = floatsOf(nodes);
  const all = boxAbout(floats, 0);
  const padding = PADDING * all.reduce((most, x) => Math.max(most, Math.abs(x)), 0);
  let sum = 0;
  for (let node = 0; node < nodes.length / NODE_WORDS; node++)
    for (let child = 0; child < WIDTH; child++) {
      const reference = referenceAt(nodes, node, child);
      const box = boxAt(floats, node * NODE_WORDS + child);
      sum += halfArea(box, padding) * (isLeaf(reference) ? DEFAULT_COSTS.primitive * countOf(reference) : 1);
    }
  return sum > 0 ? sum / halfArea(all, padding) : 0;
}

const boxAt = (floats: Float32Array, at: number): number[] =>
  [LEAST, GREATEST].flatMap((face) => [0, 1, 2].map((axis) => floats[at + face + axis * WIDTH]!));

/** About all children of a node. */
function boxAbout(floats: Float32Array, node: number): number[] {
  const boxes = Array.from({ length: WIDTH }, (_, child) => boxAt(floats, node + child));
  return boxes.reduce((all, box) => all.map((x, i) => (i < 3 ? Math.min(x, box[i]!) : Math.max(x, box[i]!))));
}

function halfArea(box: readonly number[], padding: number): number {
  const [x, y, z] = [0, 1, 2].map((axis) => Math.max(box[axis + 3]! - box[axis]! - PADDED * padding, 0)) as [number, number, number]; // biome-ignore format: one thought
  return x * (y + z) + y * z;
}
