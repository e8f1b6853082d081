/** The pixel filter in double precision: the curve that shading/camera/filter.wesl follows. */
import { FILTER_PIECES } from '../packed-scene/layout.ts';
import { type PixelFilter, packFilter } from '../packed-scene/pack-filter.ts';

function alongAxis(pieces: readonly number[], u: number): number {
  const across = 2 * u - 1;
  const x = FILTER_PIECES * (1 - Math.sqrt(1 - Math.abs(across)));
  const piece = Math.min(Math.floor(x), FILTER_PIECES - 1);
  const t = x - piece;
  const [a, b, c, d] = pieces.slice(4 * piece) as [number, number, number, number];
  const offset = a + t * (b + t * (c + t * d));
  return across < 0 ? -offset : offset;
}

/** Where a sample lies, from the centre of the pixel, in pixels: drawn with the filter's density, so that it counts 1. */
export function filterOffset(filter: PixelFilter, [u, v]: readonly [number, number]): [number, number] {
  const pieces = packFilter(filter);
  return [alongAxis(pieces, u), alongAxis(pieces, v)];
}
