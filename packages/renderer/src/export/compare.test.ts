import { expect, test } from 'vitest';
import { type Random, seededRandom } from '../../../../tests/fixtures/random.ts';
import { comparePictures } from './compare.ts';
import { createPicture, type FloatPicture } from './float-picture.ts';

const RGB = ['R', 'G', 'B'];
type Value = (c: number, x: number, y: number) => number;

function make(value: Value, width = 64, height = 48): FloatPicture {
  const picture = createPicture(width, height, RGB);
  picture.channels.forEach(({ data }, c) => {
    for (let i = 0; i < data.length; i++) data[i] = value(c, i % width, Math.floor(i / width));
  });
  return picture;
}

/** Box and Muller's. */
const normal = (random: Random): number => Math.sqrt(-2 * Math.log(1 - random())) * Math.cos(2 * Math.PI * random());

test('the same picture is at no distance', () => {
  const mean = make((c, x, y) => c + x + y);
  const result = comparePictures({ mean }, { mean });
  expect(result).toMatchObject({ relMse: 0, mae: 0, rmsZ: 0, flaggedBlocks: 0, bias: [0, 0, 0, 0], pixels: 64 * 48 });
  expect(result.blocks).toHaveLength(12);
});

test('relMSE, MAE and bias of flat pictures are their formulas', () => {
  const result = comparePictures({ mean: make((c) => [1.5, 2, 0.5][c]!) }, { mean: make((c) => [1, 2, 1][c]!) });
  expect(result.relMse).toBeCloseTo((0.25 / 1.01 + 0 + 0.25 / 1.01) / 3, 12);
  expect(result.trimmedRelMse).toBeCloseTo(result.relMse, 12);
  expect(result.mae).toBeCloseTo(1 / 3, 12);
  const luminance = (0.5 * 0.2126 - 0.5 * 0.0722) / (0.2126 + 2 * 0.7152 + 0.0722);
  [0.5, 0, -0.5, luminance].forEach((bias, c) => {
    expect(result.bias[c]).toBeCloseTo(bias, 12);
  });
});

test('the worst thousandth of the pixels can be left out', () => {
  const result = comparePictures({ mean: make((_, x, y) => (x + y === 0 ? 101 : 1)) }, { mean: make(() => 1) });
  expect(result.relMse).toBeCloseTo(10000 / 1.01 / (64 * 48), 9);
  expect(result.trimmedRelMse).toBe(0);
});

test('the reference has a share in relMSE, and it is named', () => {
  const reference = { mean: make(() => 2), standardError: make(() => 0.1) };
  expect(comparePictures({ mean: make(() => 2) }, reference).relMseFloor).toBeCloseTo(0.01 / 4.01, 7);
});

test('known errors of both join: z is difference / √(se² + se²), over the root of the pixels', () => {
  const a = { mean: make(() => 1.1), standardError: make(() => 0.3) };
  const reference = { mean: make(() => 1), standardError: make(() => 0.4) };
  const { blocks, beyond3, beyond6, worstZ, bias, biasError } = comparePictures(a, reference);
  for (const { z } of blocks) expect(z[0]).toBeCloseTo(0.1 / (0.5 / 16), 5);
  expect([beyond3, beyond6]).toEqual([1, 0]);
  expect(worstZ).toBeCloseTo(3.2, 5);
  expect(bias[1]).toBeCloseTo(0.1, 6);
  expect(biasError[1]).toBeCloseTo(0.5 / Math.sqrt(64 * 48), 6);
});

const noisy = (seed: number, shift: Value = () => 0): FloatPicture => {
  const random = seededRandom(seed);
  return make((c, x, y) => 1 + 0.2 * normal(random) + shift(c, x, y), 256, 256);
};
const known = make(() => 0.2, 256, 256);

test('equal pictures with independent noise: z has variance 1, with known errors and with measured ones, seeds 91 and 92', () => {
  const [a, r] = [noisy(91), noisy(92)];
  for (const result of [
    comparePictures({ mean: a, standardError: known }, { mean: r, standardError: known }),
    comparePictures({ mean: a }, { mean: r }),
  ]) {
    // Luminance counts its channels' errors as if they were one, so its known error is too large.
    const z = result.blocks.flatMap((block) => block.z.slice(0, 3));
    const variance = z.reduce((sum, value) => sum + value * value, 0) / z.length;
    expect(Math.abs(variance - 1)).toBeLessThan(5 * Math.sqrt(2 / z.length));
    expect(Math.abs(result.bias[1] / result.biasError[1])).toBeLessThan(4);
    expect(result.beyond6).toBe(0);
  }
});

test('one block that is off is found where it is, seeds 93 and 94', () => {
  const shifted = noisy(93, (_, x, y) => (x >= 32 && x < 48 && y >= 64 && y < 80 ? 0.2 : 0));
  const { blocks } = comparePictures({ mean: shifted }, { mean: noisy(94) });
  const worst = blocks.reduce((most, block) => (block.z[3] > most.z[3] ? block : most));
  expect(worst).toMatchObject({ x: 32, y: 64, flagged: true });
  expect(worst.relative[1]).toBeGreaterThan(0.1);
});

test('a smooth difference inside a block counts as difference and not as noise', () => {
  const { blocks } = comparePictures({ mean: make((_, x, y) => 1 + x / 100 + y / 200) }, { mean: make(() => 1) });
  for (const { error } of blocks) expect(error[0]).toBeLessThan(1e-7);
});

test('pixels with NaN or infinity are counted and black; negative ones are counted', () => {
  const mean = make((c, x) => (x === 0 && c === 1 ? NaN : x === 1 ? -1 : x === 2 ? Infinity : 1));
  const result = comparePictures({ mean }, { mean: make(() => 1) });
  expect(result).toMatchObject({ nonFinitePixels: 96, negativePixels: 48 });
  expect(result.mae).toBeCloseTo((2 + 2) / 64, 12);
});

test('a mask takes pixels out, and blocks with less than half of theirs', () => {
  const mask = Array.from({ length: 64 * 48 }, (_, i) => (i % 64 >= 25 ? 1 : 0));
  const mean = make((_, x) => (x < 25 ? 9 : 1));
  const result = comparePictures({ mean }, { mean: make(() => 1) }, { mask });
  expect(result).toMatchObject({ pixels: 39 * 48, relMse: 0, mae: 0 });
  expect(result.blocks).toHaveLength(2 * 3);
});

test('grey pictures, small ones, and ones that do not fit', () => {
  const grey = createPicture(5, 4, ['Y']);
  expect(comparePictures({ mean: grey }, { mean: grey }).blocks).toHaveLength(1);
  expect(() => comparePictures({ mean: grey }, { mean: make(() => 1) })).toThrow('5 × 4 pixels; expected 64 × 48');
  expect(() => comparePictures({ mean: createPicture(5, 4, ['U', 'V']) }, { mean: grey })).toThrow('the channels U V');
});
