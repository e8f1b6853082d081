/**
 * What is split: items of one or two primitives. Triangles that follow one another in a mesh, or in Morton's order, are often the
 * halves of one rectangle and have nearly the same box. Two are taken as one item where a leaf of both costs no more than a
 * node with two leaves: half the items, half the time.
 *
 * A pair of neighbours in the mesh is made before sorting and sorted as one, with the code 2 p + 1 for primitives p and p + 1;
 * a single one has the code 2 p. What is single then may be paired with a single neighbour in Morton's order.
 *
 * The code of an item is 4 k + kind: its box is box k, and `sorted[k]` is what it was sorted as. Kind 0 is a single primitive,
 * 1 a pair of the mesh, 3 a pair of two singles at k and k + 1. So the lowest bit says whether there are two.
 */
import { gridScale, packBox, RECORD } from './packed-box.ts';
import type { SplitRules } from './split.ts';
import type { Workspace } from './workspace.ts';

function halfAreaAt(boxes: Float32Array, at: number): number {
  const dx = boxes[at + 3]! - boxes[at]!;
  const dy = boxes[at + 4]! - boxes[at + 1]!;
  const dz = boxes[at + 5]! - boxes[at + 2]!;
  return dx * (dy + dz) + dy * dz;
}

/** Extent along an axis of the union with the next box. */
function extentOfBoth(boxes: Float32Array, at: number): number {
  const a = boxes[at]!;
  const b = boxes[at + 6]!;
  const c = boxes[at + 3]!;
  const d = boxes[at + 9]!;
  return (c > d ? c : d) - (a < b ? a : b);
}

function areaOfBoth(boxes: Float32Array, at: number): number {
  const dx = extentOfBoth(boxes, at);
  const dy = extentOfBoth(boxes, at + 1);
  const dz = extentOfBoth(boxes, at + 2);
  return dx * (dy + dz) + dy * dz;
}

/** Makes a box the union with the next. */
function joinNext(boxes: Float32Array, at: number): void {
  for (let i = at; i < at + 3; i++) {
    if (boxes[i + 6]! < boxes[i]!) boxes[i] = boxes[i + 6]!;
    if (boxes[i + 9]! > boxes[i + 3]!) boxes[i + 3] = boxes[i + 9]!;
  }
}

/**
 * A leaf of two costs 2 p A(both), a node with two leaves n A(both) + p A(first) + p A(second). So two are better off as one
 * where this share · A(both) ≤ A(first) + A(second). A tenth more is asked, since a pair can go neither left nor right alone.
 */
const pairShare = ({ nodeCost, primitiveCost }: SplitRules): number =>
  (1.1 * (2 * primitiveCost - nodeCost)) / primitiveCost;

/** How many places are looked at to see whether there are pairs at all. */
const LOOKS = 256;

/** Whether neighbours are hardly ever worth pairing: then looking at all of them takes longer than it saves. */
function hardlyPair(boxes: Float32Array, count: number, share: number): boolean {
  if (count < 4 * LOOKS) return false;
  const stride = Math.floor((count - 2) / LOOKS);
  let found = 0;
  for (let k = 0; k < LOOKS; k++) {
    // Both neighbours, since rectangles may begin at even places only.
    for (let at = 6 * k * stride, end = at + 12; at < end; at += 6) {
      if (share * areaOfBoth(boxes, at) <= halfAreaAt(boxes, at) + halfAreaAt(boxes, at + 6)) found++;
    }
  }
  return found < LOOKS / 64;
}

/** Pairs in the mesh: fills `codes` and returns how many. The box of a pair replaces that of its first triangle. */
function pairInMesh(boxes: Float32Array, count: number, share: number, codes: Uint32Array): number {
  let found = 0;
  let area = halfAreaAt(boxes, 0);
  for (let p = 1; p < count; p++) {
    const at = p * 6 - 6;
    let next = halfAreaAt(boxes, at + 6);
    if (share * areaOfBoth(boxes, at) <= area + next) {
      joinNext(boxes, at);
      // Nothing is left to be paired with the second one.
      next = -Infinity;
    }
    if (area >= 0) codes[found++] = 2 * p - 2 + (next < 0 ? 1 : 0);
    area = next;
  }
  if (area >= 0) codes[found++] = 2 * count - 2;
  return found;
}

