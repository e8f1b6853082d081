/**
 * Boxes in three 32-bit words, one an axis, for weighing splits. Coordinates are 15-bit numbers on a grid that spans the node at
 * hand. The low lane of a word has the least coordinate a, the high lane has LIMIT − b for the greatest coordinate b, so that
 * the union of two boxes is six minima, two in each word.
 *
 * Why not floats: small nodes change their bins' bounds all the time, so each of 18 comparisons a primitive is a branch that
 * is predicted badly. Minima of lanes have no branch; binning with them took a quarter of the time.
 *
 * Loops over primitives write these constants out, or fetch them before with `| 0`: bundlers make `var` of a module's
 * `const`, and V8 then no longer knows that it is a number.
 */
export const LIMIT = 32767;

/** Every word of the box of nothing. */
export const NOTHING = 0x7fff7fff;

/** Words a record: the box, and the code of the item. */
export const RECORD = 4;

/**
 * The lesser of each lane. The guard bit above a lane survives the subtraction where a's lane is not less; it becomes a mask of
 * its lane.
 */
export function minLanes(a: number, b: number): number {
  const notLess = ((a | 0x80008000) - b) & 0x80008000;
  const mask = (notLess - (notLess >>> 15)) | 0;
  return a ^ ((a ^ b) & mask);
}

/** Half the surface in cells of the grid. A box spans at least one cell each way, so that flat ones are told apart too. */
export function packedArea(w0: number, w1: number, w2: number): number {
  const dx = 0x8000 - (w0 >>> 16) - (w0 & 0x7fff);
  const dy = 0x8000 - (w1 >>> 16) - (w1 & 0x7fff);
  const dz = 0x8000 - (w2 >>> 16) - (w2 & 0x7fff);
  return dx * (dy + dz) + dy * dz;
}

/** Sum of least and greatest coordinate, that is twice the centre, minus LIMIT. */
export const centreOf = (word: number): number => (word & 0x7fff) - (word >>> 16);

/** Writes the packed box of an item into its record. The grid starts at ox, oy, oz and has `scale` cells a unit. */
export function packBox(
  boxes: Float32Array,
  item: number,
  records: Int32Array,
  at: number,
  ox: number,
  oy: number,
  oz: number,
  scale: number,
): void {
  const i = (item >>> 2) * 6;
  const x0 = ((boxes[i]! - ox) * scale) | 0;
  const y0 = ((boxes[i + 1]! - oy) * scale) | 0;
  const z0 = ((boxes[i + 2]! - oz) * scale) | 0;
  const x1 = 0x7fff - (((boxes[i + 3]! - ox) * scale) | 0);
  const y1 = 0x7fff - (((boxes[i + 4]! - oy) * scale) | 0);
  const z1 = 0x7fff - (((boxes[i + 5]! - oz) * scale) | 0);
  records[at] = x0 | (x1 << 16);
  records[at + 1] = y0 | (y1 << 16);
  records[at + 2] = z0 | (z1 << 16);
}

/** Cells a unit of a grid over this box; 0 for a point. Same along all axes: areas compare. */
export function gridScale(box: Float64Array): number {
  const extent = Math.max(box[3]! - box[0]!, box[4]! - box[1]!, box[5]! - box[2]!);
  return extent > 0 ? LIMIT / extent : 0;
}
