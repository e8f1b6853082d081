import { expect, test } from 'vitest';
import { relativeError } from './film-error.ts';

test('the error of cells: root of the mean square, as a share of the mean', () => {
  // Two cells of four and of one pixel: their radiances add up to 10, the squares of their errors to 0.2.
  expect(relativeError(new Float32Array([8, 0.1, 4, 0, 2, 0.1, 1, 0]))).toBeCloseTo(Math.sqrt(0.2 / 5) / 2, 6);
});

test('no number where there is none', () => {
  expect(relativeError(new Float32Array([0, 0, 4, 0]))).toBeNull();
  expect(relativeError(new Float32Array([Number.POSITIVE_INFINITY, 1, 4, 0]))).toBeNull();
  expect(relativeError(new Float32Array(8))).toBeNull();
});
