import { expect, test } from 'vitest';
import { testMaterial } from '../../../../tests/fixtures/scenes.ts';
import { surfaceValues } from './surface-values.ts';

const absorption = (attenuationDistance: number) => {
  const glass = testMaterial({ type: 'dielectric', attenuationColor: [0, 0.5, 1], attenuationDistance });
  return surfaceValues(glass, null).absorption as readonly number[];
};

test('what is left after the distance is the attenuation colour; a distance of 0 is clear', () => {
  expect(Math.exp(-2 * absorption(2)[1]!)).toBeCloseTo(0.5, 12);
  expect(absorption(2)[2]).toBeCloseTo(0, 12);
  expect(absorption(0)).toEqual([0, 0, 0]);
});

test('however short the distance, absorption is a number in 32 bits: infinity times no way at all would be none', () => {
  for (const distance of [1e-38, 1e-300, 5e-324])
    for (const one of absorption(distance)) expect(Math.fround(one)).toBeLessThan(Number.POSITIVE_INFINITY);
});
