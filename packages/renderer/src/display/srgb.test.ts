import { expect, test } from 'vitest';
import { filmToSrgb, linearToSrgb } from './srgb.ts';

test('the sRGB curve: ends, the seam, and known values', () => {
  expect(linearToSrgb(0)).toBe(0);
  expect(linearToSrgb(1)).toBeCloseTo(1, 12);
  expect(linearToSrgb(0.0031308)).toBeCloseTo(linearToSrgb(0.00313081), 6);
  expect(linearToSrgb(0.18) * 255).toBeCloseTo(117.6, 0);
  // Each byte survives the way to linear and back.
  for (let byte = 0; byte < 256; byte++) {
    const s = byte / 255;
    const linear = s <= 0.04045 ? s / 12.92 : ((s + 0.055) / 1.055) ** 2.4;
    expect(Math.round(linearToSrgb(linear) * 255)).toBe(byte);
  }
});

test('exposure in stops, clipping, opaque', () => {
  const film = new Float32Array([0.25, 0, 9, 4, -1, 0.5, Number.POSITIVE_INFINITY, 0]);
  expect([...filmToSrgb(film, 0)]).toEqual([137, 0, 255, 255, 0, 188, 255, 255]);
  expect([...filmToSrgb(film, 1)]).toEqual([188, 0, 255, 255, 0, 255, 255, 255]);
});
