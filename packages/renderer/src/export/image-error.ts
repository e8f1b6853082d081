/** What a picture file may ask of this machine, and the one kind of error that reading or writing one gives. */

/** A picture's side, in pixels. */
export const MOST_SIDE = 65536;
/** Bytes of a picture's floats, and of anything a file unfolds to. */
export const MOST_BYTES = 2 ** 31;
export const MOST_CHANNELS = 1024;
/** Deflate gives at most 258 bytes for two bits, less the block's head: no stream grows by more than this. */
export const MOST_GROWTH = 1032;

/** A picture file that cannot be read, or a picture that a format cannot hold. All texts are short, and safe to show. */
export class ImageError extends Error {
  /** The part of the file, as "EXR channel list". */
  readonly part: string;
  readonly found: string;
  readonly allowed: string;

  constructor(part: string, found: string, allowed: string) {
    super(`The ${part} has ${found}; expected ${allowed}.`);
    this.name = 'ImageError';
    this.part = part;
    this.found = found;
    this.allowed = allowed;
  }
}

/** To be called before anything of a picture's size is made. */
export function checkSize(part: string, width: number, height: number, channels: number): void {
  const isSide = (side: number): boolean => Number.isInteger(side) && side >= 1 && side <= MOST_SIDE;
  if (!isSide(width) || !isSide(height))
    throw new ImageError(part, `${width} × ${height} pixels`, `1 to ${MOST_SIDE} pixels a side`);
  if (!Number.isInteger(channels) || channels < 1 || channels > MOST_CHANNELS)
    throw new ImageError(part, `${channels} channels`, `1 to ${MOST_CHANNELS} channels`);
  const bytes = width * height * channels * 4;
  if (bytes > MOST_BYTES)
    throw new ImageError(part, `${width} × ${height} × ${channels} values`, `at most ${MOST_BYTES / 4} values`);
}

/** Refuses a part that needs more bytes than there are. */
export function checkBytes(part: string, needed: number, there: number): void {
  if (needed > there) throw new ImageError(part, `${countOf(there)} left`, `the ${countOf(needed)} that it needs`);
}

const countOf = (bytes: number): string => (bytes === 1 ? '1 byte' : `${bytes} bytes`);
