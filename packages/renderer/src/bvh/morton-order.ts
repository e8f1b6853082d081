/**
 * Primitives sorted along Morton's curve: 10 bits an axis of twice the centre, interleaved (Lauterbach et al. 2009), by a
 * radix sort with three passes of 10 bits. Neighbours in space are then neighbours in memory, and every k-th item of a
 * range is a fair sample of it.
 */
import { uniteBoxes } from './primitive-boxes.ts';
import type { Workspace } from './workspace.ts';

const BITS = 10;
const BUCKETS = 1 << BITS;

/** The bits of a number with two zeros after each. */
const SPREAD = Uint32Array.from({ length: BUCKETS }, (_, n) => {
  let spaced = 0;
  for (let bit = 0; bit < BITS; bit++) spaced |= ((n >> bit) & 1) << (3 * bit);
  return spaced;
});

function countCodes(work: Workspace, boxes: Float32Array, count: number): void {
  const { codes, order, buckets, union } = work;
  const spread = SPREAD;
  const extent = Math.max(union[3]! - union[0]!, union[4]! - union[1]!, union[5]! - union[2]!);
  const scale = extent > 0 ? (BUCKETS * 0.49999) / extent : 0;
  const ox = 2 * union[0]!;
  const oy = 2 * union[1]!;
  const oz = 2 * union[2]!;
  for (let k = 0; k < count; k++) {
    const i = (order[k]! >>> 1) * 6;
    const x = ((boxes[i]! + boxes[i + 3]! - ox) * scale) | 0;
    const y = ((boxes[i + 1]! + boxes[i + 4]! - oy) * scale) | 0;
    const z = ((boxes[i + 2]! + boxes[i + 5]! - oz) * scale) | 0;
    const code = spread[x]! | (spread[y]! << 1) | (spread[z]! << 2);
    codes[k] = code;
    buckets[code & 0x3ff]!++;
    buckets[0x400 + ((code >>> 10) & 0x3ff)]!++;
    buckets[0x800 + (code >>> 20)]!++;
  }
}

function startBuckets(buckets: Uint32Array, first: number, end: number): void {
  let start = 0;
  for (let i = first; i < end; i++) {
    const size = buckets[i]!;
    buckets[i] = start;
    start += size;
  }
}

function scatter(
  buckets: Uint32Array,
  count: number,
  digit: number,
  codes: Uint32Array,
  order: Uint32Array,
  toCodes: Uint32Array,
  toOrder: Uint32Array,
): void {
  const shift = (digit * BITS) | 0;
  const first = (digit * BUCKETS) | 0;
  for (let i = 0; i < count; i++) {
    const code = codes[i]!;
    const to = buckets[first + ((code >>> shift) & 0x3ff)]!++;
    toCodes[to] = code;
    toOrder[to] = order[i]!;
  }
}

/**
 * Measures the `union` of the boxes, sorts what is in `order`, with codes as items.ts explains them, into `sorted`, and the
 * Morton codes into `sortedCodes`. Stable: what has equal ones stays in the order in which it came.
 */
export function sortByMorton(work: Workspace, boxes: Float32Array, count: number): void {
  const { codes, order, sortedCodes, sorted, buckets } = work;
  uniteBoxes(boxes, order, count, work.union);
  buckets.fill(0);
  countCodes(work, boxes, count);
  for (let digit = 0; digit < 3; digit++) startBuckets(buckets, digit * BUCKETS, (digit + 1) * BUCKETS);
  scatter(buckets, count, 0, codes, order, sortedCodes, sorted);
  scatter(buckets, count, 1, sortedCodes, sorted, codes, order);
  scatter(buckets, count, 2, codes, order, sortedCodes, sorted);
}
