/**
 * OpenEXR's PIZ: the 16-bit words that occur are numbered, a Haar wavelet sorts them by scale, Huffman's code packs them.
 * As in ImfPizCompressor.cpp of the OpenEXR library; read only.
 */
import { ByteReader } from '../byte-reader.ts';
import { ImageError } from '../image-error.ts';
import { BYTES_OF, type ExrHeader } from './header.ts';
import { unpackHuffman } from './huffman.ts';
import { restoreWavelet } from './wavelet.ts';

const PART = 'EXR block (PIZ)';
/** One bit for each 16-bit word. */
const BITMAP_BYTES = 8192;

/** Gives the lines one after another, of each the channels one after another. */
export function unpackPiz(header: ExrHeader, packed: Uint8Array, lines: number, size: number): Uint8Array {
  const reader = new ByteReader(packed);
  const numbered = readWords(reader);
  const stream = reader.take(reader.i32(PART), PART);
  const words = unpackHuffman(stream, size / 2);
  restoreChannels(header, words, lines, numbered.length - 1);
  const table = new Uint16Array(65536);
  table.set(numbered);
  for (let i = 0; i < words.length; i++) words[i] = table[words[i]!]!;
  return toLines(header, words, lines);
}

/** The words that occur, in order; 0 always counts as one of them. */
function readWords(reader: ByteReader): number[] {
  const [first, last] = [reader.u16(PART), reader.u16(PART)];
  if (last >= BITMAP_BYTES) throw new ImageError(PART, `a table of words up to ${last}`, `up to ${BITMAP_BYTES - 1}`);
  const words = [0];
  const bitmap = first <= last ? reader.take(last - first + 1, PART) : new Uint8Array(0);
  bitmap.forEach((byte, index) => {
    for (let bit = 0; bit < 8; bit++) {
      const word = (first + index) * 8 + bit;
      if (byte & (1 << bit) && word > 0) words.push(word);
    }
  });
  return words;
}

/** The wavelet is laid over each channel alone; of 32-bit channels over the low words and the high ones. */
function restoreChannels(header: ExrHeader, words: Uint16Array, lines: number, most: number): void {
  let start = 0;
  for (const { type } of header.channels) {
    const step = BYTES_OF[type] / 2;
    for (let j = 0; j < step; j++)
      restoreWavelet(words, start + j, { nx: header.width, ox: step, ny: lines, oy: header.width * step }, most);
    start += header.width * lines * step;
  }
}

function toLines(header: ExrHeader, words: Uint16Array, lines: number): Uint8Array {
  const bytes = new Uint8Array(words.length * 2);
  let to = 0;
  for (let y = 0; y < lines; y++) {
    let start = 0;
    for (const { type } of header.channels) {
      const count = (header.width * BYTES_OF[type]) / 2;
      for (let i = start + y * count; i < start + (y + 1) * count; i++) {
        bytes[to++] = words[i]!;
        bytes[to++] = words[i]! >>> 8;
      }
      start += count * lines;
    }
  }
  return bytes;
}
