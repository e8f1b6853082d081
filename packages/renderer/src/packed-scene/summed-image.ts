/**
 * How bright an image is on average over any rectangle of its coordinates: sums over all rectangles from the first texel on (Crow, "Summed-Area
 * Tables for Texture Mapping", 1984), of a copy with at most 512 texels a side. Beyond the image it goes on as its wraps say.
 */
import type { ImagePixels, Wrap } from '../scene/textures.ts';

const MOST_CELLS = 512;

/** IEC 61966-2-1, of a byte. */
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

/** A prefix sum beyond the image is made of those within: factors and the places that they belong to. */
type Terms = readonly (readonly [factor: number, place: number])[];

export class SummedImage {
  readonly columns: number;
  readonly rows: number;
  /** Up to column x and row y, of x + y (columns + 1). */
  readonly #sums: Float64Array;

  /** Its colours are sRGB. */
  constructor({ width, height, rgba }: ImagePixels) {
    this.columns = Math.min(width, MOST_CELLS);
    this.rows = Math.min(height, MOST_CELLS);
    const { columns, rows } = this;
    const stride = columns + 1;
    const sums = new Float64Array(stride * (rows + 1));
    for (let y = 0, at = 0; y < height; y++) {
      const row = stride * (Math.floor((y * rows) / height) + 1) + 1;
      for (let x = 0; x < width; x++, at += 4)
        sums[row + Math.floor((x * columns) / width)]! +=
          LINEAR[rgba[at]!]! + LINEAR[rgba[at + 1]!]! + LINEAR[rgba[at + 2]!]!;
    }
    const texels = (width / columns) * (height / rows);
    for (let y = 1; y <= rows; y++)
      for (let x = 1, inRow = 0; x <= columns; x++) {
        inRow += sums[stride * y + x]! / (3 * texels);
        sums[stride * y + x] = inRow + sums[stride * (y - 1) + x]!;
      }
    this.#sums = sums;
  }

  /**
   * Mean of red, green and blue, linear, 0 … 1, over coordinates of the image from (u0, v0) to (u1, v1), and half a texel of the copy
   * around, as far as a neighbour shows through.
   */
  mean(u0: number, v0: number, u1: number, v1: number, wrapU: Wrap = 'repeat', wrapV: Wrap = 'repeat'): number {
    const { columns, rows } = this;
    const [left, right] = [u0 * columns - 0.5, u1 * columns + 0.5];
    const [top, bottom] = [v0 * rows - 0.5, v1 * rows + 0.5];
    if (left >= 0 && top >= 0 && right <= columns && bottom <= rows) {
      const sum = this.#within(right, bottom) - this.#within(left, bottom) - this.#within(right, top) + this.#within(left, top); // biome-ignore format: four corners
      return shareOf(sum / ((right - left) * (bottom - top)));
    }
    const [fromX, toX] = [termsOf(left, columns, wrapU), termsOf(right, columns, wrapU)];
    const [fromY, toY] = [termsOf(top, rows, wrapV), termsOf(bottom, rows, wrapV)];
    const sum = this.#at(toX, toY) - this.#at(fromX, toY) - this.#at(toX, fromY) + this.#at(fromX, fromY);
    return shareOf(sum / ((right - left) * (bottom - top)));
  }

  #at(x: Terms, y: Terms): number {
    let sum = 0;
    for (const [a, placeX] of x) for (const [b, placeY] of y) sum += a * b * this.#within(placeX, placeY);
    return sum;
  }

  /** Of texels of even brightness. */
  #within(x: number, y: number): number {
    const i = Math.min(Math.floor(x), this.columns - 1);
    const j = Math.min(Math.floor(y), this.rows - 1);
    const s = x - i;
    const t = y - j;
    const stride = this.columns + 1;
    const at = j * stride + i;
    const sums = this.#sums;
    const above = sums[at]! + s * (sums[at + 1]! - sums[at]!);
    const below = sums[at + stride]! + s * (sums[at + stride + 1]! - sums[at + stride]!);
    return above + t * (below - above);
  }
}

/** Without what rounding leaves of equal sums. */
const shareOf = (mean: number): number => (mean > 1e-9 ? Math.min(mean, 1) : 0);

function termsOf(x: number, size: number, wrap: Wrap): Terms {
  if (wrap === 'clamp') {
    if (x < 0) return [[x, 1]];
    if (x <= size) return [[1, x]];
    return [[1 + x - size, size], [size - x, size - 1]]; // biome-ignore format: two terms
  }
  if (wrap === 'repeat') {
    const whole = Math.floor(x / size);
    return [[whole, size], [1, x - whole * size]]; // biome-ignore format: two terms
  }
  const whole = Math.floor(x / (2 * size));
  const rest = x - whole * 2 * size;
  return rest <= size ? [[2 * whole, size], [1, rest]] : [[2 * whole + 2, size], [-1, 2 * size - rest]]; // biome-ignore format: two terms
}
