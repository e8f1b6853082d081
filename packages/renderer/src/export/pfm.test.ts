import { expect, test } from 'vitest';
import { contentOf, wildPicture } from '../../../../tests/fixtures/pictures.ts';
import { fromInterleaved } from './float-picture.ts';
import { readPfm, writePfm } from './pfm.ts';

const ascii = (text: string): number[] => [...text].map((letter) => letter.charCodeAt(0));

test('the bytes are these: bottom row first, little endian', () => {
  const picture = fromInterleaved(1, 2, ['Y'], [1, -2]);
  expect(Array.from(writePfm(picture))).toEqual([...ascii('Pf\n1 2\n-1.0\n'), 0, 0, 0, 0xc0, 0, 0, 0x80, 0x3f]);
});

test('big endian with a scale of 2', () => {
  const bytes = Uint8Array.from([...ascii('Pf\n1 2\n2\n'), 0xc0, 0, 0, 0, 0x3f, 0x80, 0, 0]);
  expect(contentOf(readPfm(bytes))).toEqual({ width: 1, height: 2, channels: [{ name: 'Y', data: [2, -4] }] });
});

test.each([['R', 'G', 'B'], ['Y']])('floats of all kinds come back as they were, seed 41 (%s …)', (...names) => {
  const picture = wildPicture(41, 9, 6, names);
  expect(contentOf(readPfm(writePfm(picture)))).toEqual(contentOf(picture));
});

test.each([
  ['P6\n1 1\n-1\n', 'PFM first line'],
  ['PF\n1 x\n-1\n', 'PFM line of sizes'],
  ['PF\n1 99999\n-1\n', '1 to 65536 pixels a side'],
  ['PF\n60000 60000\n-1\n', 'at most 536870912 values'],
  ['PF\n6000 6000\n-1\n', 'The PFM pixel data has 0 bytes left; expected the 432000000 bytes that it needs.'],
  ['PF\n1 1\n0\n', 'PFM line of the scale'],
  [`PF\n${'1'.repeat(100)}`, 'a text without end'],
])('%j is refused', (text, message) => {
  expect(() => readPfm(Uint8Array.from(ascii(text)))).toThrow(message);
});
