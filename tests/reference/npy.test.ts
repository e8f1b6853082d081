import { expect, test } from 'vitest';
import { floatToHalf, halfToFloat, readNpy, writeNpy } from './npy.ts';

test('all 65536 half floats survive', () => {
  const notANumber = (half: number) => (half & 0x7c00) === 0x7c00 && (half & 1023) !== 0;
  const halves = Array.from({ length: 65536 }, (_, half) => half).filter((half) => !notANumber(half));
  expect(halves.filter((half) => floatToHalf(halfToFloat(half)) !== half)).toEqual([]);
});

test('half floats round to the nearest, ties to even', () => {
  const step = 2 ** -10;
  for (const [x, rounded] of [
    [1 + 0.49 * step, 1],
    [1 + 0.5 * step, 1],
    [1 + 1.5 * step, 1 + 2 * step],
    [2 - 0.4 * step, 2],
    [2 ** -25, 0],
    [2 ** -24 * 0.51, 2 ** -24],
    [2 ** -14 - 2 ** -26, 2 ** -14],
    [65519, 65504],
    [65520, Number.POSITIVE_INFINITY],
    [-0.1, -0.0999755859375],
  ])
    expect(halfToFloat(floatToHalf(x!)), String(x)).toBe(rounded);
  expect(halfToFloat(floatToHalf(Number.NaN))).toBeNaN();
});

test.each([16, 32] as const)('an array of %i-bit floats survives', (bits) => {
  const array = { shape: [2, 1, 3], data: Float32Array.of(0, 0.5, -2, 1e-3, 77, 4096) };
  const bytes = writeNpy(array, bits);
  expect((bytes.length - (6 * bits) / 8) % 64).toBe(0);
  const { shape, data } = readNpy(bytes);
  expect(shape).toEqual([2, 1, 3]);
  for (const [i, x] of array.data.entries()) expect(data[i]).toBeCloseTo(x, 6);
});

test('what cannot be read is told', () => {
  const bytes = writeNpy({ shape: [4], data: [1, 2, 3, 4] }, 32);
  expect(() => readNpy(bytes.subarray(0, 140))).toThrow('shorter');
  expect(() => readNpy(bytes.subarray(1))).toThrow('no NPY');
  const doubles = Uint8Array.from(bytes, (b, i) => (String.fromCharCode(b) === '4' && i < 40 ? 56 : b));
  expect(() => readNpy(doubles)).toThrow('<f8');
});
