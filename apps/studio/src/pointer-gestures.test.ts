import { expect, test } from 'vitest';
import { pinch, wheelDolly } from './pointer-gestures.ts';

test('two fingers that move alike pan and do not dolly', () => {
  const move = pinch(
    [
      { x: 0, y: 0 },
      { x: 100, y: 0 },
    ],
    [
      { x: 10, y: 20 },
      { x: 110, y: 20 },
    ],
    400,
  );
  expect(move).toEqual({ panX: -0.025, panY: 0.05, dolly: 0 });
});

test('fingers that part come closer', () => {
  const move = pinch(
    [
      { x: 0, y: 0 },
      { x: 100, y: 0 },
    ],
    [
      { x: -50, y: 0 },
      { x: 150, y: 0 },
    ],
    400,
  );
  expect(move.dolly).toBeCloseTo(-Math.log(2));
  expect(move.panX).toBeCloseTo(0);
});

test('the wheel towards the hand goes away, in any unit, and never far at once', () => {
  expect(wheelDolly({ deltaY: 100, deltaMode: 0, ctrlKey: false })).toBeCloseTo(0.15);
  expect(wheelDolly({ deltaY: -3, deltaMode: 1, ctrlKey: false })).toBeCloseTo(-0.072);
  expect(wheelDolly({ deltaY: 1e5, deltaMode: 0, ctrlKey: false })).toBe(0.5);
});
