/** OpenEXR: any number of named channels of floats, packed by ZIP; the format for layers. */
import { ByteReader } from './byte-reader.ts';
import { packZip, unpackBlock } from './exr/blocks.ts';
import { BYTES_OF, type ExrChannel, type ExrHeader, type PixelType, readHeader, writeHeader } from './exr/header.ts';
import { type Channel, checkPicture, type FloatPicture, layerOf } from './float-picture.ts';
import { floatToHalf, halfTable } from './half.ts';
import { checkBytes, checkSize, ImageError, MOST_GROWTH } from './image-error.ts';

export interface ExrOptions {
  /** Channels of 16-bit floats: all, or those that this says. Without it all have 32 bits. */
  readonly half?: boolean | ((channelName: string) => boolean);
}

const LINES_OF_ZIP = 16;

export function writeExr(picture: FloatPicture, { half = false }: ExrOptions = {}): Uint8Array<ArrayBuffer> {
  checkPicture('EXR', picture);
  const { width, height } = picture;
  // The format wants them in the order of their bytes, which is how readers find them.
  const sorted = [...picture.channels].sort((a, b) => (a.name < b.name ? -1 : 1));
  sorted.forEach(({ name }, index) => {
    if (name === sorted[index + 1]?.name)
      throw new ImageError('EXR file to write', `two channels ${name}`, 'each once');
  });
  const isHalf = typeof half === 'function' ? half : () => half;
  const channels = sorted.map(({ name }): ExrChannel => ({ name, type: isHalf(name) ? 'half' : 'float' }));
  const head = writeHeader({ width, height, channels, texts: { ...picture.texts } });
  const blocks: Uint8Array[] = [];
  for (let y = 0; y < height; y += LINES_OF_ZIP)
    blocks.push(packZip(blockOf(sorted, channels, width, y, Math.min(y + LINES_OF_ZIP, height))));
  return joinFile(head, blocks);
}

/** The head, where each block begins, the blocks with their first line and length before them. */
function joinFile(head: Uint8Array, blocks: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const size = blocks.reduce((sum, block) => sum + 16 + block.length, head.length);
  const file = new Uint8Array(size);
  const view = new DataView(file.buffer);
  file.set(head);
  let at = head.length + blocks.length * 8;
  blocks.forEach((block, index) => {
    view.setBigUint64(head.length + index * 8, BigInt(at), true);
    view.setInt32(at, index * LINES_OF_ZIP, true);
    view.setInt32(at + 4, block.length, true);
    file.set(block, at + 8);
    at += 8 + block.length;
  });
  return file;
}

function blockOf(data: readonly Channel[], types: readonly ExrChannel[], width: number, top: number, end: number) {
  const raw = new Uint8Array((end - top) * lineBytes(types, width));
  const view = new DataView(raw.buffer);
  let at = 0;
  for (let y = top; y < end; y++)
    data.forEach(({ data: values }, c) => {
      const isHalf = types[c]!.type === 'half';
      for (let i = y * width; i < (y + 1) * width; i++, at += isHalf ? 2 : 4)
        if (isHalf) view.setUint16(at, floatToHalf(values[i]!), true);
        else view.setFloat32(at, values[i]!, true);
    });
  return raw;
}

const lineBytes = (channels: readonly ExrChannel[], width: number): number =>
  width * channels.reduce((sum, { type }) => sum + BYTES_OF[type], 0);

/**
 * Scan-line files of one part, of half, float and uint channels; stored, RLE, ZIPS, ZIP or PIZ. The picture is the data window.
 * Whole numbers beyond 2^24 lose their last digits, since they become floats.
 */
