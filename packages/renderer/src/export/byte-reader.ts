/** Reads a file from front to back and never beyond its end: what is missing is an ImageError with the part's name. */
import { checkBytes, ImageError } from './image-error.ts';

const utf8 = new TextDecoder();

export class ByteReader {
  readonly bytes: Uint8Array;
  readonly #view: DataView;
  offset = 0;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  get left(): number {
    return this.bytes.length - this.offset;
  }

  /** A view of the next bytes, not a copy. */
  take(count: number, part: string): Uint8Array {
    if (count < 0) throw new ImageError(part, `a length of ${count} bytes`, 'a length of 0 or more');
    return this.bytes.subarray(this.#pass(count, part), this.offset);
  }

  u8(part: string): number {
    return this.#view.getUint8(this.#pass(1, part));
  }
  u16(part: string): number {
    return this.#view.getUint16(this.#pass(2, part), true);
  }
  u32(part: string): number {
    return this.#view.getUint32(this.#pass(4, part), true);
  }
  i32(part: string): number {
    return this.#view.getInt32(this.#pass(4, part), true);
  }
  /** Exact up to 2^53; beyond, some number that is too large for any offset. */
  u64(part: string): number {
    const low = this.u32(part);
    return low + this.u32(part) * 2 ** 32;
  }

  /** Text up to a byte, which is passed over. */
  textUntil(end: number, most: number, part: string): string {
    const found = this.bytes.subarray(this.offset, this.offset + most + 1).indexOf(end);
    if (found < 0) {
      checkBytes(part, 1, this.left);
      throw new ImageError(part, 'a text without end', `a text of at most ${most} bytes`);
    }
    const text = utf8.decode(this.take(found, part));
    this.offset++;
    return text;
  }

  #pass(count: number, part: string): number {
    checkBytes(part, count, this.left);
    const at = this.offset;
    this.offset += count;
    return at;
  }
}
