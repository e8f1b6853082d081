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

/**
 * Along one axis, from where the bounds of both children stand. Without branches: which child goes farther is as good as random. A
 * comparison, negated, is a mask, all ones or none, that chooses one of two places.
 */
function uniteAxis(bounds: Float32Array, to: number, first: number, second: number): void {
  const firstIsLess = -(bounds[first]! < bounds[second]!) | 0;
  bounds[to] = bounds[second ^ ((first ^ second) & firstIsLess)]!;
  const a = first + 3;
  const b = second + 3;
  const secondIsLess = -(bounds[a]! < bounds[b]!) | 0;
  bounds[to + 3] = bounds[a ^ ((a ^ b) & secondIsLess)]!;
}

/** Bounds of inner nodes from those of leaves. */
export function uniteUpwards(nodeCount: number, links: Uint32Array, bounds: Float32Array): void {
  for (let i = nodeCount - 1; i >= 0; i--) {
    if (links[2 * i + 1] !== 0) continue;
    const to = 6 * i;
    const second = (6 * links[2 * i]!) | 0;
    uniteAxis(bounds, to, to + 6, second);
    uniteAxis(bounds, to + 1, to + 7, second + 1);
    uniteAxis(bounds, to + 2, to + 8, second + 2);
  }
}
