import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { readExr } from './exr.ts';
import type { FloatPicture } from './float-picture.ts';
import { readHdr } from './hdr.ts';
import { readNpz } from './npz.ts';
import { readPng } from './png.ts';

// What made these files, and their formulas, stands in tests/fixtures/images/README.md.
const [WIDTH, HEIGHT] = [33, 35];
const file = (name: string): Uint8Array =>
  readFileSync(new URL(`../../../../tests/fixtures/images/${name}`, import.meta.url));

type Formula = (x: number, y: number) => number;
const red: Formula = (x, y) => (x * x) / 16 - 3 * y;
const green: Formula = (x, y) => ((x % 9) - 4) * 2 ** ((y % 7) - 12);
const blue: Formula = (x, y) => (x < 20 ? 0 : x * y);

const values = (formula: Formula): number[] =>
  Array.from({ length: WIDTH * HEIGHT }, (_, i) => formula(i % WIDTH, Math.floor(i / WIDTH)) + 0);

function expectPicture(picture: FloatPicture, formulas: Record<string, Formula>): void {
  expect([picture.width, picture.height]).toEqual([WIDTH, HEIGHT]);
  expect(picture.channels.map(({ name }) => name)).toEqual(Object.keys(formulas));
  for (const { name, data } of picture.channels)
    expect(Array.from(data, (v) => v + 0)).toEqual(values(formulas[name]!));
}

test('EXR with PIZ, half, from the OpenEXR library', () => {
  const picture = readExr(file('piz-half.exr'));
  expectPicture(picture, { R: red, G: green });
  expect(picture.texts?.comments).toBe('by formula');
});

test('EXR with ZIP, float and half and uint, from the OpenEXR library', () => {
  expectPicture(readExr(file('zip-mixed.exr')), { R: red, G: green, B: blue });
});

test('EXR with RLE and a layer, from the OpenEXR library', () => {
  expectPicture(readExr(file('rle-layer.exr')), { Z: blue, 'albedo.R': blue });
});

const colour: Record<string, Formula> = { R: (x) => x, G: (_, y) => 8 * (y % 4), B: (x) => 255 - x };
const scaled = (scale: number): Record<string, Formula> =>
  Object.fromEntries(Object.entries(colour).map(([name, of]) => [name, (x, y) => Math.fround(of(x, y) / scale)]));

test('HDR with runs, from OpenCV', () => expectPicture(readHdr(file('run-length.hdr')), scaled(16)));

test('PNG, interlaced and of 16 bits, from pypng', () =>
  expectPicture(readPng(file('interlaced-16.png')), scaled(255)));

test('NPZ with half and truth values, from NumPy', () => {
  const npz = readNpz(file('half-and-mask.npz'));
  expect(npz.names).toEqual(['mean', 'mask']);
  expect(npz.read('mean').shape).toEqual([HEIGHT, WIDTH]);
  expect(Array.from(npz.read('mean').data, (v) => v + 0)).toEqual(values(red));
  expect(Array.from(npz.read('mask').data)).toEqual(values((x, y) => (x > y ? 1 : 0)));
});
