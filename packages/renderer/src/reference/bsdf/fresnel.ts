/** Unpolarised Fresnel reflectance. `cosine`: of the angle of incidence, 0 … 1. */
import type { Color } from '../../scene/scene.ts';
import { mapColor } from './surface.ts';

/** Between two transparent media; `ratio` = index of the far one / index of the near one. */
export function dielectricFresnel(cosine: number, ratio: number): number {
  const sineInside = Math.sqrt(Math.max(1 - cosine ** 2, 0)) / ratio;
  if (sineInside >= 1) return 1;
  const inside = Math.sqrt(1 - sineInside ** 2);
  const across = (cosine - ratio * inside) / (cosine + ratio * inside);
  const along = (ratio * cosine - inside) / (ratio * cosine + inside);
  return (across ** 2 + along ** 2) / 2;
}

type Complex = readonly [real: number, imaginary: number];
const times = (a: Complex, b: Complex): Complex => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
const plus = (a: Complex, b: Complex): Complex => [a[0] + b[0], a[1] + b[1]];
const minus = (a: Complex, b: Complex): Complex => [a[0] - b[0], a[1] - b[1]];
const norm2 = (a: Complex) => a[0] ** 2 + a[1] ** 2;
function squareRoot([x, y]: Complex): Complex {
  const length = Math.hypot(x, y);
  return [Math.sqrt(Math.max(length + x, 0) / 2), (y < 0 ? -1 : 1) * Math.sqrt(Math.max(length - x, 0) / 2)];
}

/** From vacuum onto metal of index eta + i·k: the same equations as for glass, in complex numbers. */
export function conductorFresnel(cosine: number, eta: number, k: number): number {
  // The limit; the formula has 0 / 0.
  if (eta === 0 && k === 0) return 1;
  const n2 = times([eta, k], [eta, k]);
  const inside = squareRoot(minus(n2, [1 - cosine ** 2, 0]));
  const outside: Complex = [cosine, 0];
  const across = norm2(minus(outside, inside)) / norm2(plus(outside, inside));
  const n2Outside = times(n2, outside);
  const along = norm2(minus(n2Outside, inside)) / norm2(plus(n2Outside, inside));
  return (across + along) / 2;
}

/** Schlick 1994, reflectance 1 along the surface. */
export const schlick = (f0: number, cosine: number): number => f0 + (1 - f0) * (1 - cosine) ** 5;
export const schlickColor = (f0: Color, cosine: number): Color => mapColor(f0, (x) => schlick(x, cosine));
