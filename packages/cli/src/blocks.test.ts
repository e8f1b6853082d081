import { expect, test } from 'vitest';
import { blockEnd, blocksIn } from './blocks.ts';

test('blocks of 32 samples, from 256 on of 256', () => {
  const ends = [0, 31, 32, 63, 224, 255, 256, 511, 512, 1000].map(blockEnd);
  expect(ends).toEqual([31, 31, 63, 63, 255, 255, 511, 511, 767, 1023]);
});

test('a block ends where it ends, wherever in it one asks, and the next one begins behind it', () => {
  let end = -1;
  for (let sample = 0; sample < 2048; sample++) {
    if (sample > end) end = blockEnd(sample);
    expect(blockEnd(sample)).toBe(end);
  }
});

test('blocks are counted, whole ones and parts', () => {
  const count = (first: number, last: number) => blocksIn({ first, last });
  expect([count(0, 0), count(0, 31), count(31, 32), count(0, 255), count(0, 256)]).toEqual([1, 1, 2, 8, 9]);
  expect([count(256, 511), count(300, 400), count(255, 512), count(0, 1023)]).toEqual([1, 1, 3, 11]);
});
