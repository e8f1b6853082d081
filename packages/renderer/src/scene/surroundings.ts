/** What lies around a point, in directions evenly over a cube about it: the first surface that is seen from there, and the last of all. */
import type { Vec3 } from './scene.ts';

/** Directions along an edge of the cube. */
const EDGE = 12;
export const DIRECTIONS = 6 * EDGE * EDGE;

/** Triangles may be tried so often, all together: some tenths of a second. */
const MOST_TRIES = 2 ** 26;

/** How a surface is seen: from its front only, from both sides, or through. */
export type Seen = 'front' | 'both' | 'through';

export class Surroundings {
  readonly place: Vec3;
  /** Distances, metres, along each direction; Infinity, and 0, where there is nothing. What is seen through counts for neither. */
  readonly first = new Float64Array(DIRECTIONS).fill(Number.POSITIVE_INFINITY);
  readonly last = new Float64Array(DIRECTIONS);
  /** Which thing is first, and last. */
  readonly firstThing = new Int32Array(DIRECTIONS).fill(-1);
  readonly lastThing = new Int32Array(DIRECTIONS).fill(-1);
  /** Whether the last turns its front to the point, and how steep it is: the cosine between its normal and +Y, 0 … 1. */
  readonly lastFront = new Uint8Array(DIRECTIONS);
  readonly lastUpright = new Float64Array(DIRECTIONS);
  #tries = 0;

  constructor(place: Vec3) {
    this.place = place;
  }

  /** Adds a triangle, corners in the world. False: there were more than can be tried, and nothing is known. */
  add(a: ArrayLike<number>, b: ArrayLike<number>, c: ArrayLike<number>, thing: number, seen: Seen): boolean {
    if (seen === 'through') return true;
    const corner = (p: ArrayLike<number>): Vec3 => [p[0]! - this.place[0], p[1]! - this.place[1], p[2]! - this.place[2]]; // biome-ignore format: one line
    const [x, y, z] = [corner(a), corner(b), corner(c)];
    for (let face = 0; face < 6; face++) this.#addToFace(face, x, y, z, thing, seen);
    return this.#tries <= MOST_TRIES;
  }

  #addToFace(face: number, a: Vec3, b: Vec3, c: Vec3, thing: number, seen: Seen): void {
    const axis = face >> 1;
    const sign = face & 1 ? -1 : 1;
    const [wa, wb, wc] = [sign * a[axis]!, sign * b[axis]!, sign * c[axis]!];
    if (wa <= 0 && wb <= 0 && wc <= 0) return;
    const [right, up] = [(axis + 1) % 3, (axis + 2) % 3];
    const whole = wa <= 0 || wb <= 0 || wc <= 0;
    const [fromX, toX] = whole ? EVERY : span(a[right]! / wa, b[right]! / wb, c[right]! / wc);
    const [fromY, toY] = whole ? EVERY : span(a[up]! / wa, b[up]! / wb, c[up]! / wc);
    if (fromX > toX || fromY > toY) return;
    this.#tries += (toX - fromX + 1) * (toY - fromY + 1);
    if (this.#tries > MOST_TRIES) return;
    const direction: [number, number, number] = [0, 0, 0];
    direction[axis] = sign;
    for (let j = fromY; j <= toY; j++)
      for (let i = fromX; i <= toX; i++) {
        direction[right] = along(i);
        direction[up] = along(j);
        this.#tryAt(face * EDGE * EDGE + j * EDGE + i, direction, a, b, c, thing, seen);
      }
  }

  /** Möller and Trumbore (1997), from the origin. */
  #tryAt(at: number, d: Vec3, a: Vec3, b: Vec3, c: Vec3, thing: number, seen: Seen): void {
    const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
    const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
    const [px, py, pz] = [d[1] * vz - d[2] * vy, d[2] * vx - d[0] * vz, d[0] * vy - d[1] * vx];
    const determinant = ux * px + uy * py + uz * pz;
    if (determinant === 0) return;
    const u = -(a[0] * px + a[1] * py + a[2] * pz) / determinant;
    const [qx, qy, qz] = [uy * a[2] - uz * a[1], uz * a[0] - ux * a[2], ux * a[1] - uy * a[0]];
    const v = (d[0] * qx + d[1] * qy + d[2] * qz) / determinant;
    const far = (vx * qx + vy * qy + vz * qz) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1 && far > 0)) return;
    const distance = far * Math.hypot(...d);
    // The determinant is −d · n, with the normal n = u × v.
    const front = determinant > 0;
    if (distance < this.first[at]! && (front || seen === 'both')) {
      this.first[at] = distance;
      this.firstThing[at] = thing;
    }
    if (distance <= this.last[at]!) return;
    this.last[at] = distance;
    this.lastThing[at] = thing;
    this.lastFront[at] = front ? 1 : 0;
    const n: Vec3 = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    this.lastUpright[at] = Math.abs(n[1]) / Math.hypot(...n);
  }
}

const EVERY = [0, EDGE - 1] as const;
const along = (i: number): number => (2 * (i + 0.5)) / EDGE - 1;

/** The directions between the least and the greatest of three places on a face, −1 … 1; none when the first is more than the second. */
function span(a: number, b: number, c: number): readonly [number, number] {
  const place = (x: number): number => ((x + 1) * EDGE) / 2 - 0.5;
  return [Math.max(Math.ceil(place(Math.min(a, b, c))), 0), Math.min(Math.floor(place(Math.max(a, b, c))), EDGE - 1)];
}

/** The directions of length 1, and the share of the sphere that each stands for. */
export const SPHERE: readonly { readonly direction: Vec3; readonly share: number }[] = Array.from(
  { length: DIRECTIONS },
  (_, at) => {
    const face = Math.floor(at / (EDGE * EDGE));
    const axis = face >> 1;
    const d: [number, number, number] = [0, 0, 0];
    d[axis] = face & 1 ? -1 : 1;
    d[(axis + 1) % 3] = along(at % EDGE);
    d[(axis + 2) % 3] = along(Math.floor(at / EDGE) % EDGE);
    const length = Math.hypot(...d);
    return {
      direction: [d[0] / length, d[1] / length, d[2] / length],
      share: (2 / EDGE) ** 2 / length ** 3 / (4 * Math.PI),
    };
  },
);
