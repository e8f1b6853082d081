import { describe, expect, test } from 'vitest';
import { between, seededRandom } from '../../../tests/fixtures/random.ts';
import { FrameFigures } from './frame-figures.ts';

const RAYS = 100 * 100 * 50;
const frame = (started: number, finished: number) => ({
  started,
  finished,
  samples: 1,
  record: { busy: 0, relativeError: null },
  raysPerPixel: 50,
  filmWidth: 100,
  filmHeight: 100,
  canvasWidth: 100,
  canvasHeight: 100,
  time: 0,
});
const figures = () => new FrameFigures('webgl2', { width: 100, height: 100 });

test('frames one after the other', () => {
  const count = figures();
  for (let k = 0; k < 100; k++) count.count(frame(1000 + 20 * k, 1010 + 20 * k));
  expect(count.stats.fps).toBeCloseTo(50, 0);
  expect(count.stats.frameMs).toBeCloseTo(10, 9);
  expect(count.stats.mraysPerSecond).toBeCloseTo(RAYS / 10 / 1000, 9);
});

test('frames of which one hears in pairs are not done in no time', () => {
  const count = figures();
  for (let k = 0; k < 100; k++) {
    // Two are begun, 40 ms later both are finished, as it seems in the same moment.
    count.count(frame(5000 + 40 * k, 5040 + 40 * k));
    count.count(frame(5001 + 40 * k, 5040 + 40 * k));
    expect(count.stats.frameMs).toBeGreaterThan(15);
    expect(count.stats.mraysPerSecond).toBeLessThan(RAYS / 15 / 1000);
  }
  expect(count.stats.frameMs).toBeCloseTo(20, 9);
  expect(count.stats.fps).toBeCloseTo(50, 6);
});

test('slow frames: the newest alone', () => {
  const count = figures();
  for (let k = 0; k < 5; k++) count.count(frame(3000 * k, 3000 * (k + 1)));
  expect(count.stats.fps).toBeCloseTo(1 / 3, 9);
  expect(count.stats.frameMs).toBe(3000);
});

describe('after a rest', () => {
  test('the count begins anew, and the last figures stay until then', () => {
    const count = figures();
    for (let k = 0; k < 10; k++) count.count(frame(1000 + 20 * k, 1020 + 20 * k));
    count.rest({ width: 100, height: 100 });
    expect(count.stats).toMatchObject({ fps: 0, frameMs: 20 });
    count.count(frame(9000, 9005));
    expect(count.stats.frameMs).toBe(5);
    expect(count.stats.fps).toBe(200);
  });
});

test('whatever is noticed when: a device does not work longer than time passes (seed 91)', () => {
  const random = seededRandom(91);
  for (let run = 0; run < 50; run++) {
    const count = figures();
    let now = between(random, 0, 5000);
    for (let k = 0; k < 200; k++) {
      const started = now - between(random, 0, 50);
      now += random() < 0.3 ? 0 : between(random, 0, random() < 0.05 ? 3000 : 60);
      const { fps, frameMs, mraysPerSecond } = count.count(frame(Math.min(started, now), now));
      expect(fps * frameMs).toBeLessThanOrEqual(1000 + 1e-6);
      expect(mraysPerSecond * frameMs * 1000).toBeCloseTo(RAYS, 3);
    }
  }
});
