/** Placing a neutral scene's shapes, which have a matrix, by the numbers that our shapes have. */
import type { Matrix, Triple } from './neutral-scene.ts';

/** What our format cannot say, in words. */
export class Refusal extends Error {}

/**
 * How far edges may be from a right angle, or lengths from each other, as a share: the matrices in such files have seven digits.
 * As much as the kernel's own floats would lose.
 */
const RIGHT = 1e-6;

const IDENTITY: Matrix = [
  [1, 0, 0, 0],
  [0, 1, 0, 0],
  [0, 0, 1, 0],
  [0, 0, 0, 1],
];

/** Twelve digits: what comes of rounding in double precision goes, what a 32-bit float can hold stays. */
export const tidy = (x: number): number => Number(x.toPrecision(12)) + 0;
const tidyTriple = (t: readonly number[]): Triple => [tidy(t[0]!), tidy(t[1]!), tidy(t[2]!)];
const degrees = (radians: number): number => (radians * 180) / Math.PI;
const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
const length = (a: Triple): number => Math.hypot(...a);
const scaled = (a: Triple, s: number): Triple => [a[0] * s, a[1] * s, a[2] * s];

/** The matrix's linear part times a direction. */
const turned = (m: Matrix, d: Triple): Triple => [0, 1, 2].map((r) => dot(m[r]!.slice(0, 3) as Triple, d)) as Triple;
const moved = (m: Matrix, p: Triple): Triple => turned(m, p).map((x, r) => x + m[r]![3]!) as Triple;

function affine(transform: Matrix | undefined): Matrix {
  const m = transform ?? IDENTITY;
  if (m[3].some((x, c) => x !== IDENTITY[3][c])) throw new Refusal('a projective transform');
  return m;
}

/** Row by row; nothing where there is none. */
export const matrixOf = (transform: Matrix | undefined): { readonly matrix?: readonly number[] } =>
  transform === undefined ? {} : { matrix: affine(transform).flat() };

export function placeQuad(corner: Triple, u: Triple, v: Triple, transform?: Matrix) {
  const m = affine(transform);
  if (m === IDENTITY) return { corner, u, v };
  return { corner: tidyTriple(moved(m, corner)), u: tidyTriple(turned(m, u)), v: tidyTriple(turned(m, v)) };
}

export function placeSphere(center: Triple, radius: number, transform?: Matrix) {
  const m = affine(transform);
  if (m === IDENTITY) return { center, radius };
  const [x, y, z] = edgesOf(m, [1, 1, 1], 'a sphere under a transform with shear').map(length) as Triple;
  if (Math.max(x, y, z) - Math.min(x, y, z) > RIGHT * x)
    throw new Refusal('a sphere scaled differently along its axes (an ellipsoid)');
  return { center: tidyTriple(moved(m, center)), radius: tidy(radius * Math.cbrt(x * y * z)) };
}

/** Centre, lengths of sides, and turn about X, then Y, then Z (R = Rz·Ry·Rx). */
export function placeBox(min: Triple, max: Triple, transform?: Matrix) {
  const m = affine(transform);
  const middle = min.map((low, c) => (low + max[c]!) / 2) as Triple;
  const sides = min.map((low, c) => max[c]! - low) as Triple;
  const axes = edgesOf(m, sides, 'a box under a transform with shear');
  const rotation = m === IDENTITY ? [0, 0, 0] : eulerAngles(axes);
  return { center: tidyTriple(moved(m, middle)), size: tidyTriple(axes.map(length)), rotation: tidyTriple(rotation) };
}

/** Whether the transform takes a box's right angles away. */
export function isSheared({ min, max, transform }: { min: Triple; max: Triple; transform?: Matrix }): boolean {
  const [a, b, c] = edges(affine(transform), min.map((low, i) => max[i]! - low) as Triple);
  return crooked(a, b) || crooked(b, c) || crooked(c, a);
}

const crooked = (p: Triple, q: Triple) => Math.abs(dot(p, q)) > RIGHT * length(p) * length(q);

/** Where the matrix takes the three axes, in these lengths. */
const edges = (m: Matrix, lengths: Triple): [Triple, Triple, Triple] =>
  lengths.map((l, c) => turned(m, [0, 1, 2].map((axis) => (axis === c ? l : 0)) as Triple)) as [Triple, Triple, Triple];

/** The same, if they are at right angles. */
function edgesOf(m: Matrix, lengths: Triple, what: string): [Triple, Triple, Triple] {
  const [a, b, c] = edges(m, lengths);
  if (crooked(a, b) || crooked(b, c) || crooked(c, a)) throw new Refusal(what);
  return [a, b, c];
}

/** Degrees about X, then Y, then Z of the frame with these axes. A box has no hands, so a left-handed frame may lose one. */
function eulerAngles(axes: readonly [Triple, Triple, Triple]): Triple {
  const [x, y, w] = axes.map((e) => scaled(e, 1 / length(e))) as [Triple, Triple, Triple];
  const z = dot(cross(x, y), w) < 0 ? scaled(w, -1) : w;
  const level = Math.hypot(x[0], x[1]);
  const aboutY = Math.atan2(-x[2], level);
  // Looking straight along Z only the difference of the turns about X and Z counts: let that about Z be none.
  if (level < RIGHT) return [degrees(Math.atan2(-z[1], y[1])), degrees(aboutY), 0];
  return [degrees(Math.atan2(y[2], z[2])), degrees(aboutY), degrees(Math.atan2(x[1], x[0]))];
}
