/** How a workgroup of the compute entry is shared out: pixels times threads for the samples of each. */
const THREADS = 128;
/** Side by side on a GPU, so that they go the same way; also the samples of a group, of which each thread then has one. */
const MOST_SHARES = 32;

/** For so many samples of every pixel. `tile`: pixels of a workgroup. */
export function workgroupOf(samples: number): { shares: number; tile: readonly [width: number, height: number] } {
  const shares = Math.min(2 ** Math.floor(Math.log2(samples)), MOST_SHARES);
  const width = 2 ** Math.ceil(Math.log2(THREADS / shares) / 2);
  return { shares, tile: [width, THREADS / shares / width] };
}
