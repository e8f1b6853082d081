/**
 * The split of a few primitives by the surface area heuristic, exactly: along each axis they are sorted by their centres and
 * every place between two is weighed. For so few it is quicker than bins.
 */
import { centreOf, minLanes, NOTHING, packedArea } from './packed-box.ts';
import { isNarrow } from './split-range.ts';
import type { Workspace } from './workspace.ts';

function sortAlong(axis: number, work: Workspace, begin: number, count: number): void {
  const { records, order, line, centres } = work;
  for (let i = 0; i < count; i++) {
    const at = order[begin + i]!;
    const centre = centreOf(records[at + axis]!);
    let place = i;
    for (; place > 0 && centres[place - 1]! > centre; place--) {
      centres[place] = centres[place - 1]!;
      line[place] = line[place - 1]!;
    }
    centres[place] = centre;
    line[place] = at;
  }
}

/** Returns the packed half area of all. */
function sweepLineFromRight({ records, line, costs }: Workspace, count: number): number {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  let area = 0;
  let n = 0;
  for (let i = count - 1; i >= 0; i--) {
    const at = line[i]!;
    w0 = minLanes(w0, records[at]!);
    w1 = minLanes(w1, records[at + 1]!);
    w2 = minLanes(w2, records[at + 2]!);
    n = (n + 1 + (records[at + 3]! & 1)) | 0;
    area = packedArea(w0, w1, w2);
    costs[i] = area * n;
  }
  return area;
}

/** Returns how many are to be on the left, when that is cheaper than what was found before; otherwise 0. */
function sweepLineFromLeft({ records, line, costs, best }: Workspace, count: number): number {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  let left = 0;
  let n = 0;
  let least = best.cost;
  for (let i = 1; i < count; i++) {
    const at = line[i - 1]!;
    w0 = minLanes(w0, records[at]!);
    w1 = minLanes(w1, records[at + 1]!);
    w2 = minLanes(w2, records[at + 2]!);
    n = (n + 1 + (records[at + 3]! & 1)) | 0;
    const cost = packedArea(w0, w1, w2) * n + costs[i]!;
    if (cost < least) {
      least = cost;
      left = i;
    }
  }
  best.cost = least;
  return left;
}

function copy(from: Uint32Array, to: Uint32Array, at: number, count: number): void {
  for (let i = 0; i < count; i++) to[at + i] = from[i]!;
}

/** Two items can be split in one way; only whether they should be is a question. Half of all splits are such. */
export function weighTwo({ records, order, best }: Workspace, begin: number): void {
  const a = order[begin]!;
  const b = order[begin + 1]!;
  const a0 = records[a]!;
  const a1 = records[a + 1]!;
  const a2 = records[a + 2]!;
  const b0 = records[b]!;
  const b1 = records[b + 1]!;
  const b2 = records[b + 2]!;
  best.area = packedArea(minLanes(a0, b0), minLanes(a1, b1), minLanes(a2, b2));
  const left = packedArea(a0, a1, a2) * (1 + (records[a + 3]! & 1));
  best.cost = left + packedArea(b0, b1, b2) * (1 + (records[b + 3]! & 1));
}

/** Leaves the cheapest place in `best`, its `bin` being how many are on the left, and the area of the whole node. */
export function weighFew(work: Workspace, begin: number, end: number): void {
  const { best, line, bestLine } = work;
  const count = end - begin;
  best.cost = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    if (isNarrow(work, axis)) continue;
    sortAlong(axis, work, begin, count);
    best.area = sweepLineFromRight(work, count);
    const left = sweepLineFromLeft(work, count);
    if (left === 0) continue;
    best.bin = left;
    copy(line, bestLine, 0, count);
  }
}

export function splitFewAtBest(work: Workspace, begin: number, end: number): number {
  copy(work.bestLine, work.order, begin, end - begin);
  return begin + work.best.bin;
}
