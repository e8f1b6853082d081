/**
 * Pixel filters as curves: the inverse of their distribution along one axis, as cubic pieces that shading/camera/filter.wesl
 * follows. One curve for all filters, so that a change of filter changes numbers and no program.
 */
import { FILTER_PIECES } from './layout.ts';

export const PIXEL_FILTERS = ['box', 'tent', 'gaussian', 'blackman-harris'] as const;
export type PixelFilter = (typeof PIXEL_FILTERS)[number];

interface AxisFilter {
  /** Half its width, pixels. */
  readonly radius: number;
  /** Along one axis, of any height; x in 0 … radius. The filter is the product of both axes. */
  readonly height: (x: number) => number;
}

/** Half the bell's width at 1/√e, pixels. */
const SIGMA = 0.5;
const bell = (x: number) => Math.exp((-x * x) / (2 * SIGMA * SIGMA));

/** F. Harris, "On the use of windows for harmonic analysis with the discrete Fourier transform", Proc. IEEE 66(1), 1978. */
function minimumFourTermWindow(x: number, radius: number): number {
  const angle = (Math.PI * x) / radius;
  return 0.35875 + 0.48829 * Math.cos(angle) + 0.14128 * Math.cos(2 * angle) + 0.01168 * Math.cos(3 * angle);
}

/** Radii are those of other renderers: Mitsuba's tent and Gaussian, Cycles' Blackman-Harris. */
export const AXIS_FILTERS: Readonly<Record<PixelFilter, AxisFilter>> = {
  box: { radius: 0.5, height: () => 1 },
  tent: { radius: 1, height: (x) => 1 - x },
  gaussian: { radius: 2, height: (x) => bell(x) - bell(2) },
  'blackman-harris': { radius: 1.5, height: (x) => minimumFourTermWindow(x, 1.5) },
};

/** Integral of the height from 0 to x by Simpson's rule. */
export function areaTo(filter: AxisFilter, x: number, steps = 64): number {
  let sum = filter.height(0) + filter.height(x);
  for (let k = 1; k < steps; k++) sum += (k % 2 === 0 ? 2 : 4) * filter.height((k * x) / steps);
  return (sum * x) / (3 * steps);
}

/** Where the share v of the area from the middle outwards ends. */
function inverse(filter: AxisFilter, v: number): number {
  if (v <= 0 || v >= 1) return v <= 0 ? 0 : filter.radius;
  const area = v * areaTo(filter, filter.radius);
  let [low, high] = [0, filter.radius];
  for (let k = 0; k < 40; k++) {
    const middle = (low + high) / 2;
    if (areaTo(filter, middle) < area) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/**
 * Coefficients c of x = c₀ + c₁t + c₂t² + c₃t³ for each piece, t from 0 to 1 in it. Pieces are equal parts of
 * s = 1 − √(1 − v), in which the tent is a straight line and the box a parabola: both are exact. Values and slopes are
 * those of the inverse; at the far end, where its slope may be anything, a value in the middle of the piece counts instead.
 */
function curve(filter: AxisFilter): number[] {
  const n = FILTER_PIECES;
  const total = areaTo(filter, filter.radius);
  const at = (s: number) => inverse(filter, 1 - (1 - s) ** 2);
  const slope = (k: number, x: number) => (2 * (1 - k / n) * total) / (filter.height(x) * n);
  const coefficients: number[] = [];
  for (let k = 0; k < n; k++) {
    const [a, b] = [at(k / n), at((k + 1) / n)];
    const first = slope(k, a);
    const rest = b - a - first;
    const cubic = k < n - 1 ? slope(k + 1, b) - first - 2 * rest : 8 * (first / 2 + rest / 4 - at((k + 0.5) / n) + a);
    coefficients.push(a, first, rest - cubic, cubic);
  }
  return coefficients;
}

const packed = new Map<PixelFilter, readonly number[]>();

/** What `Frame.filterPieces` holds for this filter. */
export function packFilter(name: PixelFilter): readonly number[] {
  let pieces = packed.get(name);
  if (!pieces) packed.set(name, (pieces = curve(AXIS_FILTERS[name])));
  return pieces;
}
