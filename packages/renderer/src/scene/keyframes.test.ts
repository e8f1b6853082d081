import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { compileTrack, evaluateTrack } from './keyframes.ts';
import type { Interpolation, Key, Repeat, Vec3 } from './scene.ts';

function sampler(interpolation: Interpolation, repeat: Repeat, keys: readonly (readonly [number, number | Vec3])[]) {
  const track = compileTrack({
    target: '/x',
    interpolation,
    repeat,
    keys: keys.map(([time, value]): Key => ({ time, value })),
  });
  const out = [0, 0, 0];
  return (time: number, component = 0) => {
    evaluateTrack(track, time, out);
    return out[component]!;
  };
}

describe('closed forms', () => {
  test('linear', () => {
    const at = sampler('linear', 'once', [
      [1, 10],
      [3, 20],
    ]);
    expect([0, 1, 1.5, 2, 3, 9].map((t) => at(t))).toEqual([10, 10, 12.5, 15, 20, 20]);
  });
  test('linear, each component of a triple', () => {
    const at = sampler('linear', 'once', [
      [0, [0, 10, -4]],
      [4, [4, 10, 4]],
    ]);
    expect([0, 1, 2].map((c) => at(1, c))).toEqual([1, 10, -2]);
  });
  test('step', () => {
    const at = sampler('step', 'once', [
      [0, 1],
      [1, 2],
      [2, 3],
    ]);
    expect([-1, 0, 0.999, 1, 1.5, 2, 5].map((t) => at(t))).toEqual([1, 1, 1, 2, 2, 3, 3]);
  });
  test('smooth between two keys is 3u² − 2u³', () => {
    for (const repeat of ['once', 'ping-pong'] as const) {
      const at = sampler('smooth', repeat, [
        [0, 0],
        [2, 8],
      ]);
      for (const u of [0, 0.1, 0.25, 0.5, 0.9, 1]) expect(at(2 * u)).toBeCloseTo(8 * (3 * u * u - 2 * u ** 3), 12);
    }
  });
  test('smooth through keys on a line is that line', () => {
    const at = sampler('smooth', 'loop', [
      [0, 0],
      [1, 2],
      [3, 6],
      [4, 8],
    ]);
    for (let t = 0; t < 4; t += 0.13) expect(at(t)).toBeCloseTo(2 * t, 12);
  });
  test('one key holds for ever', () => {
    for (const repeat of ['once', 'loop', 'ping-pong'] as const) {
      const at = sampler('smooth', repeat, [[5, 7]]);
      expect([-1e9, 5, 1e12].map((t) => at(t))).toEqual([7, 7, 7]);
    }
  });
});

describe('repeating', () => {
  test('loop, before the first key and far away', () => {
    const at = sampler('linear', 'loop', [
      [1, 0],
      [5, 4],
    ]);
    expect([1, 2, 5, 6, 0, -3, -2, 1 + 4e12, 2.5 + 4e12].map((t) => at(t))).toEqual([0, 1, 0, 1, 3, 0, 1, 0, 1.5]);
  });
  test('ping-pong, before the first key and far away', () => {
    const at = sampler('linear', 'ping-pong', [
      [1, 0],
      [5, 4],
    ]);
    expect([1, 4, 5, 6, 9, 10, 0, -3, 1 + 8e12, 5 + 8e12].map((t) => at(t))).toEqual([0, 3, 4, 3, 0, 1, 1, 4, 0, 4]);
  });
  test('ping-pong is mirrored in both of its ends', () => {
    const at = sampler('smooth', 'ping-pong', [
      [0, 0],
      [1, 5],
      [3, 2],
    ]);
    for (let t = 0; t < 3; t += 0.17) {
      expect(at(-t)).toBeCloseTo(at(t), 12);
      expect(at(3 + t)).toBeCloseTo(at(3 - t), 12);
    }
  });
});

const SEEDS = Array.from({ length: 40 }, (_, seed) => seed);
const INTERPOLATIONS: readonly Interpolation[] = ['step', 'linear', 'smooth'];
const REPEATS: readonly Repeat[] = ['once', 'loop', 'ping-pong'];

function randomKeys(seed: number, closed: boolean): [number, number][] {
  const random = seededRandom(seed);
  let time = 20 * random() - 10;
  const keys = Array.from({ length: 2 + Math.floor(8 * random()) }, (): [number, number] => {
    time += 0.01 + 3 * random() ** 3;
    return [time, Math.round(6 * random()) * 10 ** Math.floor(8 * random() - 4)];
  });
  if (closed) keys.push([time + 1, keys[0]![1]]);
  return keys;
}

describe.each(SEEDS)('random keys, seed %i', (seed) => {
  test('values stay between their two keys, and smooth is monotone there', () => {
    const keys = randomKeys(seed, seed % 2 === 0);
    for (const interpolation of INTERPOLATIONS) {
      for (const repeat of REPEATS) {
        const at = sampler(interpolation, repeat, keys);
        for (let k = 1; k < keys.length; k++) expectMonotone(at, keys[k - 1]!, keys[k]!);
      }
    }
  });

  test('smooth has no kink and no jump at any key, also where it repeats', () => {
    const keys = randomKeys(seed, true);
    const [start, end] = [keys[0]![0], keys.at(-1)![0]];
    for (const repeat of REPEATS) {
      const at = sampler('smooth', repeat, keys);
      for (const time of [...keys.map(([t]) => t), 2 * end - start]) expectSmooth(at, time, keys);
    }
  });
});

function expectMonotone(at: (t: number) => number, [t0, a]: [number, number], [t1, b]: [number, number]) {
  let before = a;
  for (let i = 1; i < 50; i++) {
    const value = at(t0 + ((t1 - t0) * i) / 50);
    const outside = value < Math.min(a, b) || value > Math.max(a, b);
    const turnsBack = (value - before) * Math.sign(b - a) < -1e-12 * Math.abs(b - a);
    if (outside || turnsBack) expect.fail(`${value} after ${before}, between ${a} and ${b}`);
    before = value;
  }
}

/** Slopes left and right of a time agree as far as the curvature, at most about 12 ranges per (0.01 s)², allows. */
function expectSmooth(at: (t: number) => number, time: number, keys: readonly [number, number][]) {
  const values = keys.map(([, value]) => value);
  const range = Math.max(...values) - Math.min(...values);
  const h = 1e-6;
  const left = (at(time) - at(time - h)) / h;
  const right = (at(time + h) - at(time)) / h;
  expect(Math.abs(left - right)).toBeLessThanOrEqual((h * 24 * range) / 0.01 ** 2 + (range * 1e-13) / h + 1e-6);
}
