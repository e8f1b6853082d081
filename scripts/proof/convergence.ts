/** Error against samples: how a film approaches the reference. */
import type { Film, Reference } from '../../tests/reference/blocks.ts';
import { meansOf } from '../../tests/reference/blocks.ts';

export interface Convergence {
  /** Samples a pixel, and the relative error with them. */
  readonly steps: readonly { readonly samples: number; readonly error: number }[];
  /** The reference's own noise in the same measure: what no number of samples goes below. */
  readonly floor: number;
}

/** Keeps black pixels from counting without bound. */
const EPSILON = 0.01;

/** Mean of (ours − reference)² / (reference² + 0.01): relMSE. */
export function relativeSquaredError(film: Film, { mean }: Reference): number {
  const ours = meansOf(film);
  return ours.reduce((sum, x, i) => sum + (x - mean[i]!) ** 2 / (mean[i]! ** 2 + EPSILON), 0) / ours.length;
}

/** Its root. */
export const relativeError = (film: Film, reference: Reference): number =>
  Math.sqrt(relativeSquaredError(film, reference));

export function noiseFloor({ mean, error }: Reference): number {
  const squares = Array.from(mean, (m, i) => error[i]! ** 2 / (m ** 2 + EPSILON));
  return Math.sqrt(squares.reduce((sum, x) => sum + x, 0) / squares.length);
}
