/** Bounds of nodes. Children come after their parents, so one pass from the end does all inner nodes. */
import type { Workspace } from './workspace.ts';

/** Writes the union of the boxes of both children into node i. */
export function uniteChildren(bounds: Float32Array, i: number, second: number): void {
  const to = 6 * i;
  const a = to + 6;
  const b = 6 * second;
  for (let k = 0; k < 3; k++) {
    const least = bounds[b + k]!;
    bounds[to + k] = bounds[a + k]! < least ? bounds[a + k]! : least;
    const greatest = bounds[b + 3 + k]!;
    bounds[to + 3 + k] = bounds[a + 3 + k]! > greatest ? bounds[a + 3 + k]! : greatest;
  }
}

/** Bounds of a leaf from its items, which `order` has from begin to end. */
export function boundItems(
  { boxes, order, records }: Workspace,
  begin: number,
  end: number,
  bounds: Float32Array,
  node: number,
): void {
  let x0 = Infinity;
  let y0 = Infinity;
  let z0 = Infinity;
  let x1 = -Infinity;
  let y1 = -Infinity;
  let z1 = -Infinity;
  for (let k = begin; k < end; k++) {
    const i = (records[order[k]! + 3]! >>> 2) * 6;
    if (boxes[i]! < x0) x0 = boxes[i]!;
    if (boxes[i + 1]! < y0) y0 = boxes[i + 1]!;
    if (boxes[i + 2]! < z0) z0 = boxes[i + 2]!;
    if (boxes[i + 3]! > x1) x1 = boxes[i + 3]!;
    if (boxes[i + 4]! > y1) y1 = boxes[i + 4]!;
    if (boxes[i + 5]! > z1) z1 = boxes[i + 5]!;
  }
  const to = node * 6;
  bounds[to] = x0;
  bounds[to + 1] = y0;
  bounds[to + 2] = z0;
  bounds[to + 3] = x1;
  bounds[to + 4] = y1;
  bounds[to + 5] = z1;
}

/** Bounds of inner nodes from those of leaves. */
export function uniteUpwards(nodeCount: number, links: Uint32Array, bounds: Float32Array): void {
  for (let i = nodeCount - 1; i >= 0; i--) {
    if (links[2 * i + 1] === 0) uniteChildren(bounds, i, links[2 * i]!);
  }
}
