import { expect, test } from 'vitest';
import { AccumulatedFilm } from './accumulated-film.ts';
import type { FilmIdentity } from './film-identity.ts';
import type { Part } from './part-file.ts';
import { readRenderText, renderText } from './render-text.ts';

const settings = { maxDepth: 5 };
const identity = { scene: 'a', time: 0.1, width: 4, height: 3, region: [0, 0, 4, 3], integrator: 'path', seed: 7, settings } as const; // biome-ignore format: one thing
const whole = { x: 0, y: 0, width: 4, height: 3 };

/** A film of these pixels with so many samples, some brighter than others. */
function part(region: FilmIdentity['region'], samples: number): Part {
  const pixels = region[2] * region[3];
  const film = new AccumulatedFilm(pixels);
  for (let first = 0; first < samples; first += 32) {
    const count = Math.min(32, samples - first);
    film.put(
      first,
      Float32Array.from({ length: pixels * 4 }, (_, i) => (i % 4 === 3 ? count : first + i)),
    );
  }
  return { identity: { ...identity, region }, film, texts: {}, exposure: 0 };
}

test('says of a picture what it is of and how far it has come, and is read again', () => {
  const film = part([0, 0, 4, 3], 64);
  const facts = readRenderText(renderText([film], whole, { exposure: -1.5 }));
  expect(facts).toEqual({
    identity,
    ranges: [[{ first: 0, last: 63 }]],
    whole: true,
    error: film.film.error(),
    look: { exposure: -1.5 },
  });
  expect(facts!.error).toBeGreaterThan(0);
  expect(readRenderText(renderText([part([0, 0, 4, 3], 8)], whole, null))).toMatchObject({ error: null, look: null });
});

test('says so where regions have other samples, and where pixels are in none', () => {
  const [top, bottom] = [part([0, 0, 4, 2], 40), part([0, 2, 4, 1], 8)];
  const ranges = [[{ first: 0, last: 39 }], [{ first: 0, last: 7 }]];
  expect(readRenderText(renderText([top, bottom], whole, null))).toMatchObject({ identity, ranges, whole: true });
  expect(readRenderText(renderText([top], whole, null))).toMatchObject({ ranges: [ranges[0]], whole: false });
});

test.each([
  [undefined],
  [''],
  ['null'],
  ['{"scene":"a"}'],
  [JSON.stringify({ ...identity, samples: '5-3' })],
  [JSON.stringify({ ...identity, region: [0, 0, 5, 3], samples: '0-3' })],
  [JSON.stringify({ ...identity, regions: [] })],
])('%s is no text of ours', (text) => {
  expect(readRenderText(text)).toBe(null);
});
