/** From linear film to the bytes of a screen. */
import type { Color, ToneMapping } from '../scene/scene.ts';
import { toneMap } from './tone-map.ts';

/** The sRGB transfer curve (IEC 61966-2-1); takes and gives 0 … 1. */
export const linearToSrgb = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

/** The other way. */
export const srgbToLinear = (srgb: number): number =>
  srgb <= 0.04045 ? srgb / 12.92 : ((srgb + 0.055) / 1.055) ** 2.4;

/**
 * Exposure (stops), tone mapping, curve. The film is linear RGB + one more float a pixel, as `Renderer.readFilm` gives it;
 * the result is opaque RGBA for an `ImageData`.
 */
export function filmToSrgb(
  film: Float32Array | Float64Array,
  exposure: number,
  toneMapping: ToneMapping = 'none',
): Uint8ClampedArray<ArrayBuffer> {
  const gain = 2 ** exposure;
  const bytes = new Uint8ClampedArray(film.length);
  for (let at = 0; at < film.length; at += 4) {
    const color: Color = [film[at]! * gain, film[at + 1]! * gain, film[at + 2]! * gain];
    const [r, g, b] = toneMap(color, toneMapping);
    bytes.set([255 * linearToSrgb(r), 255 * linearToSrgb(g), 255 * linearToSrgb(b), 255], at);
  }
  return bytes;
}
