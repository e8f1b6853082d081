import type { Framing } from 'mirrorball';

/**
 * Scenes are composed so that what matters lies in a square in the middle of the picture: as high as the vertical field of view,
 * and as wide. Where there is less room than that beside and above the controls, the square gets smaller, and is not cropped.
 */

/** Lengths in pixels of the page, all of one unit. */
export interface Room {
  readonly width: number;
  readonly height: number;
  /** What controls cover along the edges. */
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** Least share of the picture that the square may shrink to. */
const LEAST = 0.1;

/** Where the scene's square goes: the largest in the middle of what is not covered. Null: over the picture's whole height. */
export function framingFor({ width, height, top, right, bottom }: Room): Framing | null {
  if (width <= 0 || height <= 0) return null;
  const free = {
    width: Math.max(width - right, LEAST * width),
    height: Math.max(height - top - bottom, LEAST * height),
  };
  const side = Math.min(free.width, free.height);
  if (side === height && free.width === width) return null;
  return { center: [free.width / 2 / width, (top + free.height / 2) / height], height: side / height };
}
