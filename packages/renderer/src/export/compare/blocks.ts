/** Means over blocks of pixels, and how many standard errors they are apart. */
import { residualVariance } from './plane-fit.ts';
import type { Planes } from './planes.ts';

/** Red, green, blue, luminance. */
export type FourNumbers = readonly [number, number, number, number];

export interface Block {
  /** Its upper left pixel. */
  readonly x: number;
  readonly y: number;
  readonly pixels: number;
  /** mean(r) */
  readonly reference: FourNumbers;
  /** mean(a − r), its share of mean(r), its standard error, and how many of those it is. */
  readonly difference: FourNumbers;
  readonly relative: FourNumbers;
  readonly error: FourNumbers;
  readonly z: FourNumbers;
  readonly flagged: boolean;
}

const CHANNELS = [0, 1, 2, 3] as const;
/** Beyond so many standard errors a block is suspicious. */
const SUSPICIOUS = 3;
/** Errors below this share of a block's value are not believed: float32 and half have no more digits. */
const LEAST_ERROR = 1e-4;

/** All blocks of which at least half of the pixels count, row by row. */
export function blocksOf(planes: Planes, side: number, tolerance: number): Block[] {
  const floor = 1e-3 * Math.max(meanLuminance(planes), 1e-9);
  const blocks: Block[] = [];
  for (let y = 0; y + side <= planes.height; y += side)
    for (let x = 0; x + side <= planes.width; x += side) {
      const inside = pixelsOf(planes, x, y, side);
      if (inside.length >= side * side * 0.5) blocks.push(blockOf(planes, x, y, inside, { tolerance, floor }));
    }
  return blocks;
}

function meanLuminance({ reference, counts }: Planes): number {
  let [sum, count] = [0, 0];
  reference[3]!.forEach((value, i) => {
    if (counts(i)) [sum, count] = [sum + value, count + 1];
  });
  return sum / count;
}

function pixelsOf({ width, counts }: Planes, left: number, top: number, side: number): number[] {
  const pixels: number[] = [];
  for (let y = top; y < top + side; y++)
    for (let x = left; x < left + side; x++) if (counts(y * width + x)) pixels.push(y * width + x);
  return pixels;
}

interface Scale {
  readonly tolerance: number;
  /** Relative differences of darker blocks are taken of this. */
  readonly floor: number;
}

function blockOf(planes: Planes, x: number, y: number, pixels: readonly number[], scale: Scale): Block {
  const four = (value: (c: number) => number): FourNumbers => CHANNELS.map(value) as unknown as FourNumbers;
  const mean = (value: (pixel: number) => number): number =>
    pixels.reduce((sum, pixel) => sum + value(pixel), 0) / pixels.length;
  const reference = four((c) => mean((i) => planes.reference[c]![i]!));
  const difference = four((c) => mean((i) => planes.a[c]![i]! - planes.reference[c]![i]!));
  const error = four((c) => errorOf(planes, c, pixels));
  const level = four((c) => Math.max(reference[c]!, scale.floor));
  const relative = four((c) => difference[c]! / level[c]!);
  const z = four((c) => difference[c]! / Math.max(error[c]!, LEAST_ERROR * level[c]!));
  const flagged = CHANNELS.some((c) => Math.abs(z[c]) > SUSPICIOUS && Math.abs(relative[c]) > scale.tolerance);
  return { x, y, pixels: pixels.length, reference, difference, relative, error, z, flagged };
}

/**
 * The standard error of the mean of a − r. Known for both pictures: √(Σ se² + Σ se²) / n. Else it is measured: the scatter of
 * the differences inside the block, less a plane, since bias that varies smoothly is no noise; not below the reference's share.
 */
function errorOf(planes: Planes, c: number, pixels: readonly number[]): number {
  const { a, reference, errorOfA, errorOfReference, width } = planes;
  const known = (colours: readonly Float64Array[] | null): number =>
    colours ? Math.sqrt(pixels.reduce((sum, i) => sum + colours[c]![i]! ** 2, 0)) / pixels.length : 0;
  if (errorOfA) return Math.hypot(known(errorOfA), known(errorOfReference));
  const columns = pixels.map((i) => i % width);
  const rows = pixels.map((i) => Math.floor(i / width));
  const differences = pixels.map((i) => a[c]![i]! - reference[c]![i]!);
  return Math.max(Math.sqrt(residualVariance(columns, rows, differences) / pixels.length), known(errorOfReference));
}