function eachAlone(count: number, codes: Uint32Array): number {
  for (let p = 0; p < count; p++) codes[p] = 2 * p;
  return count;
}

/** Fills `order` with codes for sorting and returns how many. Boxes of pairs replace those of their first primitives. */
export function pairPrimitives(boxes: Float32Array, count: number, rules: SplitRules, order: Uint32Array): number {
  if (rules.maxLeafSize < 2 || count < 2) return eachAlone(count, order);
  const share = pairShare(rules);
  if (hardlyPair(boxes, count, share)) return eachAlone(count, order);
  return pairInMesh(boxes, count, share, order);
}

function sortBoxes(from: Float32Array, sorted: Uint32Array, count: number, to: Float32Array): void {
  for (let k = 0, at = 0; k < count; k++, at += 6) {
    const i = (sorted[k]! >>> 1) * 6;
    to[at] = from[i]!;
    to[at + 1] = from[i + 1]!;
    to[at + 2] = from[i + 2]!;
    to[at + 3] = from[i + 3]!;
    to[at + 4] = from[i + 4]!;
    to[at + 5] = from[i + 5]!;
  }
}

function sortedAlone(sorted: Uint32Array, count: number, codes: Uint32Array): number {
  for (let k = 0; k < count; k++) codes[k] = 4 * k + (sorted[k]! & 1);
  return count;
}

/** Pairs in Morton's order: fills `codes` with those of items and returns how many. */
function pairSorted(
  boxes: Float32Array,
  sorted: Uint32Array,
  count: number,
  share: number,
  codes: Uint32Array,
): number {
  let items = 0;
  for (let k = 0; k < count; k++) {
    const at = k * 6;
    let code = 4 * k + (sorted[k]! & 1);
    if (k + 1 < count && ((sorted[k]! | sorted[k + 1]!) & 1) === 0) {
      if (share * areaOfBoth(boxes, at) <= halfAreaAt(boxes, at) + halfAreaAt(boxes, at + 6)) {
        joinNext(boxes, at);
        code += 3;
        k++;
      }
    }
    codes[items++] = code;
  }
  return items;
}

function pack(work: Workspace, count: number): void {
  const { records, order, boxes, union } = work;
  const scale = gridScale(union);
  const ox = union[0]!;
  const oy = union[1]!;
  const oz = union[2]!;
  for (let k = 0; k < count; k++) {
    const code = order[k]!;
    const at = k * RECORD;
    packBox(boxes, code, records, at, ox, oy, oz, scale);
    records[at + 3] = code;
    order[k] = at;
  }
}

/** Boxes and records of the items, from what was `sorted` and its boxes. Returns how many items. */
export function gatherItems(work: Workspace, boxes: Float32Array, count: number, rules: SplitRules): number {
  sortBoxes(boxes, work.sorted, count, work.boxes);
  const share = pairShare(rules);
  const items =
    rules.maxLeafSize < 2 || hardlyPair(work.boxes, count, share)
      ? sortedAlone(work.sorted, count, work.order)
      : pairSorted(work.boxes, work.sorted, count, share, work.order);
  pack(work, items);
  return items;
}

/** Writes the primitives of an item from `place` on and returns the place behind them. */
export function placeItem(sorted: Uint32Array, code: number, order: Uint32Array, place: number): number {
  const k = code >>> 2;
  const first = sorted[k]! >>> 1;
  order[place] = first;
  if ((code & 1) === 0) return place + 1;
  order[place + 1] = code & 2 ? sorted[k + 1]! >>> 1 : first + 1;
  return place + 2;
}
