/**
 * The film on this side of the device: double-precision sums of blocks of samples, each block summed up in float32 where it was
 * traced. They end at the same samples whatever the run (blocks.ts), so that one run, or several merged, add the same numbers; and
 * since the block that is open when a run is interrupted is kept as it is, a resumed run gives the same film bit for bit.
 *
 * The spread of the blocks' means tells the standard error of each pixel: se² = (Σ S_b²/n_b − S²/N) / ((B − 1) N), with S_b the sum
 * of block b, n_b its samples, B blocks and N samples in all (the weighted variance of batch means).
 */
import { type FilmSums, samplesIn } from 'mirrorball/headless';
import { blockEnd } from './blocks.ts';
import { countOf, joinRanges, type SampleRange } from './sample-ranges.ts';

/** Sums of a block that is not complete. */
export interface OpenBlock {
  readonly first: number;
  readonly sums: FilmSums;
}

/** The closed blocks, as a part file has them. */
export interface ClosedBlocks {
  readonly sums: Float64Array<ArrayBuffer>;
  readonly squares: Float64Array<ArrayBuffer>;
  readonly blocks: number;
  readonly ranges: readonly SampleRange[];
}

/** Keeps dark pixels from counting without limit in the error, as in the relative mean square error of two pictures. */
const DARK = 0.01;

export class AccumulatedFilm {
  readonly pixels: number;
  #closed: ClosedBlocks;
  #open: OpenBlock | null;
  /** The error of so many blocks, since it is asked for often and takes a while. */
  #error: { readonly blocks: number; readonly error: number } | null = null;

  constructor(pixels: number, closed?: ClosedBlocks, open: OpenBlock | null = null) {
    this.pixels = pixels;
    const zeros = () => new Float64Array(pixels * 3);
    this.#closed = closed ?? { sums: zeros(), squares: zeros(), blocks: 0, ranges: [] };
    this.#open = open;
  }

  get closed(): ClosedBlocks {
    return this.#closed;
  }
  get open(): OpenBlock | null {
    return this.#open;
  }
  /** All samples that it holds, those of the open block too. */
  get ranges(): readonly SampleRange[] {
    return this.#open ? joinRanges(this.#closed.ranges, [rangeOf(this.#open)]) : this.#closed.ranges;
  }
  get samples(): number {
    return countOf(this.ranges);
  }

  /** Takes a block's sums from sample `first` on; closes it when it reaches the end of its block. */
  put(first: number, sums: FilmSums): void {
    if (sums[3] === 0) return;
    this.#open = { first, sums };
    const { last } = rangeOf(this.#open);
    if (last === blockEnd(last)) this.close();
  }

  /** Adds the open block as it is. */
  close(): void {
    if (!this.#open) return;
    const { sums, squares, blocks, ranges } = this.#closed;
    const added = this.#open.sums;
    const count = samplesIn(added, this.pixels);
    for (let pixel = 0; pixel < this.pixels; pixel++)
      for (let c = 0; c < 3; c++) {
        const value = added[pixel * 4 + c]!;
        sums[pixel * 3 + c]! += value;
        squares[pixel * 3 + c]! += (value * value) / count;
      }
    this.#closed = { sums, squares, blocks: blocks + 1, ranges: joinRanges(ranges, [rangeOf(this.#open)]) };
    this.#open = null;
  }

  /** Adds another film of the same picture; throws a RangeError when a sample is in both. */
  merge(other: AccumulatedFilm): void {
    if (other.pixels !== this.pixels) throw new RangeError('The films have different sizes.');
    other.close();
    this.close();
    const ranges = joinRanges(this.#closed.ranges, other.#closed.ranges);
    for (const name of ['sums', 'squares'] as const)
      for (let i = 0; i < this.pixels * 3; i++) this.#closed[name][i]! += other.#closed[name][i]!;
    this.#closed = { ...this.#closed, blocks: this.#closed.blocks + other.#closed.blocks, ranges };
  }

  /** Linear red, green, blue of each pixel. */
  mean(): Float32Array<ArrayBuffer> {
    const { samples, pixels } = this;
    const open = this.#open?.sums;
    const { sums } = this.#closed;
    const mean = new Float32Array(pixels * 3);
    for (let pixel = 0; pixel < pixels; pixel++)
      for (let c = 0; c < 3; c++) {
        const sum = sums[pixel * 3 + c]! + (open ? open[pixel * 4 + c]! : 0);
        mean[pixel * 3 + c] = sum / Math.max(samples, 1);
      }
    return mean;
  }

  /** Standard errors of the closed blocks' means; null while there are fewer than two. */
  standardErrors(): Float32Array<ArrayBuffer> | null {
    const { sums, squares, blocks, ranges } = this.#closed;
    if (blocks < 2) return null;
    const n = countOf(ranges);
    const errors = new Float32Array(sums.length);
    for (let i = 0; i < sums.length; i++)
      errors[i] = Math.sqrt(Math.max(squares[i]! - (sums[i]! * sums[i]!) / n, 0) / ((blocks - 1) * n));
    return errors;
  }

  /**
   * The estimated error of the picture: root of the mean of se² / (mean² + 0.01) over all values, which is what the root of relMSE
   * against a perfect picture would be. Null while fewer than two blocks are closed.
   */
  error(): number | null {
    const { sums, squares, blocks, ranges } = this.#closed;
    if (this.#error?.blocks === blocks) return this.#error.error;
    if (blocks < 2) return null;
    const n = countOf(ranges);
    let total = 0;
    // Without an array of all errors: it is asked for after each block, and a fast GPU would wait for it.
    for (let i = 0; i < sums.length; i++) {
      const mean = sums[i]! / n;
      total += Math.max(squares[i]! - sums[i]! * mean, 0) / (mean * mean + DARK);
    }
    this.#error = { blocks, error: Math.sqrt(total / ((blocks - 1) * n * sums.length)) };
    return this.#error.error;
  }
}

const rangeOf = ({ first, sums }: OpenBlock): SampleRange => ({ first, last: first + sums[3]! - 1 });
