/**
 * Whether a picture is the same as a reference, up to the noise of both: by statistics, not by a threshold on pixels.
 *
 * For each block and channel z = (ours − reference) / √(error² + error²). If the two renderers agree, z is normal with variance 1,
 * whatever the scene; a wrong formula shows as z that are too large, and more so with more samples.
 */
import {
  type BlockMeans,
  blocksOfBatches,
  blocksOfReference,
  type Cut,
  type Film,
  type Reference,
  WHOLE,
} from './blocks.ts';

export const LIMITS = {
  /** Root mean square of z. */
  rms: 1.2,
  /** Share of z beyond 3; by chance 0.27 %. */
  shareBeyond3: 0.015,
  /** No z beyond this. */
  largest: 6,
  /** |z| of the mean of the whole picture, in each channel. */
  picture: 3,
  /** Combined error of a block as a share of its value, root mean square: with more noise the test would find nothing. */
  blockError: 0.02,
} as const;
export type Limits = Readonly<Record<keyof typeof LIMITS, number>>;

export interface ZTest extends Cut {
  /** Block by block and channel by channel; positive where ours is brighter. */
  readonly z: Float64Array;
  readonly rms: number;
  readonly shareBeyond3: number;
  readonly largest: number;
  /** Root mean square of the combined error as a share of the block's value, and the largest. */
  readonly blockError: number;
  readonly largestBlockError: number;
  /** Red, green, blue of the whole picture: (ours − reference) / reference, its combined error, and z. */
  readonly picture: readonly { readonly difference: number; readonly error: number; readonly z: number }[];
  /** What is beyond the limits, in words. Empty: ours is the same picture. */
  readonly failures: readonly string[];
}

/**
 * Judges films of one scene, rendered with independent seeds and equally many samples: at least 2, better 32, as an error estimated
 * from few batches is uncertain itself, and z says less: with 32, eight errors apart are a z of 6, with 16 twelve.
 */
export function judge(films: readonly Film[], reference: Reference, cut: Cut, limits: Limits = LIMITS): ZTest {
  const blocks = compare(blocksOfBatches(films, cut), blocksOfReference(reference, cut));
  const picture = compare(blocksOfBatches(films, WHOLE), blocksOfReference(reference, WHOLE));
  return verdict(blocks, picture, limits, impossible(films));
}

/** Values that no samples of radiance give. */
function impossible(films: readonly Film[]): string[] {
  let wrong = 0;
  for (const { sum, sumOfSquares } of films)
    for (const list of [sum, sumOfSquares])
      for (let i = 0; i < list.length; i++) if (!(list[i]! >= 0 && list[i]! < Number.POSITIVE_INFINITY)) wrong++;
  return wrong > 0 ? [`${wrong} sums are negative or not finite`] : [];
}

export interface Comparison extends Cut {
  readonly z: Float64Array;
  readonly difference: Float64Array;
  readonly error: Float64Array;
  /** What differences and errors are shares of. */
  readonly scale: Float64Array;
}

/**
 * Differences below this share of a value are the arithmetic of 32-bit floats and of a GPU's sines and roots, not light.
 * Without it pictures that have no noise, such as a white furnace, could not be compared.
 */
const ARITHMETIC = 1e-4;
/** Blocks darker than this share of the picture count as that bright: of nothing there is no share. */
const DARK = { error: 1e-3, share: 0.1 } as const;

export function compare(ours: BlockMeans, reference: BlockMeans): Comparison {
  const { columns, rows } = reference;
  const middle = [0, 1, 2].map((c) => {
    const values = reference.mean.filter((_, k) => k % 3 === c);
    return values.reduce((sum, x) => sum + x, 0) / values.length;
  });
  const bright = (k: number, share: number) => Math.max(reference.mean[k]!, share * middle[k % 3]!);
  const difference = ours.mean.map((mean, k) => mean - reference.mean[k]!);
  const error = difference.map((_, k) => {
    const noise = Math.sqrt(ours.variance[k]! + reference.variance[k]!);
    return Math.max(noise, ARITHMETIC * bright(k, DARK.error));
  });
  const z = difference.map((d, k) => (d === 0 ? 0 : normalOf(d / error[k]!, freedomOf(ours, reference, k))));
  return { columns, rows, z, difference, error, scale: difference.map((_, k) => bright(k, DARK.share)) };
}

/** Of the combined error: Welch 1947, Satterthwaite 1946. */
function freedomOf(a: BlockMeans, b: BlockMeans, k: number): number {
  const [va, vb] = [a.variance[k]!, b.variance[k]!];
  const uncertainty = va ** 2 / a.freedom + vb ** 2 / b.freedom;
  return uncertainty > 0 ? (va + vb) ** 2 / uncertainty : Number.POSITIVE_INFINITY;
}

/**
 * A difference over an error that was itself estimated, with few degrees of freedom, follows Student's t, whose tails are fatter: with 15,
 * 0.9 % lie beyond 3. This gives the z of a normal distribution that is as unlikely (Wallace 1959, "Bounds on normal approximations to
 * Student's and the chi-square distributions", within 0.02 from 4 degrees on).
 */
export function normalOf(t: number, freedom: number): number {
  if (!Number.isFinite(freedom) || !Number.isFinite(t)) return t;
  return Math.sign(t) * ((8 * freedom + 1) / (8 * freedom + 3)) * Math.sqrt(freedom * Math.log1p((t * t) / freedom));
}

const rootMeanSquare = (values: Float64Array): number =>
  Math.sqrt(values.reduce((sum, x) => sum + x * x, 0) / values.length);
const largestOf = (values: Float64Array): number => values.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

function verdict(blocks: Comparison, whole: Comparison, limits: Limits, found: readonly string[]): ZTest {
  const { columns, rows, z } = blocks;
  const shares = blocks.error.map((e, k) => (blocks.scale[k]! > 0 ? e / blocks.scale[k]! : 0));
  const picture = [0, 1, 2].map((c) => {
    const share = (x: number) => (whole.scale[c]! > 0 ? x / whole.scale[c]! : x);
    return { difference: share(whole.difference[c]!), error: share(whole.error[c]!), z: whole.z[c]! };
  });
  const figures = {
    rms: rootMeanSquare(z),
    shareBeyond3: z.filter((x) => !(Math.abs(x) <= 3)).length / z.length,
    largest: largestOf(z),
    picture: largestOf(whole.z),
    blockError: rootMeanSquare(shares),
  };
  const names = Object.keys(LIMITS) as (keyof Limits)[];
  const failures = names
    // Not ">": a NaN fails too.
    .filter((name) => !(figures[name] <= limits[name]))
    .map((name) => `${WORDS[name]}: ${figures[name].toPrecision(3)}, at most ${limits[name]}`);
  return {
    columns,
    rows,
    z,
    ...figures,
    largestBlockError: largestOf(shares),
    picture,
    failures: [...found, ...failures],
  };
}

const WORDS: Readonly<Record<keyof Limits, string>> = {
  rms: 'root mean square of z',
  shareBeyond3: 'share of z beyond 3',
  largest: 'largest |z|',
  picture: 'largest |z| of the whole picture',
  blockError: 'combined error of a block',
};
