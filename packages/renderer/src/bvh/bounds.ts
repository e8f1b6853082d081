/** Bounds of nodes. Children come after their parents, so one pass from the end does all inner nodes. */
import type { Workspace } from './workspace.ts';

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
    if (links[2 * i + 1] !== 0) continue;
    const to = 6 * i;
    const second = 6 * links[2 * i]!;
    let a = bounds[to + 6]!;
    let b = bounds[second]!;
    bounds[to] = a < b ? a : b;
    a = bounds[to + 7]!;
    b = bounds[second + 1]!;
    bounds[to + 1] = a < b ? a : b;
    a = bounds[to + 8]!;
    b = bounds[second + 2]!;
    bounds[to + 2] = a < b ? a : b;
    a = bounds[to + 9]!;
    b = bounds[second + 3]!;
    bounds[to + 3] = a > b ? a : b;
    a = bounds[to + 10]!;
    b = bounds[second + 4]!;
    bounds[to + 4] = a > b ? a : b;
    a = bounds[to + 11]!;
    b = bounds[second + 5]!;
    bounds[to + 5] = a > b ? a : b;
  }
}
