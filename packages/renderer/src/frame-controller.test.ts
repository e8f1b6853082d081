import { describe, expect, test } from 'vitest';
import { between, type Random, seededRandom } from '../../../tests/fixtures/random.ts';
import { FrameController } from './frame-controller.ts';

const SIDE = 1000;
const CANVAS = SIDE * SIDE;

/** A device on which a frame takes fixed + perPixel · pixels milliseconds, up to `noise` more or less of it. */
interface Machine {
  readonly fixed: number;
  readonly perPixel: number;
  readonly noise?: number;
}
const fullFrame = (milliseconds: number, fixed = 1): Machine => ({ fixed, perPixel: (milliseconds - fixed) / CANVAS });

interface Frame {
  readonly scale: number;
  readonly milliseconds: number;
}

/** Frames of a moving picture, one after the other. */
function run(
  controller: FrameController,
  machine: Machine,
  frames: number,
  { fps = 60, largest = 1, random = (() => 0.5) as Random } = {},
): Frame[] {
  return Array.from({ length: frames }, () => {
    const scale = controller.movingScale(CANVAS, fps, largest);
    const pixels = Math.round(SIDE * scale) ** 2;
    const { fixed, perPixel, noise = 0 } = machine;
    const milliseconds = (fixed + perPixel * pixels) * (1 + between(random, -noise, noise));
    controller.measured(pixels, milliseconds);
    return { scale, milliseconds };
  });
}
const median = (values: number[]) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)]!;

describe('a moving picture', () => {
  test.each([
    [30, 60],
    [50, 60],
    [120, 60],
    [100, 30],
    [250, 30],
  ])('of %f ms at full size is drawn at %i frames/s', (milliseconds, fps) => {
    const settled = run(new FrameController(), fullFrame(milliseconds), 300, { fps: fps as 60 }).slice(100);
    const usual = median(settled.map((f) => f.milliseconds));
    expect(usual).toBeLessThan(1000 / fps);
    expect(usual).toBeGreaterThan(0.5 * (1000 / fps));
    // One frame in 24 is larger to learn from; it may miss one refresh, and no more.
    for (const frame of settled) expect(frame.milliseconds).toBeLessThan(2 * (1000 / fps));
    expect(settled.filter((f) => f.milliseconds > 1000 / fps).length).toBeLessThanOrEqual(settled.length / 20);
  });

  test('is at full size when there is time', () => {
    const settled = run(new FrameController(), fullFrame(8), 100).slice(20);
    for (const { scale } of settled) expect(scale).toBe(1);
  });

  test.each([0.1, 0.13, 0.5, 0.77, 1])('never gets larger than %f of the canvas', (largest) => {
    for (const cost of [1, 30, 100, 3000]) {
      for (const { scale } of run(new FrameController(), fullFrame(cost), 200, { largest })) {
        expect(scale).toBeLessThanOrEqual(largest);
        expect(scale).toBeGreaterThan(0);
      }
    }
  });

  test('that would be a few blocks at 60 frames/s is drawn at 30', () => {
    const settled = run(new FrameController(), fullFrame(300), 300).slice(100);
    const usual = median(settled.map((f) => f.milliseconds));
    expect(usual).toBeGreaterThan(1000 / 60);
    expect(usual).toBeLessThan(1000 / 30);
  });

  test('is not made tiny when most of the time goes elsewhere', () => {
    const settled = run(new FrameController(), { fixed: 40, perPixel: 10 / CANVAS }, 200).slice(50);
    expect(median(settled.map((f) => f.scale))).toBeGreaterThan(0.9);
  });

  test('keeps its size on a steady machine', () => {
    for (let cost = 20; cost < 400; cost *= 1.07) {
      const settled = run(new FrameController(), fullFrame(cost), 400).slice(200);
      const usual = median(settled.map((f) => f.scale));
      const others = settled.filter((f) => f.scale !== usual).length;
      expect(others, `${cost} ms`).toBeLessThanOrEqual(Math.ceil(settled.length / 24));
    }
  });

  test('seldom changes its size on a noisy machine (seed 71)', () => {
    const random = seededRandom(71);
    for (let cost = 20; cost < 400; cost *= 1.05) {
      const settled = run(new FrameController(), { ...fullFrame(cost), noise: 0.1 }, 600, { random }).slice(200);
      const usual = settled.filter((_, k) => (k + 200) % 24 !== 0).map((f) => f.scale);
      const changes = usual.filter((scale, k) => k > 0 && scale !== usual[k - 1]).length;
      expect(changes, `${cost} ms`).toBeLessThan(3);
    }
  });

  test('gets smaller at once when the work is known to grow, and follows a machine that slows down', () => {
    const controller = new FrameController();
    run(controller, fullFrame(30), 100);
    controller.workChanged(3);
    expect(run(controller, fullFrame(90), 1)[0]!.milliseconds).toBeLessThan(1000 / 60);
    const slower = run(controller, fullFrame(300), 200).slice(100);
    expect(median(slower.map((f) => f.milliseconds))).toBeLessThan(1000 / 30);
  });
});

describe('samples of a still film', () => {
  test('fill a frame, never more, by powers of two (seed 73)', () => {
    const random = seededRandom(73);
    expect(new FrameController().samplesPerFrame(512 * 512, 60, 64), 'before anything is known').toBe(1);
    for (let k = 0; k < 300; k++) {
      const perPixel = 10 ** between(random, -9, -4);
      const controller = new FrameController();
      for (const pixels of [1e5, 4e5, 2e5]) controller.measured(pixels, perPixel * pixels);
      const pixels = Math.ceil(between(random, 1e4, 4e6));
      const count = controller.samplesPerFrame(pixels, 60, 64);
      expect(Math.log2(count) % 1).toBe(0);
      expect(count).toBeLessThanOrEqual(64);
      if (count > 1) expect(count * pixels * perPixel).toBeLessThan(1000 / 60);
      if (count < 64) expect(2 * count * pixels * perPixel).toBeGreaterThan((0.79 * 1000) / 60);
    }
  });
});

describe('submits', () => {
  test('before anything is known they are small', () => {
    expect(new FrameController().rowsPerSubmit(512)).toBe(512);
    expect(new FrameController().rowsPerSubmit(4096)).toBe(64);
  });

  test('stay below 100 ms, or have one row (seed 72)', () => {
    const random = seededRandom(72);
    for (let k = 0; k < 300; k++) {
      const machine = { fixed: between(random, 0, 15), perPixel: 10 ** between(random, -7, -1) };
      const controller = new FrameController();
      for (const pixels of [1e5, 4e5, 2e5]) controller.measured(pixels, machine.fixed + machine.perPixel * pixels);
      const width = Math.ceil(between(random, 1, 4000));
      const rows = controller.rowsPerSubmit(width);
      expect(rows).toBeGreaterThanOrEqual(1);
      expect(Number.isInteger(rows)).toBe(true);
      const milliseconds = machine.fixed + machine.perPixel * rows * width;
      if (rows > 1) expect(milliseconds, JSON.stringify({ ...machine, width })).toBeLessThan(102);
    }
  });
});
