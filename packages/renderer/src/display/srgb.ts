/** From linear film to the bytes of a screen. */

/** The sRGB transfer curve (IEC 61966-2-1); takes and gives 0 … 1. */
export const linearToSrgb = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

/** The other way. */
export const srgbToLinear = (srgb: number): number =>
  srgb <= 0.04045 ? srgb / 12.92 : ((srgb + 0.055) / 1.055) ** 2.4;

/**
 * Exposure (stops), clip, curve. The film is linear RGB + one more float a pixel, as `Renderer.readFilm` gives it;
 * the result is opaque RGBA for an `ImageData`.
 */
export function filmToSrgb(film: Float32Array | Float64Array, exposure: number): Uint8ClampedArray<ArrayBuffer> {
  const gain = 2 ** exposure;
  const bytes = new Uint8ClampedArray(film.length);
  for (let k = 0; k < film.length; k++) {
    const isAlpha = k % 4 === 3;
    bytes[k] = isAlpha ? 255 : 255 * linearToSrgb(Math.min(Math.max(film[k]! * gain, 0), 1));
  }
  return bytes;
}
