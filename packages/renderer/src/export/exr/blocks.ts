/** Packing blocks of scan lines. RLE and ZIP first turn bytes into differences and sort low from high ones. */
import { zlibSync } from 'fflate';
import { ImageError } from '../image-error.ts';
import { inflateZlib } from '../inflate.ts';
import type { ExrHeader } from './header.ts';
import { unpackPiz } from './piz.ts';

/** Gives exactly `size` bytes: the lines one after another, of each the channels one after another. */
export function unpackBlock(header: ExrHeader, packed: Uint8Array, lines: number, size: number): Uint8Array {
  const { name } = header.compression;
  if (packed.length === size) return packed; // what would not shrink is stored as it is
  if (name === 'RLE') return restore(unpackRuns(packed, size));
  if (name === 'ZIP' || name === 'ZIPS') return restore(inflateZlib(packed, size, 'EXR block'));
  if (name === 'PIZ') return unpackPiz(header, packed, lines, size);
  throw new ImageError('EXR block', `${packed.length} bytes`, `${size} bytes, since they are not packed`);
}

export function packZip(raw: Uint8Array): Uint8Array {
  const packed = zlibSync(prepare(raw), { level: 6 });
  return packed.length < raw.length ? packed : raw;
}

/** Bytes 0, 2, 4 … before 1, 3, 5 …; then each as its difference from the one before, + 128. */
function prepare(raw: Uint8Array): Uint8Array {
  const half = (raw.length + 1) >>> 1;
  const sorted = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) sorted[(i >>> 1) + (i & 1 ? half : 0)] = raw[i]!;
  for (let i = raw.length - 1; i > 0; i--) sorted[i]! += 128 - sorted[i - 1]!;
  return sorted;
}

function restore(sorted: Uint8Array): Uint8Array {
  const half = (sorted.length + 1) >>> 1;
  for (let i = 1; i < sorted.length; i++) sorted[i]! += sorted[i - 1]! - 128;
  const raw = new Uint8Array(sorted.length);
  for (let i = 0; i < raw.length; i++) raw[i] = sorted[(i >>> 1) + (i & 1 ? half : 0)]!;
  return raw;
}

/** A negative count: so many bytes as they are. Another: the next byte, once more often than the count. */
function unpackRuns(packed: Uint8Array, size: number): Uint8Array {
  const damaged = (found: string): ImageError => new ImageError('EXR block', found, `runs that make ${size} bytes`);
  // At most 128 bytes come of 2.
  if (size > packed.length * 64) throw damaged(`${packed.length} bytes`);
  const raw = new Uint8Array(size);
  let at = 0;
  for (let i = 0; i < packed.length; ) {
    const count = (packed[i++]! << 24) >> 24;
    const length = count < 0 ? -count : count + 1;
    const last = i + (count < 0 ? length : 1);
    if (last > packed.length) throw damaged('a run that is cut off');
    if (at + length > size) throw damaged('runs that make more');
    if (count < 0) raw.set(packed.subarray(i, last), at);
    else raw.fill(packed[i]!, at, at + length);
    at += length;
    i = last;
  }
  if (at !== size) throw damaged(`runs that make ${at} bytes`);
  return raw;
}
