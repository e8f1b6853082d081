/** Averaging reference pictures down. A box filter of one pixel stays one: the plain mean over the larger pixel. */

/** A picture of linear RGB triples, row 0 on top, with the standard error of each value. */
export interface Reference {
  readonly width: number;
  readonly height: number;
  readonly mean: ArrayLike<number>;
  readonly error: ArrayLike<number>;
}

/**
 * The originals keep 15 bits of a mean's fraction. A value that is rounded to steps of 2 · half is off by half / √3 (root mean
 * square); half a step is at most this share of the value.
 */
const ROUNDING = 2 ** -16 / Math.sqrt(3);

/**
 * The mean of each factor × factor pixels, and its standard error: samples of different pixels are independent, so
 * variances add up; those of rounding too.
 */
export function reduce({ width, height, mean, error }: Reference, factor: number): Reference {
  if (width % factor || height % factor) throw new Error(`${width} × ${height} cannot be divided by ${factor}.`);
  const [w, h] = [width / factor, height / factor];
  const sums = new Float64Array(w * h * 3);
  const variances = new Float64Array(w * h * 3);
  for (let i = 0; i < width * height * 3; i++) {
    const [x, y] = [Math.floor(i / 3) % width, Math.floor(i / 3 / width)];
    const to = (Math.floor(y / factor) * w + Math.floor(x / factor)) * 3 + (i % 3);
    sums[to]! += mean[i]!;
    variances[to]! += error[i]! ** 2 + (ROUNDING * mean[i]!) ** 2;
  }
  const n = factor * factor;
  return { width: w, height: h, mean: sums.map((sum) => sum / n), error: variances.map((sum) => Math.sqrt(sum) / n) };
}
