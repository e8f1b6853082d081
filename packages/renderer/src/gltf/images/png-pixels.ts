/** PNG (ISO/IEC 15948) → 8-bit RGBA, wherever no browser does it. Colour profiles and gamma do not count: glTF says so. */
import { ImageError } from '../../export/image-error.ts';
import { inflateZlib } from '../../export/inflate.ts';
import { readChunks } from '../../export/png/chunks.ts';
import type { ImagePixels } from '../../scene/textures.ts';

interface Head {
  readonly width: number;
  readonly height: number;
  readonly bits: number;
  readonly colour: number;
  readonly interlaced: boolean;
}

/** Channels by colour type. */
const CHANNELS: Readonly<Record<number, number>> = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };
const DEPTHS: Readonly<Record<number, readonly number[]>> = {
  0: [1, 2, 4, 8, 16],
  2: [8, 16],
  3: [1, 2, 4, 8],
  4: [8, 16],
  6: [8, 16],
};
/** First column and row and their distances: Adam7, or everything at once. */
const PASSES = [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]] as const; // biome-ignore format: a table
const WHOLE = [[0, 0, 1, 1]] as const;

/** Throws an ImageError. Makes nothing larger than the head says, so look at that first. */
export function decodePng(bytes: Uint8Array): ImagePixels {
  const chunks = readChunks(bytes);
  const head = readHead(chunks[0]!.data);
  const chunk = (type: string): Uint8Array | undefined => chunks.find((one) => one.type === type)?.data;
  const palette = chunk('PLTE');
  if (head.colour === 3 && !palette) throw new ImageError('PNG palette', 'nothing', 'a palette for colour type 3');
  const parts = chunks.filter(({ type }) => type === 'IDAT').map(({ data }) => data);
  const passes = (head.interlaced ? PASSES : WHOLE)
    .map((pass) => ({
      pass,
      width: sizeOf(head.width, pass[0], pass[2]),
      height: sizeOf(head.height, pass[1], pass[3]),
    }))
    .filter(({ width, height }) => width > 0 && height > 0);
  const lineBytes = (width: number): number => Math.ceil((width * CHANNELS[head.colour]! * head.bits) / 8);
  const size = passes.reduce((sum, { width, height }) => sum + height * (1 + lineBytes(width)), 0);
  const lines = inflateZlib(join(parts), size, 'PNG pixel data');
  const rgba = new Uint8Array(head.width * head.height * 4);
  const paint = painter(head, palette, chunk('tRNS'));
  let at = 0;
  for (const { pass, width, height } of passes) {
    const stride = lineBytes(width);
    unfilter(lines, at, stride, height, Math.max((CHANNELS[head.colour]! * head.bits) >> 3, 1));
    for (let y = 0; y < height; y++) {
      const row = (pass[1] + y * pass[3]) * head.width;
      const line = at + y * (stride + 1) + 1;
      for (let x = 0; x < width; x++) paint(lines, line, x, rgba, 4 * (row + pass[0] + x * pass[2]));
    }
    at += height * (stride + 1);
  }
  return { width: head.width, height: head.height, rgba };
}

const sizeOf = (whole: number, first: number, step: number): number => Math.ceil((whole - first) / step);

function readHead(data: Uint8Array): Head {
  if (data.length !== 13) throw new ImageError('PNG head', `${data.length} bytes`, '13 bytes');
  const view = new DataView(data.buffer, data.byteOffset, 13);
  const [width, height, bits, colour] = [view.getUint32(0), view.getUint32(4), data[8]!, data[9]!];
  if (!DEPTHS[colour]?.includes(bits))
    throw new ImageError('PNG head', `colour type ${colour} of ${bits} bits`, 'one that the format knows');
  if (data[10] !== 0 || data[11] !== 0 || data[12]! > 1)
    throw new ImageError('PNG head', 'unknown methods', '0 0 0 or 0 0 1');
  return { width, height, bits, colour, interlaced: data[12] === 1 };
}

function join(parts: readonly Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** In place; lines stand one after the other, each behind the byte of its filter. */
function unfilter(lines: Uint8Array, start: number, stride: number, height: number, pixel: number): void {
  for (let y = 0; y < height; y++) {
    const line = start + y * (stride + 1) + 1;
    const filter = lines[line - 1]!;
    if (filter > 4) throw new ImageError('PNG pixel data', `the filter ${filter}`, '0 to 4');
    if (filter === 0) continue;
    const above = y > 0 ? line - stride - 1 : -1;
    for (let i = 0; i < stride; i++) {
      const left = i >= pixel ? lines[line + i - pixel]! : 0;
      const up = above >= 0 ? lines[above + i]! : 0;
      const corner = i >= pixel && above >= 0 ? lines[above + i - pixel]! : 0;
      const guess = filter === 1 ? left : filter === 2 ? up : filter === 3 ? (left + up) >> 1 : paeth(left, up, corner);
      lines[line + i] = lines[line + i]! + guess;
    }
  }
}

function paeth(a: number, b: number, c: number): number {
  const p = a + b - c;
  const [pa, pb, pc] = [Math.abs(p - a), Math.abs(p - b), Math.abs(p - c)];
  if (pa <= pb && pa <= pc) return a;
  return pb <= pc ? b : c;
}

type Paint = (lines: Uint8Array, line: number, x: number, out: Uint8Array, at: number) => void;

function painter({ bits, colour }: Head, palette: Uint8Array | undefined, transparency: Uint8Array | undefined): Paint {
  const channels = CHANNELS[colour]!;
  if (bits === 8 && channels === 4) return (lines, line, x, out, at) => void out.set(lines.subarray(line + 4 * x, line + 4 * x + 4), at); // biome-ignore format: short
  const most = 2 ** bits - 1;
  const sample = (lines: Uint8Array, line: number, i: number): number => {
    if (bits === 8) return lines[line + i]!;
    if (bits === 16) return lines[line + 2 * i]! * 256 + lines[line + 2 * i + 1]!;
    const bit = i * bits;
    return (lines[line + (bit >> 3)]! >> (8 - bits - (bit & 7))) & most;
  };
  if (colour === 3)
    return (lines, line, x, out, at) => {
      const index = sample(lines, line, x);
      for (let c = 0; c < 3; c++) out[at + c] = palette![3 * index + c] ?? 0;
      out[at + 3] = transparency?.[index] ?? 255;
    };
  const coloured = channels >= 3;
  // One colour may stand for "nothing here".
  const key = transparency && (coloured ? [0, 2, 4] : [0]).map((i) => transparency[i]! * 256 + transparency[i + 1]!);
  const toByte = (value: number): number => Math.round((value * 255) / most);
  return (lines, line, x, out, at) => {
    const first = x * channels;
    for (let c = 0; c < 3; c++) out[at + c] = toByte(sample(lines, line, first + (coloured ? c : 0)));
    const hidden = key?.every((value, c) => sample(lines, line, first + c) === value);
    out[at + 3] = channels % 2 === 0 ? toByte(sample(lines, line, first + channels - 1)) : hidden ? 0 : 255;
  };
}
