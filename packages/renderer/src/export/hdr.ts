/** Radiance's RGBE picture: three mantissas of eight bits with one exponent (G. Ward, "Real Pixels", Graphics Gems II). */
import { ByteReader } from './byte-reader.ts';
import { ByteWriter } from './byte-writer.ts';
import { COLOUR_CHANNELS, colourOnly, createPicture, type FloatPicture } from './float-picture.ts';
import { checkBytes, checkSize, ImageError } from './image-error.ts';

/** Lines of other widths are not packed. */
const [LEAST_RUN_WIDTH, MOST_RUN_WIDTH] = [8, 32767];
const NEWLINE = 10;
const MOST_LINE = 2048;
const PART = 'HDR pixel data';

/** Negative values and NaN become 0, what is too large becomes the largest value. */
export function writeHdr(picture: FloatPicture): Uint8Array<ArrayBuffer> {
  const { width, height, channels } = colourOnly('HDR', picture, [1, 3]);
  const writer = new ByteWriter().text(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`);
  const [red, green, blue] = channels.length === 3 ? channels : [channels[0]!, channels[0]!, channels[0]!];
  const line = new Uint8Array(width * 4);
  const packs = width >= LEAST_RUN_WIDTH && width <= MOST_RUN_WIDTH;
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const i = y * width + x;
      writeRgbe(red!.data[i]!, green!.data[i]!, blue!.data[i]!, line, x * 4);
    }
    writer.bytes(packs ? packLine(line, width) : line.slice());
  }
  return writer.finish();
}

/** Rounded to the nearest, so that the mean of many pixels is kept; `readRgbe` adds no half. */
function writeRgbe(r: number, g: number, b: number, to: Uint8Array, at: number): void {
  const [red, green, blue] = [bound(r), bound(g), bound(b)];
  const largest = Math.max(red, green, blue);
  to.fill(0, at, at + 4);
  if (largest < 2 ** -128) return;
  let exponent = Math.floor(Math.log2(largest)) + 1;
  // The logarithm may be off by one near powers of two, and rounding may give 256.
  if (Math.round(largest * 2 ** (8 - exponent)) > 255) exponent++;
  if (Math.round(largest * 2 ** (9 - exponent)) <= 255) exponent--;
  const scale = 2 ** (8 - exponent);
  to[at] = Math.round(red * scale);
  to[at + 1] = Math.round(green * scale);
  to[at + 2] = Math.round(blue * scale);
  to[at + 3] = exponent + 128;
}

const LARGEST = 255 * 2 ** (127 - 8);
const bound = (value: number): number => (value > 0 ? Math.min(value, LARGEST) : 0);

/** Two bytes 2, the width, then all red bytes, green, blue, exponents: over 128 a run of count − 128, else so many bytes. */
function packLine(line: Uint8Array, width: number): Uint8Array {
  const packed: number[] = [2, 2, width >>> 8, width & 255];
  const byteAt = (c: number, x: number): number => line[x * 4 + c]!;
  for (let c = 0; c < 4; c++) {
    for (let x = 0; x < width; ) {
      const run = runLength(c, x);
      if (run >= 4) {
        packed.push(128 + run, byteAt(c, x));
        x += run;
        continue;
      }
      let end = x + run;
      while (end < width && end - x < 128 && runLength(c, end) < 4) end++;
      end = Math.min(end, x + 128);
      packed.push(end - x);
      for (; x < end; x++) packed.push(byteAt(c, x));
    }
  }
  return Uint8Array.from(packed);

  function runLength(c: number, start: number): number {
    let end = start + 1;
    while (end < width && end - start < 127 && byteAt(c, end) === byteAt(c, start)) end++;
    return end - start;
  }
}

/** The values as stored: a line EXPOSURE is not undone, as in other readers. Rows and columns may run either way. */
export function readHdr(bytes: Uint8Array): FloatPicture {
  const reader = new ByteReader(bytes);
  readHead(reader);
  const size = /^([-+])Y (\d{1,9}) ([-+])X (\d{1,9})\s*$/.exec(reader.textUntil(NEWLINE, 64, 'HDR line of sizes'));
  if (!size) throw new ImageError('HDR line of sizes', 'another text', '-Y height +X width');
  const [upwards, leftwards] = [size[1] === '+', size[3] === '-'];
  const [height, width] = [Number(size[2]), Number(size[4])];
  checkSize('HDR line of sizes', width, height, 3);
  const packs = width >= LEAST_RUN_WIDTH && width <= MOST_RUN_WIDTH;
  const shortest = packs ? 4 + 8 * Math.ceil(width / 127) : 4 * width;
  checkBytes(PART, Math.min(shortest, 4 * width) * height, reader.left);
  const picture = createPicture(width, height, COLOUR_CHANNELS[3]!);
  const [red, green, blue] = picture.channels;
  const line = new Uint8Array(width * 4);
  for (let k = 0; k < height; k++) {
    readLine(reader, line, packs);
    const row = (upwards ? height - 1 - k : k) * width;
    for (let x = 0; x < width; x++) {
      const i = row + (leftwards ? width - 1 - x : x);
      const scale = line[x * 4 + 3] === 0 ? 0 : 2 ** (line[x * 4 + 3]! - 136);
      red!.data[i] = line[x * 4]! * scale;
      green!.data[i] = line[x * 4 + 1]! * scale;
      blue!.data[i] = line[x * 4 + 2]! * scale;
    }
  }
  return picture;
}

function readHead(reader: ByteReader): void {
  const part = 'HDR head';
  // Ahead of the line, which in a file of another kind may have no end.
  if (reader.left < 2 || reader.bytes[0] !== 0x23 || reader.bytes[1] !== 0x3f)
    throw new ImageError('HDR first line', 'another text', '#?RADIANCE or #?RGBE');
  if (!/^#\?(RADIANCE|RGBE)\s*$/.test(reader.textUntil(NEWLINE, MOST_LINE, part)))
    throw new ImageError('HDR first line', 'another text', '#?RADIANCE or #?RGBE');
  let format = '';
  for (;;) {
    const line = reader.textUntil(NEWLINE, MOST_LINE, part).trim();
    if (line === '') break;
    if (line.startsWith('FORMAT=')) format = line.slice(7).trim();
  }
  if (format !== '' && format !== '32-bit_rle_rgbe') throw new ImageError(part, 'another FORMAT', '32-bit_rle_rgbe');
}

function readLine(reader: ByteReader, line: Uint8Array, packs: boolean): void {
  const width = line.length / 4;
  const { bytes, offset } = reader;
  const packed =
    packs && reader.left >= 4 && bytes[offset] === 2 && bytes[offset + 1] === 2 && bytes[offset + 2]! < 128;
  if (packed) {
    readPackedLine(reader, line);
    return;
  }
  line.set(reader.take(line.length, PART));
  // (1, 1, 1) cannot come from a colour: it marks a repeated pixel in files of before 1991.
  for (let x = 0; x < width; x++)
    if (line[x * 4] === 1 && line[x * 4 + 1] === 1 && line[x * 4 + 2] === 1 && line[x * 4 + 3] !== 0)
      throw new ImageError(PART, 'runs of the old kind', 'lines that are not packed, or of the new kind');
}

function readPackedLine(reader: ByteReader, line: Uint8Array): void {
  const width = line.length / 4;
  const head = reader.take(4, PART);
  const found = head[2]! * 256 + head[3]!;
  if (found !== width) throw new ImageError(PART, `a line of ${found} pixels`, `lines of ${width}`);
  for (let c = 0; c < 4; c++)
    for (let x = 0; x < width; ) {
      const count = reader.u8(PART);
      const length = count > 128 ? count - 128 : count;
      if (length === 0 || x + length > width)
        throw new ImageError(PART, `a run of ${length} at pixel ${x}`, `runs that fill ${width} pixels`);
      if (count > 128) {
        const value = reader.u8(PART);
        for (let end = x + length; x < end; x++) line[x * 4 + c] = value;
      } else for (const value of reader.take(length, PART)) line[x++ * 4 + c] = value;
    }
}
