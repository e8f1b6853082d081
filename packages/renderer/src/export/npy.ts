/** NumPy's array file (its NEP 1): a dictionary in Python's notation, then the numbers. */
import { ByteReader } from './byte-reader.ts';
import { checkPicture, type FloatPicture, fromInterleaved, interleave, namesFor } from './float-picture.ts';
import { halfTable } from './half.ts';
import { checkBytes, checkSize, ImageError, MOST_BYTES } from './image-error.ts';

export interface NpyArray {
  readonly shape: readonly number[];
  /** In C's order: the last index runs fastest. Truth values are 0 and 1. */
  readonly data: Float32Array | Float64Array;
}

const MAGIC = '\x93NUMPY';
const LONGEST_HEAD = 65535;

/** Height × width × channels of float32, also of one channel. Their names are lost. */
export function writeNpy(picture: FloatPicture): Uint8Array<ArrayBuffer> {
  checkPicture('NPY', picture);
  const { width, height, channels } = picture;
  const text = `{'descr': '<f4', 'fortran_order': False, 'shape': (${height}, ${width}, ${channels.length}), }`;
  const head = `${text.padEnd(Math.ceil((text.length + 11) / 64) * 64 - 11)}\n`; // with what stands before: a multiple of 64
  const values = interleave(picture);
  const file = new Uint8Array(10 + head.length + values.length * 4);
  const view = new DataView(file.buffer);
  file.set([...MAGIC].map((character) => character.charCodeAt(0)));
  view.setUint8(6, 1); // the format's version, 1.0
  view.setUint16(8, head.length, true);
  file.set(new TextEncoder().encode(head), 10);
  for (let i = 0, at = 10 + head.length; i < values.length; i++, at += 4) view.setFloat32(at, values[i]!, true);
  return file;
}

/** Height × width, or height × width × channels, of any of the types of `readNpyArray`. */
export function readNpy(bytes: Uint8Array): FloatPicture {
  return arrayAsPicture(readNpyArray(bytes));
}

export function arrayAsPicture({ shape, data }: NpyArray): FloatPicture {
  if (shape.length < 2 || shape.length > 3)
    throw new ImageError('NPY array', `${shape.length} dimensions`, '2 or 3: height, width, channels');
  const [height, width, count = 1] = shape as [number, number, number?];
  checkSize('NPY array', width, height, count);
  return fromInterleaved(width, height, namesFor(count), data);
}

type Get = (view: DataView, at: number, little: boolean) => number;
interface ElementType {
  readonly bytes: number;
  readonly get: Get;
  /** Needs more digits than float32 has. */
  readonly double?: true;
}
const TYPES: Readonly<Record<string, ElementType>> = {
  f2: { bytes: 2, get: (view, at, little) => halfTable()[view.getUint16(at, little)]! },
  f4: { bytes: 4, get: (view, at, little) => view.getFloat32(at, little) },
  f8: { bytes: 8, get: (view, at, little) => view.getFloat64(at, little), double: true },
  b1: { bytes: 1, get: (view, at) => (view.getUint8(at) === 0 ? 0 : 1) },
  i1: { bytes: 1, get: (view, at) => view.getInt8(at) },
  u1: { bytes: 1, get: (view, at) => view.getUint8(at) },
  i2: { bytes: 2, get: (view, at, little) => view.getInt16(at, little) },
  u2: { bytes: 2, get: (view, at, little) => view.getUint16(at, little) },
  i4: { bytes: 4, get: (view, at, little) => view.getInt32(at, little), double: true },
  u4: { bytes: 4, get: (view, at, little) => view.getUint32(at, little), double: true },
  i8: { bytes: 8, get: (view, at, little) => Number(view.getBigInt64(at, little)), double: true },
};

export function readNpyArray(bytes: Uint8Array): NpyArray {
  const reader = new ByteReader(bytes);
  const { type, little, fortran, shape } = readHead(reader);
  const count = shape.reduce((product, side) => product * side, 1);
  const size = type.double ? 8 : 4;
  if (count * size > MOST_BYTES)
    throw new ImageError('NPY head', `${count} numbers`, `at most ${MOST_BYTES / size} of them`);
  checkBytes('NPY data', count * type.bytes, reader.left);
  const view = new DataView(bytes.buffer, bytes.byteOffset + reader.offset);
  const data = type.double ? new Float64Array(count) : new Float32Array(count);
  for (let i = 0; i < count; i++) data[i] = type.get(view, i * type.bytes, little);
  return { shape, data: fortran ? fromFortran(shape, data) : data };
}

function readHead(reader: ByteReader) {
  const part = 'NPY head';
  const magic = String.fromCharCode(...reader.take(6, part));
  if (magic !== MAGIC) throw new ImageError('NPY start of the file', 'other bytes', 'the mark \\x93NUMPY');
  const [major] = [reader.u8(part), reader.u8(part)];
  if (major < 1 || major > 3) throw new ImageError('NPY version', String(major), '1 to 3');
  const length = major === 1 ? reader.u16(part) : reader.u32(part);
  if (length > LONGEST_HEAD) throw new ImageError(part, `${length} bytes`, `at most ${LONGEST_HEAD} bytes`);
  const text = new TextDecoder('latin1').decode(reader.take(length, part));
  const descr = /'descr'\s*:\s*'([<>|=]?)([a-zA-Z]\d{1,3})'/.exec(text);
  const type = descr && Object.hasOwn(TYPES, descr[2]!) ? TYPES[descr[2]!]! : null;
  if (!type) throw new ImageError(part, 'another type of number', Object.keys(TYPES).join(', '));
  const order = /'fortran_order'\s*:\s*(True|False)/.exec(text);
  const shape = /'shape'\s*:\s*\(([\d,\s]{0,200})\)/.exec(text);
  if (!order || !shape) throw new ImageError(part, 'too little', 'descr, fortran_order and shape');
  const sides = shape[1]!.split(',').map((side) => side.trim()).filter((side) => side !== ''); // biome-ignore format: short
  if (sides.length > 8 || sides.some((side) => !/^\d{1,10}$/.test(side)))
    throw new ImageError(part, 'another shape', 'at most 8 whole numbers');
  return { type, little: descr![1] !== '>', fortran: order[1] === 'True', shape: sides.map(Number) };
}

/** The first index runs fastest there. */
function fromFortran(shape: readonly number[], data: Float32Array | Float64Array): Float32Array | Float64Array {
  const sorted = data.slice();
  const index = shape.map(() => 0);
  const strides = shape.map((_, axis) => shape.slice(axis + 1).reduce((product, side) => product * side, 1));
  for (const value of data) {
    sorted[index.reduce((sum, i, axis) => sum + i * strides[axis]!, 0)] = value;
    for (let axis = 0; axis < shape.length && ++index[axis]! === shape[axis]; axis++) index[axis] = 0;
  }
  return sorted;
}
