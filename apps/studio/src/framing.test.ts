import { expect, test } from 'vitest';
import { framingFor } from './framing.ts';

const bare = { top: 0, right: 0, bottom: 0 };

test('a wide or square picture is shown as the camera says', () => {
  expect(framingFor({ width: 960, height: 600, ...bare })).toBeNull();
  expect(framingFor({ width: 512, height: 512, ...bare })).toBeNull();
});

test('a high picture keeps the field of view along its width', () => {
  expect(framingFor({ width: 390, height: 780, ...bare })).toEqual({ center: [0.5, 0.5], height: 0.5 });
});

test('what a panel covers is not counted: the middle is that of the rest', () => {
  expect(framingFor({ width: 1200, height: 600, ...bare, right: 300 })).toEqual({ center: [0.375, 0.5], height: 1 });
  expect(framingFor({ width: 400, height: 800, ...bare, bottom: 500 })).toEqual({
    center: [0.5, 0.1875],
    height: 0.375,
  });
  expect(framingFor({ width: 400, height: 800, top: 50, right: 0, bottom: 500 })?.center[1]).toBeCloseTo(0.21875);
});

test('covered altogether, there is still something', () => {
  const framing = framingFor({ width: 300, height: 300, top: 200, right: 400, bottom: 200 })!;
  expect(framing.height).toBeGreaterThan(0.01);
  expect([...framing.center].every((share) => share >= 0 && share <= 1)).toBe(true);
});

test('a picture without size is none', () => expect(framingFor({ width: 0, height: 0, ...bare })).toBeNull());
