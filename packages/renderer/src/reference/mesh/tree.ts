/**
 * Boxes around boxes of triangles, so that a ray looks at few of them. As plain as can be: halves at the mean of the centres. It has
 * nothing in common with the trees that the kernels walk, which tests hold against this one.
 */
import type { Mesh } from '../../scene/mesh.ts';
import { intersectTriangle, type MeshRay, type TriangleHit } from './triangle.ts';

export interface MeshTree {
  /** Six numbers a node: least x, y, z, then most. */
  readonly bounds: Float64Array;
  /** Two numbers a node. Of a leaf: its first place in `order`, and how many triangles it has; else its first child, and 0. The second child follows the first. */
  readonly nodes: Uint32Array;
  readonly order: Uint32Array;
}

const LEAF = 4;
/** Deeper than halves of 2³² triangles. */
const DEEPEST = 64;

/** A mesh does not change. */
const known = new WeakMap<Mesh, MeshTree>();

export function treeOf(mesh: Mesh): MeshTree {
  let tree = known.get(mesh);
  if (tree === undefined) {
    tree = buildTree(mesh);
    known.set(mesh, tree);
  }
  return tree;
}

/** The same `Mesh` may have been copied on its way to a worker, and then has a tree of its own there. */
function buildTree({ positions, indices }: Mesh): MeshTree {
  const triangles = indices.length / 3;
  const order = Uint32Array.from({ length: triangles }, (_, k) => k);
  const bounds = new Float64Array(6 * 2 * triangles);
  const nodes = new Uint32Array(2 * 2 * triangles);
  const corner = (triangle: number, k: number, c: number) => positions[3 * indices[3 * triangle + k]! + c]!;
  const middle = (triangle: number, c: number) =>
    corner(triangle, 0, c) + corner(triangle, 1, c) + corner(triangle, 2, c);
  let used = 1;
  const open: [node: number, first: number, count: number, depth: number][] = [[0, 0, triangles, 0]];
  for (let next = open.pop(); next; next = open.pop()) {
    const [node, first, count, depth] = next;
    const part = order.subarray(first, first + count);
    bounds.set(boundsAround(part, corner), 6 * node);
    if (count <= LEAF || depth >= DEEPEST) {
      nodes.set([first, count], 2 * node);
      continue;
    }
    const half = halve(part, middle);
    nodes.set([used, 0], 2 * node);
    open.push([used, first, half, depth + 1], [used + 1, first + half, count - half, depth + 1]);
    used += 2;
  }
  return { bounds: bounds.slice(0, 6 * used), nodes: nodes.slice(0, 2 * used), order };
}

function boundsAround(part: Uint32Array, corner: (triangle: number, k: number, c: number) => number): number[] {
  const around = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
  for (const triangle of part)
    for (let k = 0; k < 3; k++)
      for (let c = 0; c < 3; c++) {
        const x = corner(triangle, k, c);
        if (x < around[c]!) around[c] = x;
        if (x > around[c + 3]!) around[c + 3] = x;
      }
  return around;
}

/** Sorts the part into two, at the mean of the axis along which centres spread most; gives how many come first: at least one, not all. */
function halve(part: Uint32Array, middle: (triangle: number, c: number) => number): number {
  let best = { spread: -1, axis: 0, mean: 0 };
  for (let axis = 0; axis < 3; axis++) {
    let [least, most, sum] = [Infinity, -Infinity, 0];
    for (const triangle of part) {
      const x = middle(triangle, axis);
      least = Math.min(least, x);
      most = Math.max(most, x);
      sum += x;
    }
    if (most - least > best.spread) best = { spread: most - least, axis, mean: sum / part.length };
  }
  let half = 0;
  for (let k = 0; k < part.length; k++) {
    if (!(middle(part[k]!, best.axis) < best.mean)) continue;
    [part[k], part[half]] = [part[half]!, part[k]!];
    half++;
  }
  return half > 0 && half < part.length ? half : part.length >> 1;
}

export interface MeshHit extends TriangleHit {
  readonly triangle: number;
}

/**
 * The first triangle that the ray meets between `least` and `most`, neither of them included, that is not `leaving`, and of which
 * `isThere` says so.
 */
export function closestTriangle(
  mesh: Mesh,
  { bounds, nodes, order }: MeshTree,
  ray: MeshRay,
  least: number,
  most: number,
  leaving: number,
  isThere: (hit: MeshHit) => boolean = () => true,
): MeshHit | null {
  const { indices, positions } = mesh;
  let closest: MeshHit | null = null;
  let nearest = most;
  const open = [0];
  for (let node = open.pop(); node !== undefined; node = open.pop()) {
    // Looked at again, as something nearer may have been met since it was put off.
    if (!(entersBox(bounds, 6 * node, ray) <= nearest)) continue;
    const [first, count] = [nodes[2 * node]!, nodes[2 * node + 1]!];
    if (count === 0) {
      const secondIsNearer = entersBox(bounds, 6 * first + 6, ray) < entersBox(bounds, 6 * first, ray);
      open.push(secondIsNearer ? first : first + 1, secondIsNearer ? first + 1 : first);
    }
    for (let k = first; k < first + count; k++) {
      const triangle = order[k]!;
      if (triangle === leaving) continue;
      const at = 3 * triangle;
      const hit = intersectTriangle(ray, positions, 3 * indices[at]!, 3 * indices[at + 1]!, 3 * indices[at + 2]!);
      if (hit === null || !(hit.t > least && hit.t < nearest)) continue;
      const met = { ...hit, triangle };
      if (!isThere(met)) continue;
      closest = met;
      nearest = hit.t;
    }
  }
  return closest;
}

/** What rounding may move the ends of a stretch by: 2 γ(3) in T. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013. */
const SLACK = 1 + 2 * ((3 * 2 ** -53) / (1 - 3 * 2 ** -53));

/** Where the ray gets into the box, 0 when it begins there; Infinity when it passes by. */
function entersBox(bounds: Float64Array, at: number, { origin, direction }: MeshRay): number {
  let near = 0;
  let far = Infinity;
  for (let c = 0; c < 3; c++) {
    const low = bounds[at + c]! - origin[c]!;
    const high = bounds[at + c + 3]! - origin[c]!;
    const d = direction[c]!;
    if (d === 0) {
      if (low > 0 || high < 0) return Infinity;
      continue;
    }
    near = Math.max(near, (d > 0 ? low : high) / d);
    far = Math.min(far, ((d > 0 ? high : low) / d) * SLACK);
  }
  return near <= far ? near : Infinity;
}
