import { expect, test } from 'vitest';
import { tamePicture } from '../../../../tests/fixtures/pictures.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { type FloatPicture, fromInterleaved, interleave } from './float-picture.ts';
import { readHdr, writeHdr } from './hdr.ts';

const ascii = (text: string): number[] => [...text].map((letter) => letter.charCodeAt(0));
const HEAD = '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n';
const RGB = ['R', 'G', 'B'];

test('the bytes are these: a narrow line is not packed', () => {
  const picture = fromInterleaved(1, 1, RGB, [1, 0.5, 0]);
  expect(Array.from(writeHdr(picture))).toEqual([...ascii(`${HEAD}-Y 1 +X 1\n`), 128, 64, 0, 129]);
});

test('the bytes are these: runs and single bytes', () => {
  const greys = [1, 1, 1, 1, 1, 1, 1, 0.5, 0.75, 1];
  const line = [2, 2, 0, 10, ...[0, 1, 2].flatMap(() => [136, 128, 2, 192, 128]), 135, 129, 3, 128, 128, 129];
  const picture = fromInterleaved(10, 1, ['Y'], greys);
  expect(Array.from(writeHdr(picture))).toEqual([...ascii(`${HEAD}-Y 1 +X 10\n`), ...line]);
});

/** Each pixel to 1/256 of its largest channel: half a step of the mantissa, which has 7 bits at least. */
function expectClose(picture: FloatPicture, back: FloatPicture): void {
  const [before, after] = [interleave(picture), interleave(back)];
  let worst = 0;
  for (let i = 0; i < before.length; i += 3) {
    const largest = Math.max(before[i]!, before[i + 1]!, before[i + 2]!);
    for (let c = i; c < i + 3; c++) worst = Math.max(worst, Math.abs(before[c]! - after[c]!) / largest);
  }
  expect(worst).toBeLessThanOrEqual(1 / 256);
}

test.each([1, 7, 8, 127, 128, 129, 300])('values keep eight bits, seed 61, width %i', (width) => {
  const random = seededRandom(61);
  const picture = tamePicture(61, width, 3, RGB);
  for (const { data } of picture.channels) {
    for (let i = 0; i < data.length; i++) data[i]! *= 2 ** Math.floor(random() * 8);
    for (let x = 0; x < width; x++) data[width + x] = x < width / 2 ? 0.25 : data[width + x]!; // a long run
    for (let x = 0; x < width; x++) data[2 * width + x]! *= 2 ** 100;
  }
  expectClose(picture, readHdr(writeHdr(picture)));
});

test('the mean of many values is kept, seed 62', () => {
  const picture = tamePicture(62, 100, 100, RGB);
  const mean = (values: Float32Array): number => values.reduce((sum, value) => sum + value, 0) / values.length;
  const relative = mean(interleave(readHdr(writeHdr(picture)))) / mean(interleave(picture)) - 1;
  expect(Math.abs(relative)).toBeLessThan(1e-4);
});

test('what has no place becomes 0 or the largest value, rounding up included', () => {
  const picture = fromInterleaved(7, 1, ['Y'], [-1, NaN, Infinity, 3e38, 2 ** -140, 255.9, 2 ** -127]);
  const largest = 255 * 2 ** 119;
  const red = Array.from(readHdr(writeHdr(picture)).channels[0]!.data);
  expect(red).toEqual([0, 0, largest, largest, 0, 256, 2 ** -127]);
});

test('rows and columns may run either way', () => {
  const pixels = [10, 0, 0, 136, 20, 0, 0, 136, 30, 0, 0, 136, 40, 0, 0, 136];
  const red = (sizes: string): number[] =>
    Array.from(readHdr(Uint8Array.from([...ascii(`${HEAD}${sizes}\n`), ...pixels])).channels[0]!.data);
  expect(red('-Y 2 +X 2')).toEqual([10, 20, 30, 40]);
  expect(red('+Y 2 +X 2')).toEqual([30, 40, 10, 20]);
  expect(red('-Y 2 -X 2')).toEqual([20, 10, 40, 30]);
});

test.each([
  ['#?OTHER\n\n-Y 1 +X 1\n', 'HDR first line'],
  ['#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n', 'another FORMAT'],
  ['#?RGBE\n\n+X 1 -Y 1\n', 'HDR line of sizes'],
  ['#?RGBE\n\n-Y 9999 +X 9999\n', 'HDR pixel data has 0 bytes left'],
  ['#?RGBE\n\n-Y 1 +X 1\n\x01\x01\x01\x05', 'runs of the old kind'],
  ['#?RGBE\n\n-Y 1 +X 8\n\x02\x02\x00\x09'.padEnd(60, '\x08'), 'a line of 9 pixels'],
])('%j is refused', (text, message) => {
  expect(() => readHdr(Uint8Array.from(ascii(text)))).toThrow(message);
});
