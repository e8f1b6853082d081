/** The N sample points of a spherical light, for a light of radius 1 about the origin. */
import type { Vec3 } from '../scene/scene.ts';

const CENTER: readonly Vec3[] = [[0, 0, 0]];

/** The 3 × 3 grid of the course project: flat, and half a radius wide to each side. */
const GRID: readonly Vec3[] = Array.from({ length: 9 }, (_, k) => [((k % 3) - 1) / 2, 0, (Math.floor(k / 3) - 1) / 2]);

const GOLDEN_RATIO_FRACTION = 0.6180339887498949;

const frac = (x: number): number => x - Math.floor(x);

/** Archimedes' map of the unit square onto the unit sphere: equal areas stay equal. */
function sphere(a: number, b: number): Vec3 {
  const z = 1 - 2 * a;
  const ring = Math.sqrt(Math.max(1 - z * z, 0));
  const phi = 2 * Math.PI * b;
  return [ring * Math.cos(phi), ring * Math.sin(phi), z];
}

/** `n` points; 1 and 9 are fixed, any other number is a Fibonacci lattice turned by the two random numbers. */
export function samplePoints(n: number, [xi1, xi2]: readonly [number, number]): readonly Vec3[] {
  if (n === 1) return CENTER;
  if (n === 9) return GRID;
  return Array.from({ length: n }, (_, k) => sphere((k + xi1) / n, frac(k * GOLDEN_RATIO_FRACTION + xi2)));
}
