/**
 * Where to split a node by the surface area heuristic over bins (Wald 2007): primitives are sorted into slices by their
 * centres; for each border between two slices the cost of a split is area × count on the left plus the same on the right.
 */
import type { Care } from './care.ts';
import { centreOf, minLanes, NOTHING, packedArea } from './packed-box.ts';
import { isNarrow, spreadAlong } from './split-range.ts';
import { MOST_BINS, type Workspace } from './workspace.ts';

/** Binary places of the factor from twice-the-centre to bin; with 17 places of the other and 5 of a bin it stays below 2³². */
const PLACES = 26;

/** Small nodes are many, and their bins are mostly empty. Big ones are sampled, and finer bins cost them nothing. */
const binsFor = (count: number, { coarse }: Care): number => (count <= coarse ? 8 : count <= 1024 ? 16 : MOST_BINS);

function clearBins(bins: Int32Array, count: number): void {
  const nothing = NOTHING | 0;
  for (let at = 0; at < count * 4; at += 4) {
    bins[at] = nothing;
    bins[at + 1] = nothing;
    bins[at + 2] = nothing;
    bins[at + 3] = 0;
  }
}

function fillBins(work: Workspace, begin: number, end: number, stride: number, axis: number, factor: number): void {
  const { records, order, range, bins } = work;
  const from = range[axis]!;
  const places = PLACES | 0;
  for (let k = begin; k < end; k += stride) {
    const at = order[k]!;
    const centre = (centreOf(records[at + axis]!) - from) | 0;
    const bin = (Math.imul(centre, factor) >>> places) << 2;
    bins[bin] = minLanes(bins[bin]!, records[at]!);
    bins[bin + 1] = minLanes(bins[bin + 1]!, records[at + 1]!);
    bins[bin + 2] = minLanes(bins[bin + 2]!, records[at + 2]!);
    bins[bin + 3] = (bins[bin + 3]! + 1 + (records[at + 3]! & 1)) | 0;
  }
}

/** Returns the packed half area of all bins together. */
function sweepFromRight({ bins, costs }: Workspace, count: number): number {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  let n = 0;
  let area = 0;
  for (let i = count - 1; i >= 0; i--) {
    const at = i * 4;
    w0 = minLanes(w0, bins[at]!);
    w1 = minLanes(w1, bins[at + 1]!);
    w2 = minLanes(w2, bins[at + 2]!);
    n = (n + bins[at + 3]!) | 0;
    area = packedArea(w0, w1, w2);
    costs[i] = area * n;
  }
  return area;
}

/** Empty sides never win: their split costs as much as the whole node, and a proper one, found first, at most that. */
function sweepFromLeft({ bins, costs, best }: Workspace, count: number, axis: number, factor: number): void {
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  let n = 0;
  let bin = 0;
  let least = best.cost;
  for (let i = 1; i < count; i++) {
    const at = i * 4;
    w0 = minLanes(w0, bins[at - 4]!);
    w1 = minLanes(w1, bins[at - 3]!);
    w2 = minLanes(w2, bins[at - 2]!);
    n = (n + bins[at - 1]!) | 0;
    const cost = packedArea(w0, w1, w2) * n + costs[i]!;
    if (cost < least) {
      least = cost;
      bin = i;
    }
  }
  if (bin === 0) return;
  best.cost = least;
  best.axis = axis;
  best.bin = bin;
  best.factor = factor;
}

/** Leaves the cheapest border in `best`, and the area of the whole node. Some axis must have a spread. */
export function weighBins(work: Workspace, begin: number, end: number, stride: number): void {
  const { bins, best, care } = work;
  const count = binsFor(end - begin, care);
  best.cost = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    if (isNarrow(work, axis)) continue;
    const factor = ((count * 2 ** PLACES) / (spreadAlong(work, axis) + 1)) | 0;
    clearBins(bins, count);
    fillBins(work, begin, end, stride, axis, factor);
    best.area = sweepFromRight(work, count);
    sweepFromLeft(work, count, axis, factor);
  }
}

/** Keeps the order within both sides. Without branches: which side is as good as random. */
function partition(work: Workspace, begin: number, end: number, axis: number, threshold: number): number {
  const { records, order, codes: spare } = work;
  let left = begin;
  let right = 0;
  for (let k = begin; k < end; k++) {
    const at = order[k]!;
    const beyond = (centreOf(records[at + axis]!) - threshold) | 0;
    order[left] = at;
    spare[right] = at;
    const isLeft = beyond >>> 31;
    left = (left + isLeft) | 0;
    right = (right + 1 - isLeft) | 0;
  }
  return left;
}

function copyBack(spare: Uint32Array, order: Uint32Array, to: number, end: number): void {
  for (let k = to; k < end; k++) order[k] = spare[k - to]!;
}

/** Sorts the primitives left of the `best` border to the front; returns where those right of it begin. */
export function splitAtBest(work: Workspace, begin: number, end: number): number {
  const { best, range } = work;
  const { axis, bin, factor } = best;
  // The least centre of that bin: (centre − range) · factor ≥ bin · 2^PLACES.
  const threshold = (Math.ceil((bin * 2 ** PLACES) / factor) + range[axis]!) | 0;
  const middle = partition(work, begin, end, axis, threshold);
  copyBack(work.codes, work.order, middle, end);
  return middle;
}
