/** Huffman's code as OpenEXR packs it (ImfHuf.cpp): canonical, the longest codes first, one symbol that repeats the last word. */
import { ByteReader } from '../byte-reader.ts';
import { checkBytes, ImageError } from '../image-error.ts';

const PART = 'EXR block (PIZ)';
/** All 16-bit words, and the symbol for runs. */
const SYMBOLS = 65537;
const LONGEST = 58;

/** Bits of a stream, the highest of each byte first. */
class BitReader {
  readonly #bytes: Uint8Array;
  readonly #end: number;
  #at: number;

  constructor(bytes: Uint8Array, start = 0, count = (bytes.length - start) * 8) {
    this.#bytes = bytes;
    this.#at = start * 8;
    this.#end = this.#at + count;
  }

  get atEnd(): boolean {
    return this.#at >= this.#end;
  }
  /** The byte after the last bit that was read. */
  get byteOffset(): number {
    return (this.#at + 7) >>> 3;
  }
  bit(): number {
    if (this.#at >= this.#end) throw new ImageError(PART, 'a code that is cut off', 'whole codes');
    const bit = (this.#bytes[this.#at >>> 3]! >>> (7 - (this.#at & 7))) & 1;
    this.#at++;
    return bit;
  }
  bits(count: number): number {
    let value = 0;
    for (let i = 0; i < count; i++) value = value * 2 + this.bit();
    return value;
  }
}

export function unpackHuffman(stream: Uint8Array, count: number): Uint16Array {
  const head = new ByteReader(stream);
  const [first, last] = [head.u32(PART), head.u32(PART)];
  head.u32(PART); // the table's length, which shows by itself
  const bitCount = head.u32(PART);
  head.u32(PART);
  if (first >= SYMBOLS || last >= SYMBOLS || first > last)
    throw new ImageError(PART, `symbols from ${first} to ${last}`, `a range in 0 to ${SYMBOLS - 1}`);
  const table = new BitReader(stream, head.offset);
  const code = new Code(readLengths(table, first, last));
  checkBytes(PART, Math.ceil(bitCount / 8), stream.length - table.byteOffset);
  // A run of 255 words takes 9 bits at least.
  if (count > (bitCount / 9) * 256 + 256)
    throw new ImageError(PART, `${bitCount} bits`, `enough bits for ${count} words`);
  return readSymbols(new BitReader(stream, table.byteOffset, bitCount), code, last, count);
}

/** Six bits a symbol: a code's length, or from 59 on a run of symbols that do not occur. */
function readLengths(bits: BitReader, first: number, last: number): Uint8Array {
  const lengths = new Uint8Array(SYMBOLS);
  for (let symbol = first; symbol <= last; ) {
    const length = bits.bits(6);
    if (length <= LONGEST) lengths[symbol++] = length;
    else symbol += length === 63 ? bits.bits(8) + 6 : length - 57;
    if (symbol > last + 1)
      throw new ImageError(PART, 'a table of codes that is too long', `${last - first + 1} symbols`);
  }
  return lengths;
}

/** Codes of one length are consecutive numbers, in the order of their symbols; longer ones have smaller numbers. */
class Code {
  readonly #start = new Float64Array(LONGEST + 1);
  readonly #count = new Uint32Array(LONGEST + 1);
  readonly #offset = new Uint32Array(LONGEST + 2);
  readonly #symbols: Uint32Array;

  constructor(lengths: Uint8Array) {
    for (const length of lengths) this.#count[length]!++;
    this.#count[0] = 0;
    for (let length = LONGEST, start = 0; length > 0; length--) {
      this.#start[length] = start;
      start = Math.floor((start + this.#count[length]!) / 2);
    }
    for (let length = 0; length <= LONGEST; length++)
      this.#offset[length + 1] = this.#offset[length]! + this.#count[length]!;
    const next = this.#offset.slice();
    this.#symbols = new Uint32Array(this.#offset[LONGEST + 1]!);
    lengths.forEach((length, symbol) => {
      if (length > 0) this.#symbols[next[length]!++] = symbol;
    });
  }

  /** No number that can go on exceeds the count of symbols, so no length of code is beyond exact arithmetic. */
  read(bits: BitReader): number {
    let number = 0;
    for (let length = 1; length <= LONGEST; length++) {
      number = number * 2 + bits.bit();
      const index = number - this.#start[length]!;
      if (index < 0) continue;
      if (index < this.#count[length]!) return this.#symbols[this.#offset[length]! + index]!;
      break;
    }
    throw new ImageError(PART, 'a code that its table lacks', 'codes of the table');
  }
}

function readSymbols(bits: BitReader, code: Code, runSymbol: number, count: number): Uint16Array {
  const words = new Uint16Array(count);
  const wrong = (found: string): ImageError => new ImageError(PART, found, `codes for ${count} words`);
  let at = 0;
  while (!bits.atEnd) {
    const symbol = code.read(bits);
    const times = symbol === runSymbol ? bits.bits(8) : 1;
    if (at + times > count) throw wrong('codes for more words');
    if (symbol !== runSymbol) words[at] = symbol;
    else if (at === 0) throw wrong('a run at its start');
    else words.fill(words[at - 1]!, at, at + times);
    at += times;
  }
  if (at !== count) throw wrong(`codes for ${at} words`);
  return words;
}
