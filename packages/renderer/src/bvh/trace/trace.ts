/** Closest and any hit in a tree, plainly: the reference for encodings and kernels, and what brute force is compared with. */
import type { TriangleMesh } from '../bvh.ts';
import { type Children, type NodeSource, roomForChildren } from './node-source.ts';
import { hitTriangle, type Ray, type ShearedRay, shearRay, type TriangleHit } from './watertight.ts';

export interface Hit extends TriangleHit {
  readonly triangle: number;
}

/**
 * The triangle test takes corners a few roundings away from where they are, in proportion to how far they are from the ray's start. A
 * box is widened by more than that, so none of its hits is lost: not those within a face that the ray passes along, nor where a
 * distance is rounded to just before the box. Ize (2013) widens distances alone; that is not enough for rays along faces.
 */
const WIDER = 16 * 2 ** -53;

/** Where the ray enters child i; Infinity when it does not between tMin and `farthest`. */
function entry({ origin, direction, tMin }: Ray, { bounds }: Children, i: number, farthest: number): number {
  let reach = 0;
  for (let k = 0; k < 6; k++) reach = Math.max(reach, Math.abs(bounds[6 * i + k]! - origin[k % 3]!));
  const margin = reach * WIDER;
  let near = tMin;
  let far = farthest;
  for (let axis = 0; axis < 3; axis++) {
    const inverse = 1 / direction[axis]!;
    const least = (bounds[6 * i + axis]! - origin[axis]! - margin) * inverse;
    const greatest = (bounds[6 * i + axis + 3]! - origin[axis]! + margin) * inverse;
    // 0 · Infinity, in a face that is passed along, is NaN: no comparison holds, and the ray counts as between the faces.
    const first = inverse < 0 ? greatest : least;
    const second = inverse < 0 ? least : greatest;
    if (first > near) near = first;
    if (second < far) far = second;
  }
  return near <= far ? near : Infinity;
}

/** Of hits at the same distance the triangle with the lowest number counts, whatever the order of the tree. */
const isBetter = (hit: Hit, than: Hit | null): boolean =>
  than === null || hit.t < than.t || (hit.t === than.t && hit.triangle < than.triangle);

export function tryTriangle(ray: ShearedRay, mesh: TriangleMesh, triangle: number): Hit | null {
  const corners: number[] = [];
  for (let corner = 3 * triangle; corner < 3 * triangle + 3; corner++) {
    const v = mesh.indices[corner]! * 3;
    corners.push(mesh.positions[v]!, mesh.positions[v + 1]!, mesh.positions[v + 2]!);
  }
  const hit = hitTriangle(ray, corners);
  return hit && { ...hit, triangle };
}

/** A walk through the nodes that a ray meets, nearest child first. */
class Walk {
  private readonly stack: { readonly node: number; readonly t: number }[] = [];
  private readonly children = roomForChildren();

  constructor(
    private readonly source: NodeSource,
    private readonly ray: Ray,
    private readonly leaf: (triangle: number) => boolean,
  ) {}

  /** `farthest` tells beyond what distance nothing counts any more. Returns whether `leaf` wanted to stop. */
  run(farthest: () => number): boolean {
    const { source, stack } = this;
    let node: number | undefined = source.root;
    while (node !== undefined) {
      source.readChildren(node, this.children);
      if (this.visit(farthest)) return true;
      if (stack.length > source.stackSize + 1)
        throw new Error(`${stack.length - 1} nodes wait, promised were ${source.stackSize}`);
      node = stack.pop()?.node;
    }
    return false;
  }

  /** Leaves at once, inner nodes onto the stack, the nearest on top. */
  private visit(farthest: () => number): boolean {
    const { children, stack, ray, source } = this;
    const inner: { node: number; t: number }[] = [];
    for (let i = 0; i < children.count; i++) {
      const t = entry(ray, children, i, farthest());
      if (t === Infinity) continue;
      const [count, index] = [children.primitives[i]!, children.index[i]!];
      if (count === 0) inner.push({ node: index, t });
      for (let place = index; place < index + count; place++) {
        if (this.leaf(source.order[place]!)) return true;
      }
    }
    stack.push(...inner.sort((a, b) => b.t - a.t));
    return false;
  }
}

export function closestHit(source: NodeSource, mesh: TriangleMesh, ray: Ray): Hit | null {
  const sheared = shearRay(ray);
  let best: Hit | null = null;
  const walk = new Walk(source, ray, (triangle) => {
    const hit = tryTriangle(sheared, mesh, triangle);
    if (hit && isBetter(hit, best)) best = hit;
    return false;
  });
  walk.run(() => best?.t ?? ray.tMax);
  return best;
}

export function anyHit(source: NodeSource, mesh: TriangleMesh, ray: Ray): boolean {
  const sheared = shearRay(ray);
  return new Walk(source, ray, (triangle) => tryTriangle(sheared, mesh, triangle) !== null).run(() => ray.tMax);
}

/** Every triangle, one after another. */
export function closestByBruteForce(mesh: TriangleMesh, ray: Ray): Hit | null {
  const sheared = shearRay(ray);
  let best: Hit | null = null;
  for (let triangle = 0; triangle < mesh.indices.length / 3; triangle++) {
    const hit = tryTriangle(sheared, mesh, triangle);
    if (hit && isBetter(hit, best)) best = hit;
  }
  return best;
}
