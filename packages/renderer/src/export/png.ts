/** PNG of 8 or 16 bits, with texts beside the pixels. Values are 0 … 1 as they stand: who wants sRGB applies its curve. */
import { decode, encode } from 'fast-png';
import {
  COLOUR_CHANNELS,
  colourOnly,
  type FloatPicture,
  fromInterleaved,
  interleave,
  noTexts,
} from './float-picture.ts';
import { checkSize, ImageError } from './image-error.ts';
import { inflateZlib } from './inflate.ts';
import { type Chunk, joinChunks, readChunks } from './png/chunks.ts';
import { readText, writeText } from './png/texts.ts';

export interface PngOptions {
  /** Of each channel; 8 without it. */
  readonly bits?: 8 | 16;
}

/** Grey or RGB, with or without A. Values are clipped to 0 … 1 and rounded to the nearest; NaN becomes 0. */
export function writePng(picture: FloatPicture, { bits = 8 }: PngOptions = {}): Uint8Array<ArrayBuffer> {
  const coloured = colourOnly('PNG', picture, [1, 2, 3, 4]);
  const { width, height, channels } = coloured;
  const values = interleave(coloured);
  const most = 2 ** bits - 1;
  const data = bits === 8 ? new Uint8Array(values.length) : new Uint16Array(values.length);
  for (let i = 0; i < data.length; i++) data[i] = Math.min(Math.max(values[i]!, 0), 1) * most + 0.5;
  const plain = readChunks(
    encode({ width, height, data, depth: bits, channels: channels.length }, { zlib: { level: 6 } }),
  );
  const texts = Object.entries(picture.texts ?? {}).map(([key, text]) => writeText(key, text));
  const [head, ...rest] = plain;
  return joinChunks([head!, ...texts, ...rest]);
}

/** Whole or interlaced pictures of 8 or 16 bits; no palettes. */
export function readPng(bytes: Uint8Array): FloatPicture {
  const chunks = readChunks(bytes);
  const { width, height, bits, count } = checkPixels(chunks);
  const needed = chunks.filter(({ type }) => type === 'IHDR' || type === 'IDAT' || type === 'IEND');
  let values: ArrayLike<number>;
  try {
    values = decode(joinChunks(needed)).data;
  } catch {
    throw new ImageError('PNG pixel data', 'damaged lines', 'lines with filters 0 to 4');
  }
  const picture = fromInterleaved(width, height, COLOUR_CHANNELS[count]!, values);
  const most = 2 ** bits - 1;
  for (const { data } of picture.channels) for (let i = 0; i < data.length; i++) data[i]! /= most;
  return { ...picture, texts: readTexts(chunks) };
}

/** Colour types of PNG (its section 11.2.1) and their channels. */
const COUNTS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 4: 2, 6: 4 };

/** Unfolds the pixels once to see that they are as many as the head says: fast-png takes what comes. */
function checkPixels(chunks: readonly Chunk[]): { width: number; height: number; bits: number; count: number } {
  const head = chunks[0]!.data;
  if (head.length !== 13) throw new ImageError('PNG head', `${head.length} bytes`, '13 bytes');
  const view = new DataView(head.buffer, head.byteOffset, 13);
  const [width, height, bits, colourType] = [view.getUint32(0), view.getUint32(4), head[8]!, head[9]!];
  const count = COUNTS[colourType];
  if (!count || (bits !== 8 && bits !== 16) || chunks.some(({ type }) => type === 'tRNS'))
    throw new ImageError(
      'PNG head',
      `colour type ${colourType} of ${bits} bits`,
      'grey or RGB of 8 or 16 bits, with or without alpha',
    );
  if (head[10] !== 0 || head[11] !== 0 || head[12]! > 1)
    throw new ImageError('PNG head', `the methods ${head[10]} ${head[11]} ${head[12]}`, '0 0 0 or 0 0 1');
  checkSize('PNG head', width, height, count);
  const packed = joinData(chunks.filter(({ type }) => type === 'IDAT').map(({ data }) => data));
  const lines = head[12] === 1 ? interlacedLines(width, height) : [{ width, count: height }];
  const size = lines.reduce((sum, pass) => sum + pass.count * (1 + (pass.width * count * bits) / 8), 0);
  inflateZlib(packed, size, 'PNG pixel data');
  return { width, height, bits, count };
}

/** Adam7's seven pictures: first column and row, and their distances. */
const PASSES = [
  [0, 0, 8, 8],
  [4, 0, 8, 8],
  [0, 4, 4, 8],
  [2, 0, 4, 4],
  [0, 2, 2, 4],
  [1, 0, 2, 2],
  [0, 1, 1, 2],
] as const;

const interlacedLines = (width: number, height: number): { width: number; count: number }[] =>
  PASSES.map(([x, y, dx, dy]) => ({ width: Math.ceil((width - x) / dx), count: Math.ceil((height - y) / dy) })).filter(
    (pass) => pass.width > 0 && pass.count > 0,
  );

function joinData(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

function readTexts(chunks: readonly Chunk[]): Record<string, string> {
  const texts = noTexts();
  for (const chunk of chunks) {
    const found = readText(chunk);
    if (found) texts[found.key] = found.text;
  }
  return texts;
}
