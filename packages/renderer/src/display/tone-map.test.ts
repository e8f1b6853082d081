import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Color } from '../scene/scene.ts';
import { TONE_MAPPINGS } from '../scene/tone-mappings.ts';
import { agxCurve, toneMap } from './tone-map.ts';

const grey = (v: number): Color => [v, v, v];
const closeTo = (color: Color, expected: readonly number[], digits = 3) =>
  color.forEach((value, c) => {
    expect(value).toBeCloseTo(expected[c]!, digits);
  });
/** 0.0001 … 10,000 in steps of a tenth of a stop. */
const ladder = Array.from({ length: 266 }, (_, i) => 1e-4 * 2 ** (i / 10));

describe.each(TONE_MAPPINGS)('%s', (kind) => {
  test('black stays black, and brighter grey is never darker', () => {
    closeTo(toneMap([0, 0, 0], kind), [0, 0, 0]);
    const luminances = ladder.map((v) => toneMap(grey(v), kind)[1]);
    for (let i = 1; i < luminances.length; i++)
      expect(luminances[i]! - luminances[i - 1]!).toBeGreaterThanOrEqual(-1e-9);
  });

  test('grey stays grey to a two-thousandth, and very bright light is white', () => {
    for (const v of ladder) {
      const mapped = toneMap(grey(v), kind);
      expect(Math.max(...mapped) - Math.min(...mapped)).toBeLessThan(5e-4);
    }
    for (const v of [1e4, 1e9, Number.POSITIVE_INFINITY]) closeTo(toneMap(grey(v), kind), [1, 1, 1], 2);
  });

  test('all colours come out within 0 … 1 (seed 71)', () => {
    const random = seededRandom(71);
    for (let k = 0; k < 2000; k++) {
      const some = () => (random() < 0.1 ? -random() : 2 ** (30 * random() - 14));
      for (const value of toneMap([some(), some(), some()], kind)) {
        expect(value).toBeGreaterThanOrEqual(0);
        expect(value).toBeLessThanOrEqual(1);
      }
    }
  });
});

test('none clips and does nothing else', () => {
  expect(toneMap([0.3, 1.2, -1], 'none')).toEqual([0.3, 1, 0]);
});

// Worked out apart from this code: matrices row by row, those that are inverses inverted from the published ones.
test.each<[Color, Color, Color]>([
  [
    [0.18, 0.18, 0.18],
    [0.2131, 0.2131, 0.2131],
    [0.2145, 0.2145, 0.2145],
  ],
  [
    [1, 1, 1],
    [0.7634, 0.7634, 0.7634],
    [0.5902, 0.5902, 0.5901],
  ],
  [
    [1, 0, 0],
    [0.9573, 0.0053, 0.0072],
    [0.7233, 0.1059, 0.0668],
  ],
  [
    [0.05, 0.2, 0.8],
    [0.0677, 0.2459, 0.6995],
    [0.1159, 0.2841, 0.5913],
  ],
  [
    [16, 4, 0.5],
    [1, 0.9614, 0.8242],
    [1, 0.8816, 0.7339],
  ],
])('ACES and AgX of %j', (color, aces, agx) => {
  closeTo(toneMap(color, 'aces'), aces);
  closeTo(toneMap(color, 'agx'), agx);
});

test('the polynomial of AgX is its sigmoid: slope 2 and powers 3 about (10 / 16.5, 0.5)', () => {
  const [pivotX, pivotY, slope, power] = [10 / 16.5, 0.5, 2, 3];
  /** Sobotka's: a hyperbola whose scale makes it end in the corner (reachX, reachY) from the pivot. */
  const branch = (distance: number, reachX: number, reachY: number): number => {
    const scale = ((slope * reachX) ** -power * (((slope * reachX) / reachY) ** power - 1)) ** (-1 / power);
    const t = (slope * distance) / scale;
    return (scale * t) / (1 + t ** power) ** (1 / power);
  };
  for (let i = 0; i <= 100; i++) {
    const x = i / 100;
    const y =
      x < pivotX ? pivotY - branch(pivotX - x, pivotX, pivotY) : pivotY + branch(x - pivotX, 1 - pivotX, 1 - pivotY);
    expect(Math.abs(agxCurve(x) - y), `at ${x}`).toBeLessThan(0.006);
  }
});

describe('Khronos PBR Neutral', () => {
  test('between 0.08 and 0.8 it takes 0.04 away, and nothing else', () => {
    for (const v of [0.08, 0.18, 0.5, 0.76, 0.8]) closeTo(toneMap(grey(v), 'neutral'), grey(v - 0.04), 12);
    closeTo(toneMap([0.1, 0.5, 0.8], 'neutral'), [0.06, 0.46, 0.76], 12);
  });

  test('it can be undone: the inverse of its specification', () => {
    // Of grey: f undone by the root of its parabola, the peak by 1 − 0.24² / (1 − p) … no desaturation shows in grey.
    for (const v of ladder.filter((value) => value < 1000)) {
      const [p] = toneMap(grey(v), 'neutral');
      const peak = p <= 0.76 ? p : 0.24 ** 2 / (1 - p) - 1 + 2 * 0.76;
      const back = peak < 0.04 ? 2 * Math.sqrt(0.04 * peak) : peak + 0.04;
      expect(back / v).toBeCloseTo(1, 6);
    }
  });

  test('no hue shifts: the angle about the axis of greys is kept (seed 72)', () => {
    const random = seededRandom(72);
    const hue = ([r, g, b]: Color) => Math.atan2(Math.sqrt(3) * (g - b), 2 * r - g - b);
    for (let k = 0; k < 500; k++) {
      const color: Color = [random(), random(), random()].map((u) => u * 2 ** (6 * random())) as unknown as Color;
      const turn = hue(toneMap(color, 'neutral')) - hue(color);
      expect(Math.abs(Math.sin(turn / 2))).toBeLessThan(1e-6);
    }
  });

  test('it is smooth where the compression begins', () => {
    const slope = (v: number) => (toneMap(grey(v + 1e-6), 'neutral')[0] - toneMap(grey(v), 'neutral')[0]) / 1e-6;
    expect(slope(0.8 - 1e-4)).toBeCloseTo(1, 3);
    expect(slope(0.8 + 1e-4)).toBeCloseTo(1, 2);
  });
});
