/**
 * The arrays of a build. They grow and never shrink, so that a tree built every frame allocates nothing. What belongs to one
 * split lies here too and not in modules: V8 is quick with what comes in an argument, not with a bundler's `var`.
 */
import { RECORD } from './packed-box.ts';

export const MOST_BINS = 32;
/** So many primitives or fewer are split exactly. */
export const FEW = 8;

export class Workspace {
  // Of one split: see split-range.ts, binned-split.ts and exact-split.ts.

  /** Least and greatest `centreOf` the primitives looked at last: x, y, z, x, y, z. */
  readonly range = new Int32Array(6);
  readonly union = new Float64Array(6);
  readonly packedUnion = new Int32Array(3);
  /** Four words a bin: its packed box, its count. */
  readonly bins = new Int32Array(MOST_BINS * 4);
  /** Of what lies right of a border. Costs are packed half areas × counts. */
  readonly costs = new Float64Array(MOST_BINS);
  /** The best border found so far: left of this bin; and the packed half area of the node. */
  readonly best = { cost: Infinity, area: 0.5, axis: 0, bin: 0, factor: 0 };
  readonly line = new Uint32Array(FEW);
  readonly bestLine = new Uint32Array(FEW);
  readonly centres = new Int32Array(FEW);

  // Of one tree.

  capacity = 0;
  /** Packed boxes in Morton order; see packed-box.ts. */
  records = new Int32Array(0);
  /** While nodes are split: where each record starts. Of leaves: the primitives themselves. */
  order = new Uint32Array(0);
  /** For what a partition or a pass of sorting needs beside `order`. */
  spare = new Uint32Array(0);
  codes = new Uint32Array(0);
  /** How many codes have each value of their low, middle and high ten bits; then where the next of them goes. */
  readonly buckets = new Uint32Array(3 * 1024);
  spareCodes = new Uint32Array(0);
  /** As in `Bvh`; a binary tree of n leaves has 2n − 1 nodes. */
  links = new Uint32Array(0);

  fit(count: number): void {
    if (count <= this.capacity) return;
    const capacity = Math.max(count, this.capacity * 2);
    this.records = new Int32Array(capacity * RECORD);
    this.order = new Uint32Array(capacity);
    this.spare = new Uint32Array(capacity);
    this.codes = new Uint32Array(capacity);
    this.spareCodes = new Uint32Array(capacity);
    this.links = new Uint32Array(capacity * 4);
    this.capacity = capacity;
  }
}
