/**
 * How far a picture is from a reference, and whether that is more than their noise explains. Colour is linear RGB; the fourth
 * number of each four is luminance. Noise of neighbouring pixels has to be independent: not of denoised or filtered pictures.
 */
import { type Block, blocksOf, type FourNumbers } from './compare/blocks.ts';
import { createPlanes, type Planes } from './compare/planes.ts';
import type { FloatPicture } from './float-picture.ts';

export type { Block, FourNumbers } from './compare/blocks.ts';

/** A mean and, where it is known, the standard error of each of its values. */
export interface MeasuredPicture {
  readonly mean: FloatPicture;
  readonly standardError?: FloatPicture;
}

export interface ComparisonOptions {
  /** A block's side, in pixels. What is left over at the right and below is not in a block. */
  readonly blockSize?: number;
  /** A block is flagged beyond 3 standard errors only when it is off by more than this share, too. */
  readonly tolerance?: number;
  /** Not 0: this pixel counts. */
  readonly mask?: ArrayLike<number>;
}

export interface Comparison {
  readonly pixels: number;
  /** Pixels of the first picture with NaN or infinity; they count as black. */
  readonly nonFinitePixels: number;
  readonly negativePixels: number;
  /** mean((a − r)² / (r² + 0.01)) */
  readonly relMse: number;
  /** Without the worst thousandth of the pixels. */
  readonly trimmedRelMse: number;
  /** What the noise of the reference adds to it. */
  readonly relMseFloor: number;
  /** mean(|a − r|) */
  readonly mae: number;
  /** Of all blocks together: mean(a − r) / mean(r), and its standard error. */
  readonly bias: FourNumbers;
  readonly biasError: FourNumbers;
  readonly blocks: readonly Block[];
  /** Of luminance, over the blocks. */
  readonly rmsZ: number;
  /** Shares of the blocks' luminances with |z| above this, and the largest. */
  readonly beyond3: number;
  readonly beyond6: number;
  readonly worstZ: number;
  readonly flaggedBlocks: number;
}

/** The definitions are those of most papers, with 0.01 to keep dark pixels from ruling. */
const DARKNESS = 0.01;

export function comparePictures(
  a: MeasuredPicture,
  reference: MeasuredPicture,
  options: ComparisonOptions = {},
): Comparison {
  const planes = createPlanes(a, reference, options.mask);
  const { width, height } = reference.mean;
  const blocks = blocksOf(planes, Math.min(options.blockSize ?? 16, width, height), options.tolerance ?? 0.005);
  const z = blocks.map((block) => Math.abs(block.z[3]));
  const share = (most: number): number => z.filter((value) => value > most).length / z.length;
  return {
    ...pixelErrors(planes),
    ...biasOf(blocks),
    blocks,
    rmsZ: Math.sqrt(z.reduce((sum, value) => sum + value * value, 0) / z.length),
    beyond3: share(3),
    beyond6: share(6),
    worstZ: z.reduce((most, value) => Math.max(most, value), 0),
    flaggedBlocks: blocks.filter(({ flagged }) => flagged).length,
  };
}

function pixelErrors({ width, height, a, reference, errorOfReference, counts, nonFinite, negative }: Planes) {
  const ofPixels: number[] = [];
  let [floor, mae] = [0, 0];
  for (let i = 0; i < width * height; i++) {
    if (!counts(i)) continue;
    let ofPixel = 0;
    for (let c = 0; c < 3; c++) {
      const r = reference[c]![i]!;
      const difference = a[c]![i]! - r;
      const scale = 3 * (r * r + DARKNESS);
      ofPixel += difference ** 2 / scale;
      if (errorOfReference) floor += errorOfReference[c]![i]! ** 2 / scale;
      mae += Math.abs(difference) / 3;
    }
    ofPixels.push(ofPixel);
  }
  const pixels = ofPixels.length;
  const mean = (values: readonly number[]): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  const relMse = mean(ofPixels);
  ofPixels.sort((x, y) => x - y);
  return {
    pixels,
    nonFinitePixels: nonFinite,
    negativePixels: negative,
    relMse,
    trimmedRelMse: mean(ofPixels.slice(0, Math.max(1, Math.trunc(pixels * 0.999)))),
    relMseFloor: floor / pixels,
    mae: mae / pixels,
  };
}

function biasOf(blocks: readonly Block[]): { bias: FourNumbers; biasError: FourNumbers } {
  const sum = (value: (block: Block) => number): number => blocks.reduce((total, block) => total + value(block), 0);
  const channels = [0, 1, 2, 3] as const;
  const level = channels.map((c) => Math.max(Math.abs(sum((block) => block.reference[c] * block.pixels)), 1e-12));
  const bias = channels.map((c) => sum((block) => block.difference[c] * block.pixels) / level[c]!);
  const error = channels.map((c) => Math.sqrt(sum((block) => (block.error[c] * block.pixels) ** 2)) / level[c]!);
  return { bias: bias as unknown as FourNumbers, biasError: error as unknown as FourNumbers };
}
