/**
 * Whole numbers for planes, never a smaller box. A grid starts at a float, and its cells are a power of two wide, so a number times
 * the cell is exact; a decoder rounds once, in the sum, with or without a fused multiply-add. Planes are floats themselves: what is
 * not above one rounds to at most that one. So boxes stay conservative although the decoder rounds to nearest.
 */
export interface Grid {
  readonly origin: number;
  /** Of a cell, −126 … 127. */
  readonly exponent: number;
}

export const cellOf = (exponent: number): number => 2 ** exponent;

/** As a kernel does, in 32-bit floats. */
export const decodePlane = ({ origin, exponent }: Grid, number: number): number =>
  Math.fround(origin + number * cellOf(exponent));

/** The last number whose plane is not above. The quotient may have been rounded up to a whole number. */
export function quantiseLeast(grid: Grid, plane: number): number {
  const number = Math.floor((plane - grid.origin) / cellOf(grid.exponent));
  return decodePlane(grid, number) > plane ? number - 1 : number;
}

/** The first number whose plane is not below. */
export function quantiseGreatest(grid: Grid, plane: number): number {
  const number = Math.ceil((plane - grid.origin) / cellOf(grid.exponent));
  return decodePlane(grid, number) < plane ? number + 1 : number;
}

/** A grid whose numbers 0 … limit reach from `least` to `greatest`, as fine as powers of two allow. */
export function gridOver(least: number, greatest: number, limit: number): Grid {
  let exponent = Math.max(-126, Math.ceil(Math.log2((greatest - least) / limit)) - 1);
  while (quantiseGreatest({ origin: least, exponent }, greatest) > limit) exponent++;
  return { origin: least, exponent };
}

/** One grid an axis over a box of six numbers. */
export const gridsOver = (box: ArrayLike<number>, limit: number): readonly Grid[] =>
  [0, 1, 2].map((axis) => gridOver(box[axis]!, box[axis + 3]!, limit));
