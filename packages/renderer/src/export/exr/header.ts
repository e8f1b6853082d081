/** The head of an OpenEXR file: the technical introduction's "OpenEXR file layout", for scan-line files of one part. */
import { ByteReader } from '../byte-reader.ts';
import { ByteWriter } from '../byte-writer.ts';
import { noTexts } from '../float-picture.ts';
import { ImageError, MOST_CHANNELS } from '../image-error.ts';

export const PIXEL_TYPES = ['uint', 'half', 'float'] as const;
export type PixelType = (typeof PIXEL_TYPES)[number];
export const BYTES_OF: Readonly<Record<PixelType, number>> = { uint: 4, half: 2, float: 4 };

export interface ExrChannel {
  readonly name: string;
  readonly type: PixelType;
}

/** A kind of compression and the lines that it packs together. */
export interface Compression {
  readonly name: string;
  readonly lines: number;
}
const NAMED: readonly Compression[] = [
  { name: 'none', lines: 1 },
  { name: 'RLE', lines: 1 },
  { name: 'ZIPS', lines: 1 },
  { name: 'ZIP', lines: 16 },
  { name: 'PIZ', lines: 32 },
];
const ZIP = 3;

export interface ExrHeader {
  readonly channels: readonly ExrChannel[];
  readonly compression: Compression;
  readonly width: number;
  readonly height: number;
  /** The number of the first line. */
  readonly top: number;
  readonly texts: Record<string, string>;
}

/** The attributes that every file has. */
const RESERVED = [
  ...['channels', 'compression', 'dataWindow', 'displayWindow', 'lineOrder'],
  ...['pixelAspectRatio', 'screenWindowCenter', 'screenWindowWidth'],
];
const MAGIC = 20000630;
const LONG_NAMES = 0x400;
/** Names and types of attributes, channels' names. */
const MOST_NAME = 255;
const KINDS: readonly (readonly [flag: number, kind: string])[] = [
  [0x200, 'tiles'],
  [0x800, 'deep pixels'],
  [0x1000, 'more than one part'],
];

export function writeHeader(header: Omit<ExrHeader, 'compression' | 'top'>): Uint8Array {
  const writer = new ByteWriter();
  const names = [...header.channels.map(({ name }) => name), ...Object.keys(header.texts)];
  const lengths = names.map(nameLength);
  writer.u32(MAGIC).u32(2 | (lengths.some((length) => length > 31) ? LONG_NAMES : 0));
  const attribute = (name: string, type: string, value: ByteWriter): void => {
    writer.text(`${name}\0${type}\0`).u32(value.length).bytes(value.finish());
  };
  const make = (): ByteWriter => new ByteWriter();
  const window = (): ByteWriter =>
    make()
      .u32(0)
      .u32(0)
      .u32(header.width - 1)
      .u32(header.height - 1);
  attribute('channels', 'chlist', channelList(header.channels));
  attribute('compression', 'compression', make().u8(ZIP));
  attribute('dataWindow', 'box2i', window());
  attribute('displayWindow', 'box2i', window());
  attribute('lineOrder', 'lineOrder', make().u8(0));
  attribute('pixelAspectRatio', 'float', make().f32(1));
  attribute('screenWindowCenter', 'v2f', make().f32(0).f32(0));
  attribute('screenWindowWidth', 'float', make().f32(1));
  for (const [name, text] of Object.entries(header.texts)) attribute(name, 'string', make().text(text));
  return writer.u8(0).finish();
}

/** In bytes; 1 to 255, with no zero inside. */
function nameLength(name: string): number {
  if (RESERVED.includes(name))
    throw new ImageError(
      'EXR file to write',
      `a text or channel called ${name}`,
      'names that the format does not use itself',
    );
  const { length } = new TextEncoder().encode(name);
  if (length < 1 || length > MOST_NAME || name.includes('\0'))
    throw new ImageError(
      'EXR file to write',
      `a name of ${length} bytes`,
      `names of 1 to ${MOST_NAME} bytes, no zeros`,
    );
  return length;
}

function channelList(channels: readonly ExrChannel[]): ByteWriter {
  const list = new ByteWriter();
  for (const { name, type } of channels) {
    list.text(`${name}\0`).u32(PIXEL_TYPES.indexOf(type)).u32(0); // pLinear and three reserved bytes
    list.u32(1).u32(1); // sampling
  }
  return list.u8(0);
}

export function readHeader(reader: ByteReader): ExrHeader {
  checkVersion(reader);
  const texts = noTexts();
  const found: { channels?: ExrChannel[]; compression?: Compression; window?: number[] } = {};
  for (;;) {
    const name = reader.textUntil(0, MOST_NAME, 'EXR name of an attribute');
    if (name === '') break;
    const type = reader.textUntil(0, MOST_NAME, 'EXR type of an attribute');
    const value = reader.take(reader.i32('EXR length of an attribute'), 'EXR attribute');
    const inside = new ByteReader(value);
    if (name === 'channels') found.channels = readChannels(inside);
    else if (name === 'compression') found.compression = readCompression(inside);
    else if (name === 'dataWindow') found.window = Array.from({ length: 4 }, () => inside.i32('EXR data window'));
    else if (type === 'string') texts[name] = new TextDecoder().decode(value);
  }
  const { channels, compression, window } = found;
  if (!channels || !compression || !window)
    throw new ImageError('EXR header', 'too few attributes', 'channels, compression and dataWindow at least');
  const [left, top, right, bottom] = window as [number, number, number, number];
  return { channels, compression, width: right - left + 1, height: bottom - top + 1, top, texts };
}

function checkVersion(reader: ByteReader): void {
  const magic = reader.u32('EXR start of the file');
  if (magic !== MAGIC) throw new ImageError('EXR start of the file', `the number ${magic}`, String(MAGIC));
  const version = reader.u32('EXR version');
  if ((version & 255) !== 2) throw new ImageError('EXR version', String(version & 255), '2');
  for (const [flag, kind] of KINDS)
    if (version & flag) throw new ImageError('EXR file', kind, 'scan lines of flat pixels in one part');
}

function readChannels(reader: ByteReader): ExrChannel[] {
  const part = 'EXR channel list';
  const channels: ExrChannel[] = [];
  for (;;) {
    const name = reader.textUntil(0, MOST_NAME, part);
    if (name === '') return channels;
    const number = reader.u32(part);
    const type = PIXEL_TYPES[number];
    if (!type) throw new ImageError(part, `the pixel type ${number}`, '0 (uint), 1 (half) or 2 (float)');
    reader.u32(part);
    const [x, y] = [reader.i32(part), reader.i32(part)];
    if (x !== 1 || y !== 1) throw new ImageError(part, `a channel sampled every ${x} × ${y} pixels`, 'every pixel');
    if (channels.length >= MOST_CHANNELS)
      throw new ImageError(part, `more than ${MOST_CHANNELS} channels`, `at most ${MOST_CHANNELS}`);
    channels.push({ name, type });
  }
}

function readCompression(reader: ByteReader): Compression {
  const number = reader.u8('EXR compression');
  const allowed = NAMED.map(({ name }, index) => `${index} (${name})`).join(', ');
  const compression = NAMED[number];
  if (!compression) throw new ImageError('EXR compression', `the number ${number}`, allowed);
  return compression;
}
