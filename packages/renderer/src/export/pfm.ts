/** Portable float map: "PF" (RGB) or "Pf" (grey), a scale whose sign tells the order of bytes, rows from the bottom up. */
import { ByteReader } from './byte-reader.ts';
import { COLOUR_CHANNELS, colourOnly, type FloatPicture, fromInterleaved, interleave } from './float-picture.ts';
import { checkBytes, checkSize, ImageError } from './image-error.ts';

const NEWLINE = 10;

export function writePfm(picture: FloatPicture): Uint8Array<ArrayBuffer> {
  const coloured = colourOnly('PFM', picture, [1, 3]);
  const { width, height, channels } = coloured;
  const head = new TextEncoder().encode(`${channels.length === 3 ? 'PF' : 'Pf'}\n${width} ${height}\n-1.0\n`);
  const file = new Uint8Array(head.length + width * height * channels.length * 4);
  file.set(head);
  const view = new DataView(file.buffer, head.length);
  const values = interleave(coloured);
  const row = width * channels.length;
  for (let y = 0, at = 0; y < height; y++)
    for (let k = (height - 1 - y) * row; k < (height - y) * row; k++, at += 4) view.setFloat32(at, values[k]!, true);
  return file;
}

/** Values are multiplied with the scale's amount. */
export function readPfm(bytes: Uint8Array): FloatPicture {
  const reader = new ByteReader(bytes);
  const kind = reader.textUntil(NEWLINE, 8, 'PFM first line').trim();
  if (kind !== 'PF' && kind !== 'Pf') throw new ImageError('PFM first line', 'another text', 'PF or Pf');
  const size = /^\s*(\d{1,9})\s+(\d{1,9})\s*$/.exec(reader.textUntil(NEWLINE, 64, 'PFM line of sizes'));
  if (!size) throw new ImageError('PFM line of sizes', 'another text', 'width and height');
  const scale = Number(reader.textUntil(NEWLINE, 64, 'PFM line of the scale'));
  if (!Number.isFinite(scale) || scale === 0) throw new ImageError('PFM line of the scale', 'no such number', 'not 0');
  const [width, height, count] = [Number(size[1]), Number(size[2]), kind === 'PF' ? 3 : 1];
  checkSize('PFM line of sizes', width, height, count);
  checkBytes('PFM pixel data', width * height * count * 4, reader.left);
  const view = new DataView(bytes.buffer, bytes.byteOffset + reader.offset);
  const values = new Float32Array(width * height * count);
  const row = width * count;
  for (let y = height - 1, at = 0; y >= 0; y--)
    for (let k = y * row; k < (y + 1) * row; k++, at += 4) values[k] = view.getFloat32(at, scale < 0) * Math.abs(scale);
  return fromInterleaved(width, height, COLOUR_CHANNELS[count]!, values);
}
