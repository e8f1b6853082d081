import { expect, test } from 'vitest';
import type { ImagePixels } from '../../scene/textures.ts';
import { HEIGHT_OF_WHITE, type MadeImage, makeImage, sourcesOf } from './made-images.ts';

function image(width: number, height: number, pixel: (x: number, y: number) => number[]): ImagePixels {
  const rgba = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) rgba.set(pixel(x, y), 4 * (y * width + x));
  return { width, height, rgba };
}
const grey = (value: number, alpha = 255) => [value, value, value, alpha];
const at = ({ width, rgba }: ImagePixels, x: number, y: number) => [
  ...rgba.subarray(4 * (y * width + x), 4 * (y * width + x) + 4),
];
const whole = (file: string, channel: 'r' | 'g' | 'b' | 'l' | 'm' | 'opacity') => ({ file, channel, base: 0, gain: 1 }); // biome-ignore format: row

const heights = (strength: number, clamp = true): MadeImage => ({
  kind: 'normals',
  heights: whole('h', 'l'),
  strength,
  clamp,
});
/** A byte's rounding of each component. */
const expectNormal = (made: number[], normal: [number, number, number]) => {
  const length = Math.hypot(...normal);
  normal.forEach((x, c) => void expect(Math.abs(made[c]! - 127.5 * (1 + x / length))).toBeLessThanOrEqual(0.5));
};

test('a slope of heights leans against its rise, along both axes, as steep as the image is wide', () => {
  const size = 200;
  // A level of grey a pixel: over all of the width white would be reached at 255 pixels.
  const slope = (HEIGHT_OF_WHITE * size) / 255;
  const right = makeImage(heights(40), new Map([['h', image(size, size, (x) => grey(x))]]));
  expectNormal(at(right, 100, 50), [-40 * slope, 0, 1]);
  // Rows go down, the second axis up: what rises with the rows falls along it.
  const down = makeImage(heights(40), new Map([['h', image(size, size, (_, y) => grey(y))]]));
  expectNormal(at(down, 100, 50), [0, 40 * slope, 1]);
  const both = makeImage(heights(-20), new Map([['h', image(size, size, (x, y) => grey(Math.floor((x + y) / 2)))]]));
  expectNormal(at(makeImage(heights(0), new Map([['h', both]])), 100, 50), [0, 0, 1]);
});

test('at its sides an image goes on from the other one, or ends', () => {
  const ramp = new Map([['h', image(100, 4, (x) => grey(2 * x))]]);
  const repeated = makeImage(heights(30, false), ramp);
  const ends = makeImage(heights(30, true), ramp);
  // From 0 the way back leads to 198: a rise of 196 the other way over two pixels.
  expectNormal(at(repeated, 0, 1), [(30 * HEIGHT_OF_WHITE * 100 * 196) / 255 / 2, 0, 1]);
  expectNormal(at(ends, 0, 1), [(-30 * HEIGHT_OF_WHITE * 100 * 2) / 255 / 2, 0, 1]);
});

test('a normal map where heights belong stays one, and the strength bends it', () => {
  const map = image(8, 8, (x) => (x === 3 ? [200, 128, 230, 255] : [128, 128, 255, 255]));
  expect(makeImage(heights(1), new Map([['h', map]])).rgba).toEqual(map.rgba);
  const [x, , z] = [200, 128, 230].map((byte) => byte / 127.5 - 1) as [number, number, number];
  const y = 128 / 127.5 - 1;
  expectNormal(at(makeImage(heights(2), new Map([['h', map]])), 3, 0), [2 * x, 2 * y, z]);
});

test('channels: which one, how bright it is, base and gain, stretched to the size of the largest', () => {
  const images = new Map([
    ['small', image(1, 2, (_, y) => [10, 20, 30, 40 + y])],
    ['large', image(4, 2, (x) => grey(50 * x))],
  ]);
  const made: MadeImage = {
    kind: 'channels',
    red: whole('small', 'g'),
    green: { ...whole('large', 'l'), base: 0.2, gain: 2 },
    alpha: whole('small', 'm'),
  };
  expect(sourcesOf(made)).toEqual(['small', 'large']);
  const result = makeImage(made, images);
  expect([result.width, result.height]).toEqual([4, 2]);
  expect(at(result, 0, 0)).toEqual([20, 51, 255, 40]);
  expect(at(result, 1, 1)).toEqual([20, 151, 255, 41]);
  expect(at(result, 3, 1)).toEqual([20, 255, 255, 41]);
});

test('opacity is the alpha of an image that has some, else how bright it is', () => {
  const made: MadeImage = { kind: 'channels', alpha: whole('a', 'opacity') };
  expect(at(makeImage(made, new Map([['a', image(2, 1, (x) => grey(7, 255 - x))]])), 0, 0)).toEqual([255, 255, 255, 255]);
  expect(at(makeImage(made, new Map([['a', image(2, 1, () => grey(7))]])), 0, 0)).toEqual([255, 255, 255, 7]);
}); // biome-ignore format: rows

test('exponents become roughness, and greys that are looked up as colours those of a screen', () => {
  const source = new Map([['n', image(3, 1, (x) => grey(x * 127.5))]]);
  const rough = makeImage({ kind: 'channels', green: { ...whole('n', 'r'), exponent: 160 } }, source);
  expect(at(rough, 0, 0)[1]).toBe(255);
  expect(at(rough, 2, 0)[1]).toBe(Math.round(255 * (2 / 162) ** 0.25));
  const screen = makeImage({ kind: 'channels', red: { ...whole('n', 'r'), asColor: true } }, source);
  expect([0, 1, 2].map((x) => at(screen, x, 0)[0])).toEqual([0, 187, 255]);
});
