import { expect, test } from 'vitest';
import { contentOf, tamePicture, wildPicture } from '../../../../tests/fixtures/pictures.ts';
import { createPicture, fromInterleaved } from './float-picture.ts';
import { readChunks } from './png/chunks.ts';
import { readPng, writePng } from './png.ts';

const COLOURS = [['Y'], ['Y', 'A'], ['R', 'G', 'B'], ['R', 'G', 'B', 'A']];

test.each([8, 16] as const)('%i bits: the nearest of the steps, seed 31', (bits) => {
  const most = 2 ** bits - 1;
  for (const names of COLOURS) {
    const picture = tamePicture(31, 7, 6, names);
    const back = readPng(writePng(picture, { bits }));
    const nearest = picture.channels.map(({ name, data }) => ({
      name,
      data: data.map((value) => Math.round(value * most) / most),
    }));
    expect(contentOf(back)).toEqual(contentOf({ ...picture, channels: nearest }));
  }
});

test('values outside are clipped, NaN is 0', () => {
  const picture = fromInterleaved(5, 1, ['Y'], [-1, NaN, Infinity, 1.5, -Infinity]);
  expect(Array.from(readPng(writePng(picture)).channels[0]!.data)).toEqual([0, 0, 1, 1, 0]);
});

test('texts come back; Latin-1 stands in tEXt, the rest in iTXt', () => {
  const texts = { Scene: '{"name": "Übung"}\n', Settings: '场 🪩', Empty: '' };
  const file = writePng({ ...createPicture(1, 1, ['Y']), texts });
  expect({ ...readPng(file).texts }).toEqual(texts);
  expect(readChunks(file).map(({ type }) => type)).toEqual(['IHDR', 'tEXt', 'iTXt', 'tEXt', 'IDAT', 'IEND']);
});

test('channels that PNG cannot hold are refused', () => {
  const layers = wildPicture(32, 1, 1, ['R', 'G', 'B', 'depth.Z']);
  expect(() => writePng(layers)).toThrow(
    'The PNG file to write has the channels R G B depth.Z; expected Y, or Y A, or R G B, or R G B A.',
  );
});

test('damage shows by the check sums', () => {
  const file = writePng(tamePicture(33, 4, 4, ['Y']));
  file[20]! ^= 1;
  expect(() => readPng(file)).toThrow(
    'The PNG chunk IHDR has bytes that do not fit their check sum; expected unchanged bytes.',
  );
});
