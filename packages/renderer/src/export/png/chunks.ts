/** A PNG file is a row of chunks: length, type, data, check sum; all big endian. */
import { crc32 } from '../crc32.ts';
import { checkBytes, ImageError } from '../image-error.ts';

export interface Chunk {
  /** Four letters. */
  readonly type: string;
  readonly data: Uint8Array;
}

export const SIGNATURE = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);

/** All chunks up to IEND, their check sums proved. The first, and no other, is the head. */
export function readChunks(bytes: Uint8Array): Chunk[] {
  if (SIGNATURE.some((byte, index) => bytes[index] !== byte))
    throw new ImageError('PNG start of the file', 'other bytes', 'the eight bytes 137 80 78 71 13 10 26 10');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const chunks: Chunk[] = [];
  for (let at = SIGNATURE.length; ; ) {
    checkBytes('PNG row of chunks', 12, bytes.length - at);
    const length = view.getUint32(at);
    checkBytes('PNG chunk', 12 + length, bytes.length - at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    if (!/^[A-Za-z]{4}$/.test(type)) throw new ImageError('PNG type of a chunk', 'other bytes', 'four letters');
    if (crc32(bytes.subarray(at + 4, at + 8 + length)) !== view.getUint32(at + 8 + length))
      throw new ImageError(`PNG chunk ${type}`, 'bytes that do not fit their check sum', 'unchanged bytes');
    if ((type === 'IHDR') !== (chunks.length === 0))
      throw new ImageError('PNG row of chunks', `${type} as number ${chunks.length + 1}`, 'IHDR first and only there');
    chunks.push({ type, data: bytes.subarray(at + 8, at + 8 + length) });
    if (type === 'IEND') return chunks;
    at += 12 + length;
  }
}

export function joinChunks(chunks: readonly Chunk[]): Uint8Array<ArrayBuffer> {
  const size = chunks.reduce((sum, { data }) => sum + 12 + data.length, SIGNATURE.length);
  const file = new Uint8Array(size);
  const view = new DataView(file.buffer);
  file.set(SIGNATURE);
  let at = SIGNATURE.length;
  for (const { type, data } of chunks) {
    view.setUint32(at, data.length);
    for (let i = 0; i < 4; i++) view.setUint8(at + 4 + i, type.charCodeAt(i));
    file.set(data, at + 8);
    view.setUint32(at + 8 + data.length, crc32(file.subarray(at + 4, at + 8 + data.length)));
    at += 12 + data.length;
  }
  return file;
}
