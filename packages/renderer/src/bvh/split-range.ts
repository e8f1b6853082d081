/**
 * What a split looks at first: how far the centres of a node's primitives spread, on a grid that is fine enough for them, and
 * over how many of them. Loops that run for big and for small nodes stand alone in their functions, with nothing after them:
 * V8 compiles such a loop while it runs, and throws the code away when it comes to what it has never seen.
 */
import { centreOf, gridScale, minLanes, NOTHING, packBox, packedArea } from './packed-box.ts';
import type { Workspace } from './workspace.ts';

/** Least spread of centres, in half cells, on which bins are still fine enough. */
const FINE = 256;

function measureRange(work: Workspace, begin: number, end: number, stride: number): void {
  const { records, order, range } = work;
  let x0 = 0x7fff;
  let y0 = 0x7fff;
  let z0 = 0x7fff;
  let x1 = -0x7fff;
  let y1 = -0x7fff;
  let z1 = -0x7fff;
  for (let k = begin; k < end; k += stride) {
    const at = order[k]!;
    const x = centreOf(records[at]!);
    const y = centreOf(records[at + 1]!);
    const z = centreOf(records[at + 2]!);
    // Minima and maxima without branches: d >> 31 is all ones where d < 0.
    let d = (x - x0) | 0;
    x0 = (x0 + (d & (d >> 31))) | 0;
    d = (x1 - x) | 0;
    x1 = (x1 - (d & (d >> 31))) | 0;
    d = (y - y0) | 0;
    y0 = (y0 + (d & (d >> 31))) | 0;
    d = (y1 - y) | 0;
    y1 = (y1 - (d & (d >> 31))) | 0;
    d = (z - z0) | 0;
    z0 = (z0 + (d & (d >> 31))) | 0;
    d = (z1 - z) | 0;
    z1 = (z1 - (d & (d >> 31))) | 0;
  }
  range[0] = x0;
  range[1] = y0;
  range[2] = z0;
  range[3] = x1;
  range[4] = y1;
  range[5] = z1;
}

export const spreadAlong = ({ range }: Workspace, axis: number): number => range[axis + 3]! - range[axis]!;
export const isNarrow = (work: Workspace, axis: number): boolean =>
  spreadAlong(work, axis) < work.care.narrow * widestSpread(work);

export const widestSpread = (work: Workspace): number =>
  Math.max(spreadAlong(work, 0), spreadAlong(work, 1), spreadAlong(work, 2));

function uniteItems(work: Workspace, begin: number, end: number): void {
  const { records, order, boxes, nodeUnion: union } = work;
  for (let axis = 0; axis < 3; axis++) {
    union[axis] = Infinity;
    union[axis + 3] = -Infinity;
  }
  for (let k = begin; k < end; k++) {
    const i = (records[order[k]! + 3]! >>> 2) * 6;
    for (let axis = 0; axis < 3; axis++) {
      if (boxes[i + axis]! < union[axis]!) union[axis] = boxes[i + axis]!;
      if (boxes[i + axis + 3]! > union[axis + 3]!) union[axis + 3] = boxes[i + axis + 3]!;
    }
  }
}

/** Packs the boxes of a node anew, on a grid over this node alone. */
function refineGrid(work: Workspace, begin: number, end: number): void {
  const { records, order, boxes, nodeUnion: union } = work;
  uniteItems(work, begin, end);
  const scale = gridScale(union);
  for (let k = begin; k < end; k++) {
    const at = order[k]!;
    packBox(boxes, records[at + 3]!, records, at, union[0]!, union[1]!, union[2]!, scale);
  }
}

function unitePacked(work: Workspace, begin: number, end: number): void {
  const { records, order, packedUnion } = work;
  let w0 = NOTHING | 0;
  let w1 = NOTHING | 0;
  let w2 = NOTHING | 0;
  for (let k = begin; k < end; k++) {
    const at = order[k]!;
    w0 = minLanes(w0, records[at]!);
    w1 = minLanes(w1, records[at + 1]!);
    w2 = minLanes(w2, records[at + 2]!);
  }
  packedUnion[0] = w0;
  packedUnion[1] = w1;
  packedUnion[2] = w2;
}

/** Half the surface, in cells, of the box of all primitives of a node. */
export function areaOfAll(work: Workspace, begin: number, end: number): number {
  unitePacked(work, begin, end);
  const { packedUnion } = work;
  return packedArea(packedUnion[0]!, packedUnion[1]!, packedUnion[2]!);
}

/** Measures the `range` and returns the stride at which it did: 1 is every primitive. */
export function prepareRange(work: Workspace, begin: number, end: number, all: boolean): number {
  const count = end - begin;
  const { sample } = work.care;
  let stride = all || count < 2 * sample ? 1 : Math.floor(count / sample);
  measureRange(work, begin, end, stride);
  if (widestSpread(work) >= FINE) return stride;
  if (stride > 1) {
    stride = 1;
    measureRange(work, begin, end, 1);
    if (widestSpread(work) >= FINE) return 1;
  }
  refineGrid(work, begin, end);
  measureRange(work, begin, end, 1);
  return stride;
}
