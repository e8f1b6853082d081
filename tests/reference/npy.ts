/** NumPy's array files (numpy.lib.format, versions 1 to 3): little endian floats of 2 and 4 bytes in C order, all that we need of it. */

export interface NumberArray {
  readonly shape: readonly number[];
  readonly data: Float32Array;
}

const MAGIC = '\x93NUMPY';

export function readNpy(bytes: Uint8Array): NumberArray {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const latin = (from: number, to: number) => String.fromCharCode(...bytes.subarray(from, to));
  if (latin(0, 6) !== MAGIC) throw new Error('This is no NPY file.');
  const start = bytes[6]! === 1 ? 10 : 12;
  const end = start + (bytes[6]! === 1 ? view.getUint16(8, true) : view.getUint32(8, true));
  const header = latin(start, end);
  const [, type] = /'descr': '(<f[24])'/.exec(header) ?? [];
  const [, size] = /'shape': \(([\d, ]*)\)/.exec(header) ?? [];
  if (!type || size === undefined || !header.includes("'fortran_order': False"))
    throw new Error(`An NPY file of <f2 or <f4 in C order is wanted, but this one says ${header.trim()}.`);
  const shape = size.split(',').filter(Boolean).map(Number);
  const count = shape.reduce((product, n) => product * n, 1);
  const width = type === '<f2' ? 2 : 4;
  if (bytes.length < end + count * width) throw new Error('The NPY file is shorter than it says.');
  const one =
    width === 2 ? (at: number) => halfToFloat(view.getUint16(at, true)) : (at: number) => view.getFloat32(at, true);
  return { shape, data: Float32Array.from({ length: count }, (_, i) => one(end + i * width)) };
}

export function writeNpy(
  array: { readonly shape: readonly number[]; readonly data: ArrayLike<number> },
  bits: 16 | 32,
) {
  const { shape, data } = array;
  const dictionary = `{'descr': '<f${bits / 8}', 'fortran_order': False, 'shape': (${shape.join(', ')},), }`;
  // Header and line end fill a multiple of 64 bytes, so that what follows can be mapped.
  const header = dictionary.padEnd(Math.ceil((dictionary.length + 11) / 64) * 64 - 11);
  const start = 10 + header.length + 1;
  const bytes = new Uint8Array(start + (data.length * bits) / 8);
  const view = new DataView(bytes.buffer);
  bytes.set(Array.from(`${MAGIC}\x01\x00`, (c) => c.charCodeAt(0)));
  view.setUint16(8, header.length + 1, true);
  bytes.set(
    Array.from(`${header}\n`, (c) => c.charCodeAt(0)),
    10,
  );
  for (let i = 0; i < data.length; i++) {
    if (bits === 32) view.setFloat32(start + 4 * i, data[i]!, true);
    else view.setUint16(start + 2 * i, floatToHalf(data[i]!), true);
  }
  return bytes;
}

/** IEEE 754 binary16: 1 bit of sign, 5 of exponent, 10 of fraction. */
export function halfToFloat(half: number): number {
  const sign = half & 0x8000 ? -1 : 1;
  const exponent = (half >> 10) & 31;
  const fraction = half & 1023;
  if (exponent === 31) return fraction === 0 ? sign * Number.POSITIVE_INFINITY : Number.NaN;
  return sign * (exponent === 0 ? fraction * 2 ** -24 : (1 + fraction / 1024) * 2 ** (exponent - 15));
}

/** To nearest; ties to even. */
export function floatToHalf(x: number): number {
  const sign = x < 0 || Object.is(x, -0) ? 0x8000 : 0;
  const size = Math.abs(x);
  if (Number.isNaN(x)) return 0x7e00;
  if (size >= 65520) return sign | 0x7c00;
  // The distance between neighbours; below 2⁻¹⁴ they lie as close as there.
  const exponent = Math.max(Math.floor(Math.log2(size)), -14);
  const steps = roundToEven(size / 2 ** (exponent - 10));
  // What is rounded up to the next power of two carries into the exponent by itself.
  return sign | (exponent === -14 ? steps : ((exponent + 14) << 10) + steps);
}

function roundToEven(x: number): number {
  const low = Math.floor(x);
  const rest = x - low;
  return rest > 0.5 || (rest === 0.5 && low % 2 === 1) ? low + 1 : low;
}
