/**
 * Blocks of samples: what is read back from the device at once, and counts as one in the standard error. They end at the same samples
 * whatever the run, so that one run, or several merged, add the same numbers. Pure.
 */
import type { SampleRange } from './sample-ranges.ts';

/** At first few samples, so that the error of a short run is known, and soon. */
const SMALL = 32;
/** From this sample on as many as a fast GPU adds at once, since reading the film back takes it longer than a few samples do. */
const LARGE = 256;

/** The last sample of the block that holds this one. */
export function blockEnd(sample: number): number {
  const size = sample < LARGE ? SMALL : LARGE;
  return sample - (sample % size) + size - 1;
}

/** How many blocks these samples are, whole ones and parts. */
export const blocksIn = ({ first, last }: SampleRange): number => {
  let blocks = 1;
  for (let end = blockEnd(first); end < last; end = blockEnd(end + 1)) blocks++;
  return blocks;
};
