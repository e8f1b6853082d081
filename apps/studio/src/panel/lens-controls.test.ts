import { expect, test } from 'vitest';
import { apertureAt, aperturePlace } from './lens-controls.tsx';

test('the aperture slider: a pinhole at its end, else a millimetre to a metre', () => {
  expect([0, 1, 101].map(apertureAt)).toEqual([0, 0.001, 1]);
  for (const place of [0, 1, 40, 101]) expect(aperturePlace(apertureAt(place))).toBeCloseTo(place, 0);
  expect(aperturePlace(5)).toBe(101);
});
