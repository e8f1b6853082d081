/**
 * How carefully splits are weighed. Half as many samples, and axes tried only when centres spread along them nearly as far as along the
 * widest, take a fifth less time, for a tree that costs a hundredth more. Trees of loose triangles, which have twice as many items because
 * none are pairs (items.ts), are built so.
 */
export interface Care {
  /** From twice as many items on, only about so many of a node are weighed. */
  readonly sample: number;
  /** An axis along which centres spread less than this share of the widest spread is not tried. */
  readonly narrow: number;
  /** Up to so many items there are 8 bins. */
  readonly coarse: number;
  /** So many items or fewer are split exactly. At most `MOST_FEW`. */
  readonly few: number;
}

export const MOST_FEW = 12;

export const CAREFUL: Care = { sample: 256, narrow: 0.4, coarse: 32, few: MOST_FEW };
export const QUICK: Care = { sample: 128, narrow: 0.7, coarse: 64, few: 8 };
