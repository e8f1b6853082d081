/**
 * The arrays of a build. They grow and never shrink, so that a tree built every frame allocates nothing. What belongs to one
 * split lies here too and not in modules: V8 is quick with what comes in an argument, not with a bundler's `var`.
 */
import { CAREFUL, type Care, MOST_FEW } from './care.ts';
import { RECORD } from './packed-box.ts';

export const MOST_BINS = 32;

export class Workspace {
  // Of one split: see split-range.ts, binned-split.ts and exact-split.ts.

  /** Least and greatest `centreOf` the items looked at last: x, y, z, x, y, z. */
  readonly range = new Int32Array(6);
  readonly nodeUnion = new Float64Array(6);
  readonly packedUnion = new Int32Array(3);
  /** Four words a bin: its packed box, its count. */
  readonly bins = new Int32Array(MOST_BINS * 4);
  /** Of what lies right of a border. Costs are packed half areas × counts. */
  readonly costs = new Float64Array(MOST_BINS);
  /** The best border found so far: left of this bin; and the packed half area of the node. */
  readonly best = { cost: Infinity, area: 0.5, axis: 0, bin: 0, factor: 0 };
  readonly line = new Uint32Array(MOST_FEW);
  readonly bestLine = new Uint32Array(MOST_FEW);
  readonly centres = new Int32Array(MOST_FEW);

  // Of one tree. Primitives are numbered as they came; items are explained in items.ts.

  care: Care = CAREFUL;
  /** Items for which there is room. */
  capacity = 0;
  readonly union = new Float64Array(6);
  /** How many Morton codes have each value of their low, middle and high ten bits; then where the next of them goes. */
  readonly buckets = new Uint32Array(3 * 1024);
  /** Morton codes; later what a partition has to put aside. */
  codes = new Uint32Array(0);
  sortedCodes = new Uint32Array(0);
  /** Primitives and pairs in Morton's order. */
  sorted = new Uint32Array(0);
  /** Of the items, six floats each. */
  boxes = new Float32Array(0);
  /** Packed boxes and codes of the items; see packed-box.ts. */
  records = new Int32Array(0);
  /** Where the record of each item starts: what splits sort. */
  order = new Uint32Array(0);

  /** Room for so many primitives. */
  fit(count: number): void {
    if (count <= this.capacity) return;
    const capacity = Math.max(count, this.capacity * 2);
    this.capacity = capacity;
    this.codes = new Uint32Array(capacity);
    this.sortedCodes = new Uint32Array(capacity);
    this.sorted = new Uint32Array(capacity);
    this.order = new Uint32Array(capacity);
    this.boxes = new Float32Array(capacity * 6);
    this.records = new Int32Array(capacity * RECORD);
  }
}
