import { expect, test } from 'vitest';
import { contentOf, wildPicture } from '../../../../tests/fixtures/pictures.ts';
import { readExr, writeExr } from './exr.ts';
import { createPicture, type FloatPicture, layersOf, pickLayer } from './float-picture.ts';
import { floatToHalf, halfToFloat } from './half.ts';

const LAYERS = ['R', 'G', 'B', 'A', 'albedo.R', 'albedo.G', 'albedo.B', 'depth.Z'];

/** One pixel, one float channel "Y", nothing packed. */
const smallest = (): number[] => {
  const text = (name: string): number[] => [...name].map((letter) => letter.charCodeAt(0)).concat(0);
  const attribute = (name: string, type: string, value: number[]): number[] => [
    ...text(name),
    ...text(type),
    ...[value.length, 0, 0, 0],
    ...value,
  ];
  const head = [
    ...[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0],
    ...attribute('channels', 'chlist', [...text('Y'), 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0]),
    ...attribute('compression', 'compression', [0]),
    ...attribute('dataWindow', 'box2i', [...[5, 0, 0, 0, 254, 255, 255, 255], ...[5, 0, 0, 0, 254, 255, 255, 255]]),
    0,
  ];
  const block = [254, 255, 255, 255, 4, 0, 0, 0, 0, 0, 0x20, 0xc1]; // line −2, four bytes, −10
  return [...head, head.length + 8, 0, 0, 0, 0, 0, 0, 0, ...block];
};

test('a file made by hand, whose first pixel is not 0, 0', () => {
  const picture = readExr(Uint8Array.from(smallest()));
  expect(contentOf(picture)).toEqual({ width: 1, height: 1, channels: [{ name: 'Y', data: [-10] }] });
});

test.each([
  [1, 1, 1],
  [2, 5, 16],
  [3, 33, 17],
  [4, 3, 50],
])('floats of all kinds come back as they were, seed %i, %i × %i', (seed, width, height) => {
  const picture = wildPicture(seed, width, height, LAYERS);
  expect(contentOf(readExr(writeExr(picture)))).toEqual(contentOf(picture));
});

test('halves come back rounded, and the depth in full, seed 5', () => {
  const picture = wildPicture(5, 20, 19, LAYERS);
  const half = (name: string): boolean => name !== 'depth.Z';
  const rounded: FloatPicture = {
    ...picture,
    channels: picture.channels.map(({ name, data }) => ({
      name,
      data: half(name) ? data.map((value) => halfToFloat(floatToHalf(value))) : data,
    })),
  };
  expect(contentOf(readExr(writeExr(picture, { half })))).toEqual(contentOf(rounded));
});

test('texts of any kind come back, also under long names', () => {
  const texts = { scene: '{"name":"Übung 场 🪩"}', settings: '', [`a${'b'.repeat(254)}`]: 'x'.repeat(100000) };
  const picture = { ...createPicture(2, 2, ['Y', `${'long'.repeat(20)}.R`]), texts };
  const back = readExr(writeExr(picture));
  expect({ ...back.texts }).toEqual(texts);
  expect(back.channels.map(({ name }) => name)).toEqual(['Y', `${'long'.repeat(20)}.R`].sort());
});

test('layers can be told apart and taken out', () => {
  const picture = readExr(writeExr(wildPicture(6, 2, 2, LAYERS)));
  expect(layersOf(picture)).toEqual(['', 'albedo', 'depth']);
  expect(pickLayer(picture, 'albedo').channels.map(({ name }) => name)).toEqual(['R', 'G', 'B']);
  expect(pickLayer(picture, '').channels.map(({ name }) => name)).toEqual(['R', 'G', 'B', 'A']);
});

test('what the format cannot hold is refused', () => {
  const twice = { ...createPicture(1, 1, ['Y', 'Y']) };
  expect(() => writeExr(twice)).toThrow('two channels Y');
  expect(() => writeExr(createPicture(1, 1, ['']))).toThrow('names of 1 to 255 bytes');
  expect(() => writeExr({ ...createPicture(1, 1, ['Y']), texts: { dataWindow: '' } })).toThrow('dataWindow');
});

test.each([
  [0x200, 'tiles'],
  [0x800, 'deep pixels'],
  [0x1000, 'more than one part'],
])('flag %i is refused by name', (flag, kind) => {
  const bytes = Uint8Array.from(smallest());
  bytes[5] = flag >> 8;
  expect(() => readExr(bytes)).toThrow(`The EXR file has ${kind}; expected scan lines of flat pixels in one part.`);
});

test('a small file cannot ask for a large picture', () => {
  const bytes = Uint8Array.from(smallest());
  const window = bytes.length - 21 - 16;
  new DataView(bytes.buffer).setInt32(window + 8, 9000, true);
  expect(() => readExr(bytes)).toThrow('EXR block has 4 bytes for lines of');
  new DataView(bytes.buffer).setInt32(window + 12, 9000, true);
  expect(() => readExr(bytes)).toThrow('EXR table of blocks has 20 bytes left');
  new DataView(bytes.buffer).setInt32(window + 12, 2 ** 31 - 1, true);
  expect(() => readExr(bytes)).toThrow('1 to 65536 pixels a side');
});
