import { expect, test } from 'vitest';
import { seededRandom } from '../../../tests/fixtures/random.ts';
import { countOf, formatRanges, joinRanges, missingFrom, overlap, type SampleRange } from './sample-ranges.ts';

const r = (first: number, last: number): SampleRange => ({ first, last });

test('neighbours are joined, gaps stay, and the order of the parts does not matter', () => {
  expect(joinRanges([r(0, 3), r(8, 9)], [r(4, 5)])).toEqual([r(0, 5), r(8, 9)]);
  expect(joinRanges([r(4, 5)], [r(0, 3)])).toEqual([r(0, 5)]);
});

test('a sample that is there twice is refused, and named', () => {
  expect(overlap([r(0, 3), r(8, 12)], [r(4, 9)])).toEqual(r(8, 9));
  expect(() => joinRanges([r(0, 3)], [r(3, 3)])).toThrow('Samples 3 are there twice.');
});

test('what is missing and what is held make up what is wanted (seed 1)', () => {
  const random = seededRandom(1);
  const whole = (n: number) => Math.floor(random() * n);
  for (let k = 0; k < 200; k++) {
    const held = joinRanges([r(whole(5), 5 + whole(5))], [r(11 + whole(3), 14 + whole(9))]);
    const wanted = r(whole(20), 20 + whole(10));
    const all = new Set(Array.from({ length: wanted.last - wanted.first + 1 }, (_, i) => wanted.first + i));
    for (const { first, last } of held) for (let s = first; s <= last; s++) all.delete(s);
    const missing = missingFrom(wanted, held);
    expect(missing.flatMap(({ first, last }) => Array.from({ length: last - first + 1 }, (_, i) => first + i))).toEqual(
      [...all],
    );
    expect(countOf(missing)).toBe(all.size);
  }
});

test('as people read them', () => {
  expect(formatRanges([])).toBe('none');
  expect(formatRanges([r(0, 63), r(70, 70)])).toBe('0-63, 70');
});
