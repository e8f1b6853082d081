import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { contentOf, wildPicture } from '../../../../tests/fixtures/pictures.ts';
import { readNpy, readNpyArray, writeNpy } from './npy.ts';
import { readNpz } from './npz.ts';

/** A file as NumPy writes it. */
function npy(descr: string, shape: string, numbers: readonly number[], fortran = 'False'): Uint8Array {
  const text = `{'descr': '${descr}', 'fortran_order': ${fortran}, 'shape': ${shape}, }\n`;
  const head = [...text].map((letter) => letter.charCodeAt(0));
  return Uint8Array.from([0x93, 78, 85, 77, 80, 89, 1, 0, head.length, 0, ...head, ...numbers]);
}

test.each([1, 2, 3, 4, 7])('floats of all kinds come back as they were, seed 51, %i channels', (count) => {
  const names =
    [['Y'], ['Y', 'A'], ['R', 'G', 'B'], ['R', 'G', 'B', 'A']][count - 1] ?? [...'0123456'].map((c) => `c${c}`);
  const picture = wildPicture(51, 5, 4, names);
  const file = writeNpy(picture);
  expect(contentOf(readNpy(file))).toEqual(contentOf(picture));
  expect((file.length - 5 * 4 * count * 4) % 64).toBe(0);
});

test.each([
  ['<f2', [0, 0x3c, 1, 0x80], [1, -(2 ** -24)]],
  ['>f4', [0x3f, 0x80, 0, 0, 0xc0, 0, 0, 0], [1, -2]],
  ['<f8', [0x9a, 0x99, 0x99, 0x99, 0x99, 0x99, 0xb9, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0], [0.1, 0]],
  ['|b1', [0, 1], [0, 1]],
  ['|u1', [7, 255], [7, 255]],
  ['<i2', [254, 255, 1, 1], [-2, 257]],
  ['<u4', [255, 255, 255, 255, 0, 0, 0, 0], [4294967295, 0]],
  ['<i8', [255, 255, 255, 255, 255, 255, 255, 255, 3, 0, 0, 0, 0, 0, 0, 0], [-1, 3]],
])('numbers of the type %s', (descr, bytes, numbers) => {
  expect(Array.from(readNpyArray(npy(descr, '(2,)', bytes)).data)).toEqual(numbers);
});

test("Fortran's order", () => {
  const array = readNpyArray(npy('|u1', '(2, 3)', [0, 10, 1, 11, 2, 12], 'True'));
  expect(array.shape).toEqual([2, 3]);
  expect(Array.from(array.data)).toEqual([0, 1, 2, 10, 11, 12]);
});

test.each([
  [npy('<c8', '(1, 1)', []), 'NPY head has another type of number'],
  [npy('constructor', '(1, 1)', []), 'NPY head has another type of number'],
  [npy('<f4', '(99999, 99999, 99999)', []), 'numbers; expected at most 536870912 of them'],
  [npy('<f4', '(9999, 9999)', []), 'NPY data has 0 bytes left'],
  [npy('<f4', '(0, 5)', []), '1 to 65536 pixels a side'],
  [npy('<f4', '(2,)', [0, 0, 0, 0, 0, 0, 0, 0]), '1 dimensions'],
])('case %# is refused', (bytes, message) => {
  expect(() => readNpy(bytes)).toThrow(message);
});

const archive = (level: 0 | 9): Uint8Array =>
  zipSync(
    { 'mean.npy': npy('|u1', '(1, 3)', [1, 2, 3]), 'se.npy': npy('<f2', '(1, 1)', [0, 0x3c]), other: Uint8Array.of(1) },
    { level },
  );

test.each([0, 9] as const)('arrays of an archive packed at level %i', (level) => {
  const npz = readNpz(archive(level));
  expect(npz.names).toEqual(['mean', 'se']);
  expect(Array.from(npz.read('mean').data)).toEqual([1, 2, 3]);
  expect(Array.from(npz.read('se').data)).toEqual([1]);
  expect(npz.has('other')).toBe(false);
  expect(() => npz.read('nothing')).toThrow('no array nothing');
});

test('an archive cannot claim that it unfolds to more than it can', () => {
  const file = archive(9);
  const view = new DataView(file.buffer);
  const at = file.findIndex((_, i) => i < file.length - 4 && view.getUint32(i, true) === 0x02014b50);
  view.setUint32(at + 24, 2 ** 31, true);
  expect(() => readNpz(file).read('mean')).toThrow('packed bytes; expected at least');
});
