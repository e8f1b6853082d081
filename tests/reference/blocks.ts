/**
 * Means over blocks of pixels, and how exactly they are known. Pictures are rows from the top of linear RGB triples; a value
 * stands at (row · columns + column) · 3 + channel, for pixels and blocks alike.
 */

/** A picture with the standard error of each value. */
export interface Reference {
  readonly width: number;
  readonly height: number;
  readonly mean: ArrayLike<number>;
  readonly error: ArrayLike<number>;
}

/** What an integrator has gathered: over the samples of each pixel the sums of radiance and of its square. */
export interface Film {
  readonly width: number;
  readonly height: number;
  readonly sum: ArrayLike<number>;
  readonly sumOfSquares: ArrayLike<number>;
  /** Samples, one number a pixel. */
  readonly count: ArrayLike<number>;
}

export interface BlockMeans {
  readonly columns: number;
  readonly rows: number;
  readonly mean: Float64Array;
  /** Of the mean: its standard error squared. */
  readonly variance: Float64Array;
  /** Degrees of freedom with which `variance` was estimated; Infinity: as good as known. */
  readonly freedom: number;
}

/** Into how many blocks a picture is cut. 1 × 1 is the whole picture. */
export interface Cut {
  readonly columns: number;
  readonly rows: number;
}
export const WHOLE: Cut = { columns: 1, rows: 1 };

/** Adds up what `value` gives for each pixel and channel, block by block. */
function sumBlocks(size: { width: number; height: number }, cut: Cut, value: (i: number) => number): Float64Array {
  const { width, height } = size;
  const { columns, rows } = cut;
  if (width % columns || height % rows)
    throw new Error(`A picture of ${width} × ${height} cannot be cut into ${columns} × ${rows} equal blocks.`);
  const sums = new Float64Array(columns * rows * 3);
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const block = Math.floor((y * rows) / height) * columns + Math.floor((x * columns) / width);
      for (let c = 0; c < 3; c++, i++) sums[block * 3 + c]! += value(i);
    }
  return sums;
}
const pixelsOf = ({ width, height }: { width: number; height: number }, { columns, rows }: Cut): number =>
  (width * height) / (columns * rows);

/** Pixels of a reference are independent: variances add up. */
export function blocksOfReference(reference: Reference, cut: Cut): BlockMeans {
  const n = pixelsOf(reference, cut);
  const mean = sumBlocks(reference, cut, (i) => reference.mean[i]!).map((sum) => sum / n);
  const variance = sumBlocks(reference, cut, (i) => reference.error[i]! ** 2).map((sum) => sum / n ** 2);
  return { ...cut, mean, variance, freedom: Number.POSITIVE_INFINITY };
}

/**
 * From one film, by its sums of squares: right if samples are independent of each other, within a pixel and between pixels.
 * Stratified and low-discrepancy samples are better spread than that, so that this overstates their error, and a blue-noise
 * arrangement makes neighbours depend on each other; use batches there.
 */
export function blocksOfFilm(film: Film, cut: Cut): BlockMeans {
  const n = pixelsOf(film, cut);
  const counts = Array.from(film.count);
  const least = counts.reduce((a, b) => Math.min(a, b));
  if (least < 2) throw new Error('One sample says nothing about its own error: at least 2 a pixel are needed.');
  const count = (i: number) => counts[Math.floor(i / 3)]!;
  const mean = sumBlocks(film, cut, (i) => film.sum[i]! / count(i)).map((sum) => sum / n);
  // Σ(x − x̄)² = Σx² − (Σx)² / n; rounding may take it below zero where all samples are alike.
  const variance = sumBlocks(film, cut, (i) => {
    const squares = film.sumOfSquares[i]! - film.sum[i]! ** 2 / count(i);
    return Math.max(squares, 0) / (count(i) - 1) / count(i);
  }).map((sum) => sum / n ** 2);
  return { ...cut, mean, variance, freedom: (least - 1) * n };
}

/**
 * From films of the same scene with independent seeds and equally many samples: the scatter of their block means. It assumes
 * nothing of how samples depend on each other within a film.
 */
export function blocksOfBatches(films: readonly Film[], cut: Cut): BlockMeans {
  if (films.length < 2) throw new Error('At least two films with different seeds are needed.');
  if (films.some((film) => film.count[0] !== films[0]!.count[0])) throw new Error('Films with unlike sample counts.');
  const n = pixelsOf(films[0]!, cut);
  const means = films.map((film) => {
    const sums = sumBlocks(film, cut, (i) => film.sum[i]! / film.count[Math.floor(i / 3)]!);
    return sums.map((sum) => sum / n);
  });
  const mean = means[0]!.map((_, k) => means.reduce((sum, m) => sum + m[k]!, 0) / means.length);
  const variance = mean.map((middle, k) => {
    const squares = means.reduce((sum, m) => sum + (m[k]! - middle) ** 2, 0);
    return squares / (means.length - 1) / means.length;
  });
  return steadied({ ...cut, mean, variance, freedom: films.length - 1 });
}

/** How much the neighbourhood's variance counts beside a block's own. */
const NEIGHBOURS = 1;

/**
 * Where light comes in rare bright samples (caustics), a block that met none of them has a mean that is too small and an error
 * that is far too small, and would seem certain of its mistake. So a variance below that of its neighbourhood is pulled towards it:
 * the largest of the 3 × 3 blocks around but for three, as a lamp's edge through these says nothing about the others. A variance above
 * stays: a block may be as noisy as it shows itself, and no error is ever made smaller here.
 */
function steadied(blocks: BlockMeans): BlockMeans {
  const { columns, rows, variance } = blocks;
  const pulled = variance.map((own, k) => {
    const [x, y] = [Math.floor(k / 3) % columns, Math.floor(k / 3 / columns)];
    const around: number[] = [];
    for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, rows - 1); j++)
      for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, columns - 1); i++)
        around.push(variance[(j * columns + i) * 3 + (k % 3)]!);
    return Math.max(own, (own + NEIGHBOURS * typical(around)) / (1 + NEIGHBOURS));
  });
  return { ...blocks, variance: pulled };
}

/** The largest but for three. */
const typical = (values: readonly number[]): number =>
  values.toSorted((a, b) => b - a)[Math.min(3, values.length - 1)]!;

/** One film with the samples of all. */
export function mergeFilms(films: readonly Film[]): Film {
  const [first] = films;
  const total = (part: (film: Film) => ArrayLike<number>) =>
    Float64Array.from(part(first!), (_, i) => films.reduce((sum, film) => sum + part(film)[i]!, 0));
  return {
    width: first!.width,
    height: first!.height,
    sum: total((film) => film.sum),
    sumOfSquares: total((film) => film.sumOfSquares),
    count: total((film) => film.count),
  };
}

/** Means of the pixels. */
export const meansOf = ({ sum, count }: Film): Float64Array =>
  Float64Array.from(sum, (x, i) => x / count[Math.floor(i / 3)]!);
