import { expect, test } from 'vitest';
import { anyFloat } from '../../../../tests/fixtures/pictures.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { floatToHalf, halfTable, halfToFloat } from './half.ts';

/** Of all finite halves the nearest, of two the one whose last bit is 0; 65536 stands for infinity as the next would be. */
function slowHalf(value: number): number {
  const sign = value < 0 || Object.is(value, -0) ? 0x8000 : 0;
  const amount = Math.abs(value);
  const at = (half: number): number => (half === 0x7c00 ? 65536 : halfToFloat(half));
  let [low, high] = [0, 0x7c00];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (at(middle) <= amount) low = middle;
    else high = middle;
  }
  const [below, above] = [amount - at(low), at(high) - amount];
  return sign | (below < above || (below === above && low % 2 === 0) ? low : high);
}

test('halves are what the standard says', () => {
  expect([0, 1, 0x3ff, 0x400, 0x3c00, 0x7bff, 0x7c00, 0xfc00, 0xc000].map(halfToFloat)).toEqual([
    ...[0, 2 ** -24, 1023 * 2 ** -24, 2 ** -14, 1, 65504, Infinity, -Infinity, -2],
  ]);
  expect(halfToFloat(0x8000)).toBe(-0);
  expect(halfToFloat(0x7c01)).toBeNaN();
});

test('every half becomes itself again; NaN stays NaN', () => {
  const table = halfTable();
  const wrong: number[] = [];
  for (let half = 0; half < 65536; half++) {
    const back = floatToHalf(table[half]!);
    if (Number.isNaN(table[half]) ? !Number.isNaN(halfToFloat(back)) : back !== half) wrong.push(half);
  }
  expect(wrong).toEqual([]);
});

test('between two halves the nearest is taken, in the middle the even one', () => {
  const wrong: number[] = [];
  const check = (value: number): void => {
    const float = Math.fround(value);
    if (floatToHalf(float) !== slowHalf(float)) wrong.push(float);
  };
  for (let half = 0; half < 0x7c00; half++) {
    const next = half === 0x7bff ? 65536 : halfToFloat(half + 1);
    const middle = (halfToFloat(half) + next) / 2;
    for (const value of [middle, middle * (1 + 2 ** -23), middle * (1 - 2 ** -23)]) {
      check(value);
      check(-value);
    }
  }
  expect(wrong).toEqual([]);
});

test('any floats round as the slow search does, seed 21', () => {
  const random = seededRandom(21);
  const wrong: number[] = [];
  for (let i = 0; i < 20000; i++) {
    const value = i % 2 ? anyFloat(random) : Math.fround((random() - 0.5) * 2 ** (20 - random() * 50));
    if (Number.isNaN(value) ? !Number.isNaN(halfToFloat(floatToHalf(value))) : floatToHalf(value) !== slowHalf(value))
      wrong.push(value);
  }
  expect(wrong).toEqual([]);
});
