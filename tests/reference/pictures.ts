/** Pictures for people: of means, and of z block by block. Opaque RGBA, row 0 on top. */
import { filmToSrgb } from '../../packages/renderer/src/display/srgb.ts';
import type { ZTest } from './statistics.ts';

export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly rgba: Uint8ClampedArray;
}

/** Linear RGB triples through exposure (stops), clip and the sRGB curve. */
export function pictureOfMeans(means: ArrayLike<number>, width: number, exposure: number): Picture {
  const pixels = means.length / 3;
  const film = Float64Array.from({ length: pixels * 4 }, (_, k) => (k % 4 === 3 ? 1 : means[(k >> 2) * 3 + (k % 4)]!));
  return { width, height: pixels / width, rgba: filmToSrgb(film, exposure) };
}

/** z of full colour. */
const FULL = 4;

/** Of each block the z that is farthest from zero: white none, red ours too bright, blue too dark, full colour from 4 on; black: not a number. */
export function pictureOfZ(
  { z, columns, rows }: Pick<ZTest, 'z' | 'columns' | 'rows'>,
  width: number,
  height: number,
): Picture {
  const rgba = new Uint8ClampedArray(width * height * 4);
  for (let p = 0; p < width * height; p++) {
    const column = Math.floor(((p % width) * columns) / width);
    const row = Math.floor((Math.floor(p / width) * rows) / height);
    const at = (row * columns + column) * 3;
    const farthest = [z[at]!, z[at + 1]!, z[at + 2]!].reduce((a, b) => (Math.abs(a) >= Math.abs(b) ? a : b));
    rgba.set([...zColor(farthest), 255], p * 4);
  }
  return { width, height, rgba };
}

function zColor(z: number): [number, number, number] {
  if (Number.isNaN(z)) return [0, 0, 0];
  const faint = 245 * (1 - Math.min(Math.abs(z) / FULL, 1));
  return z > 0
    ? [245 - 0.2 * (245 - faint), faint, faint]
    : [faint, 0.6 * faint + 0.4 * 245 * (faint / 245), 245 - 0.2 * (245 - faint)];
}