export function readExr(bytes: Uint8Array): FloatPicture {
  const reader = new ByteReader(bytes);
  const header = readHeader(reader);
  const { width, height, texts } = header;
  checkSize('EXR header', width, height, header.channels.length);
  const blocks = findBlocks(reader, header);
  const channels = header.channels.map(({ name }) => ({ name, data: new Float32Array(width * height) }));
  for (const { packed, line, lines } of blocks) {
    const raw = unpackBlock(header, packed, lines, lines * lineBytes(header.channels, width));
    readLines(header, raw, channels, line, lines);
  }
  return { width, height, channels: inUsualOrder(channels), texts };
}

interface Block {
  readonly packed: Uint8Array;
  /** Its first line, counted in the picture, and how many it holds. */
  readonly line: number;
  readonly lines: number;
}

/** Looks at every block before room for the picture is made: a short file cannot ask for a large one. */
function findBlocks(reader: ByteReader, header: ExrHeader): Block[] {
  const { height, top, compression } = header;
  const count = Math.ceil(height / compression.lines);
  checkBytes('EXR table of blocks', count * 16, reader.left);
  const offsets = Array.from({ length: count }, () => reader.u64('EXR table of blocks'));
  const size = lineBytes(header.channels, header.width);
  let packedBytes = 0;
  return offsets.map((offset, index) => {
    if (offset > reader.bytes.length || offset === 0)
      throw new ImageError('EXR table of blocks', `a block at byte ${offset}`, `bytes of the file, which has ${reader.bytes.length}`); // biome-ignore format: one sentence
    reader.offset = offset;
    const line = reader.i32('EXR block') - top;
    if (line !== index * compression.lines)
      throw new ImageError('EXR block', `line ${line + top}`, `line ${index * compression.lines + top}`);
    const packed = reader.take(reader.i32('EXR block'), 'EXR block');
    const lines = Math.min(compression.lines, height - line);
    checkGrowth(packed.length, size * lines);
    packedBytes += packed.length;
    if (packedBytes > reader.bytes.length)
      throw new ImageError('EXR table of blocks', 'blocks that overlap', 'each byte in one block');
    return { packed, line, lines };
  });
}

/** RLE and PIZ grow by less than deflate does. */
function checkGrowth(packed: number, size: number): void {
  if (size > packed * MOST_GROWTH)
    throw new ImageError(
      'EXR block',
      `${packed} bytes for lines of ${size}`,
      `at least ${Math.ceil(size / MOST_GROWTH)}`,
    );
}

function readLines(
  header: ExrHeader,
  raw: Uint8Array,
  channels: readonly Channel[],
  line: number,
  lines: number,
): void {
  const view = new DataView(raw.buffer, raw.byteOffset, raw.byteLength);
  const { width } = header;
  let at = 0;
  for (let y = line; y < line + lines; y++)
    header.channels.forEach(({ type }, c) => {
      readRow(view, at, type, channels[c]!.data.subarray(y * width, (y + 1) * width));
      at += width * BYTES_OF[type];
    });
}

function readRow(view: DataView, start: number, type: PixelType, row: Float32Array): void {
  const halves = halfTable();
  if (type === 'half') for (let i = 0; i < row.length; i++) row[i] = halves[view.getUint16(start + 2 * i, true)]!;
  else if (type === 'float') for (let i = 0; i < row.length; i++) row[i] = view.getFloat32(start + 4 * i, true);
  else for (let i = 0; i < row.length; i++) row[i] = view.getUint32(start + 4 * i, true);
}

/** Files have A B G R. Here layers keep their order, and inside one the channels stand as people say them. */
function inUsualOrder(channels: readonly Channel[]): Channel[] {
  const layers = [...new Set(channels.map(({ name }) => layerOf(name)))];
  const usual = ['R', 'G', 'B', 'X', 'Y', 'Z', 'A'];
  const rank = (name: string): number => {
    const place = usual.indexOf(name.slice(name.lastIndexOf('.') + 1));
    return layers.indexOf(layerOf(name)) * 16 + (place < 0 ? 15 : place);
  };
  return [...channels].sort((a, b) => rank(a.name) - rank(b.name));
}
