import { expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import { blockEnd } from './blocks.ts';
import type { FilmIdentity } from './film-identity.ts';
import type { Part } from './part-file.ts';
import { errorOf, isEven, onePart, tilesOf } from './tiles.ts';

const identity: FilmIdentity = {
  scene: 'a',
  time: 0,
  width: 4,
  height: 2,
  region: [0, 0, 4, 2],
  integrator: 'path',
  seed: 0,
  settings: { maxDepth: -1 },
};

/** Each sample of pixel (x, y) is 10 y + x, and a little more in every other block. */
function value(x: number, y: number, first: number): number {
  return 10 * y + x + (first % 64 === 0 ? 0.5 : 0);
}

function aPart(region: FilmIdentity['region'], first = 0, last = 63, more: Partial<FilmIdentity> = {}): Part {
  const [left, top, width, height] = region;
  const film = new AccumulatedFilm(width * height);
  for (let at = first; at <= last; at = blockEnd(at) + 1) {
    const count = Math.min(blockEnd(at), last) - at + 1;
    const sums = new Float32Array(width * height * 4);
    for (let i = 0; i < width * height; i++) {
      const each = value(left + (i % width), top + Math.floor(i / width), at);
      sums.set([each * count, each * count, each * count, count], i * 4);
    }
    film.put(at, sums);
  }
  film.close();
  return { identity: { ...identity, ...more, region }, film, texts: {}, exposure: 0 };
}

const named = (...parts: Part[]) => parts.map((part, i) => ({ file: `${i}.part`, part }));

test('regions that cover the picture make one part of it, that of a run of the whole picture', () => {
  const tiles = tilesOf(
    named(aPart([2, 0, 2, 2]), aPart([0, 1, 2, 1], 32), aPart([0, 0, 2, 1]), aPart([0, 1, 2, 1], 0, 31)),
  );
  expect(tiles.map(({ part }) => part.identity.region)).toEqual([
    [0, 0, 2, 1],
    [2, 0, 2, 2],
    [0, 1, 2, 1],
  ]);
  expect(isEven(tiles)).toBe(true);
  const whole = aPart([0, 0, 4, 2]);
  const one = onePart(tiles);
  expect(one.identity).toEqual(identity);
  expect(one.film.closed).toEqual(whole.film.closed);
  expect(errorOf(tiles)).toBeCloseTo(whole.film.error()!, 12);
});

test('the same pixels in regions that are not the same are refused, with the same samples or others', () => {
  for (const first of [0, 64])
    expect(() => tilesOf(named(aPart([0, 0, 3, 2]), aPart([2, 0, 2, 2], first, first + 63)))).toThrow(
      '1.part and 0.part hold some of the same pixels: their regions 2,0,2,2 and 0,0,3,2 must be the same',
    );
});

test('the same samples of a region are refused, of two regions they are not', () => {
  expect(() => tilesOf(named(aPart([0, 0, 2, 2]), aPart([2, 0, 2, 2]), aPart([0, 0, 2, 2], 32, 95)))).toThrow(
    '2.part holds samples 32-63, which another part holds too.',
  );
});

test('regions of another picture are refused', () => {
  expect(() => tilesOf(named(aPart([0, 0, 2, 2]), aPart([2, 0, 2, 2], 0, 63, { seed: 3 })))).toThrow(
    '1.part and 0.part are of different pictures: seed 3 instead of 0.',
  );
});

test('a part file needs the same samples of all regions, cut into the same blocks', () => {
  const uneven = tilesOf(named(aPart([0, 0, 2, 2]), aPart([2, 0, 2, 2], 0, 95)));
  expect(isEven(uneven)).toBe(false);
  expect(() => onePart(uneven)).toThrow(
    'the region 0,0,2,2 has samples 0-63 in 2 blocks, the region 2,0,2,2 samples 0-95 in 3 blocks.',
  );
  const cut = tilesOf(named(aPart([0, 0, 2, 2]), aPart([2, 0, 2, 2], 0, 9), aPart([2, 0, 2, 2], 10, 63)));
  expect(isEven(cut)).toBe(true);
  expect(() => onePart(cut)).toThrow('samples 0-63 in 3 blocks');
});
