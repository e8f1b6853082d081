/**
 * Whole numbers for planes, never a smaller box. A grid starts at a float, and its cells are a power of two wide, so a number times
 * the cell is exact; a decoder rounds once, in the sum, with or without a fused multiply-add. Planes are floats themselves: what is
 * not above one rounds to at most that one. So boxes stay conservative although the decoder rounds to nearest.
 */
export interface Grid {
  readonly origin: number;
  /** Of a cell, −126 … 127. */
  readonly exponent: number;
  /** 2^exponent. */
  readonly cell: number;
}

const LOWEST = -126;
/** 2^LOWEST, 2^(LOWEST + 1) … */
const CELLS = Array.from({ length: 260 }, (_, k) => 2 ** (LOWEST + k));

export const gridAt = (origin: number, exponent: number): Grid => ({
  origin,
  exponent,
  cell: CELLS[exponent - LOWEST]!,
});

/** As a kernel does, in 32-bit floats. */
export const decodePlane = ({ origin, cell }: Grid, number: number): number => Math.fround(origin + number * cell);

/** The last number whose plane is not above. The quotient may have been rounded up to a whole number. */
export function quantiseLeast(grid: Grid, plane: number): number {
  const number = Math.floor((plane - grid.origin) / grid.cell);
  return decodePlane(grid, number) > plane ? number - 1 : number;
}

/** The first number whose plane is not below. */
export function quantiseGreatest(grid: Grid, plane: number): number {
  const number = Math.ceil((plane - grid.origin) / grid.cell);
  return decodePlane(grid, number) < plane ? number + 1 : number;
}

/** A grid whose numbers 0 … limit reach from `least` to `greatest`, as fine as powers of two allow. */
export function gridOver(least: number, greatest: number, limit: number): Grid {
  let exponent = Math.max(LOWEST, Math.ceil(Math.log2((greatest - least) / limit)) - 1);
  let grid = gridAt(least, exponent);
  while (quantiseGreatest(grid, greatest) > limit) grid = gridAt(least, ++exponent);
  return grid;
}

/** One grid an axis over a box: six numbers, from `at` on. */
export const gridsOver = (bounds: ArrayLike<number>, at: number, limit: number): readonly [Grid, Grid, Grid] => [
  gridOver(bounds[at]!, bounds[at + 3]!, limit),
  gridOver(bounds[at + 1]!, bounds[at + 4]!, limit),
  gridOver(bounds[at + 2]!, bounds[at + 5]!, limit),
];

/** Six noughts: a box where there is none. */
export const NO_BOX = new Float32Array(6);
