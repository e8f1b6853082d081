import { expect, test } from 'vitest';
import { linearToSrgb } from './srgb.ts';

/** The kernel's curve, see display.wesl. */
function kernelCurve(x: number): number {
  if (x <= 0.0031308) return 12.92 * x;
  const [r2, r4, r8] = [x ** (1 / 2), x ** (1 / 4), x ** (1 / 8)];
  return 0.662002687 * r2 + 0.68412206 * r4 - 0.323583601 * r8 - 0.022541147 * x;
}

test('the sRGB curve by roots is off by less than a quarter of an 8-bit step, and joins white', () => {
  let largest = 0;
  for (let i = 0; i <= 100_000; i++) {
    const x = i / 100_000;
    largest = Math.max(largest, Math.abs(kernelCurve(x) - linearToSrgb(x)));
  }
  expect(largest * 255).toBeLessThan(0.25);
  expect(kernelCurve(1)).toBeCloseTo(1, 4);
});
