/** Deflate of untrusted bytes into exactly the room that the file's own header asks for. */
import { inflateSync } from 'fflate';
import { checkBytes, ImageError, MOST_GROWTH } from './image-error.ts';

/** Unpacks a raw deflate stream (RFC 1951) that must give `size` bytes. */
export function inflate(packed: Uint8Array, size: number, part: string): Uint8Array {
  const allowed = `a whole deflate stream of ${size} bytes`;
  if (packed.length === 0) throw new ImageError(part, 'no bytes', allowed);
  if (size > packed.length * MOST_GROWTH)
    throw new ImageError(part, `${packed.length} packed bytes`, `at least ${Math.ceil(size / MOST_GROWTH)} of them`);
  let unpacked: Uint8Array;
  try {
    // With `out` fflate makes nothing larger; what does not fit is dropped. The byte too many shows that.
    unpacked = inflateSync(packed, { out: new Uint8Array(size + 1) });
  } catch {
    throw new ImageError(part, 'a damaged deflate stream', allowed);
  }
  if (unpacked.length !== size)
    throw new ImageError(part, `${unpacked.length > size ? 'more' : unpacked.length} bytes`, allowed);
  return unpacked;
}

/** The same of a zlib stream (RFC 1950): two bytes before, Adler's sum after. */
export function inflateZlib(packed: Uint8Array, size: number, part: string): Uint8Array {
  checkBytes(part, 7, packed.length);
  const [method, flags] = [packed[0]!, packed[1]!];
  if ((method & 15) !== 8 || method >>> 4 > 7 || (method * 256 + flags) % 31 !== 0 || flags & 32)
    throw new ImageError(part, `the bytes ${method} ${flags} at its start`, 'the head of a zlib stream');
  const unpacked = inflate(packed.subarray(2, -4), size, part);
  const view = new DataView(packed.buffer, packed.byteOffset + packed.length - 4, 4);
  if (view.getUint32(0) !== adler32(unpacked))
    throw new ImageError(part, 'bytes that do not fit their check sum', 'unchanged bytes');
  return unpacked;
}

function adler32(bytes: Uint8Array): number {
  let a = 1;
  let b = 0;
  for (let i = 0; i < bytes.length; ) {
    const stop = Math.min(i + 2000, bytes.length); // so many sums stay below 2^31
    for (; i < stop; i++) b += a += bytes[i]!;
    a %= 65521;
    b %= 65521;
  }
  return b * 65536 + a;
}
