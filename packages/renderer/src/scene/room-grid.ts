/** A box of the world cut into cells: which of them hold a surface, how much room there is around the others, and what lies in the way. */
import type { Bounds } from './bounds.ts';
import type { Vec3 } from './scene.ts';

/** Along each side of the box. */
export const CELLS = 24;
const COUNT = CELLS ** 3;
const STRIDES = [1, CELLS, CELLS * CELLS] as const;

/** Points that triangles may be marked by, all together: some tenths of a second. */
const MOST_POINTS = 2 ** 25;

export class RoomGrid {
  readonly bounds: Bounds;
  /** Edges of a cell, metres. */
  readonly size: Vec3;
  /** 1 where a surface passes. */
  readonly #held = new Uint8Array(COUNT);
  #points = 0;

  constructor(bounds: Bounds) {
    this.bounds = bounds;
    this.size = [0, 1, 2].map((k) => (bounds.max[k]! - bounds.min[k]!) / CELLS) as unknown as Vec3;
  }

  /** Marks the cells of a triangle, corners in the world. False: there were more than can be marked, and nothing is known. */
  mark(a: ArrayLike<number>, b: ArrayLike<number>, c: ArrayLike<number>): boolean {
    const { size } = this;
    let longest = 0;
    for (let k = 0; k < 3; k++)
      longest = Math.max(longest, Math.abs(b[k]! - a[k]!) / size[k]!, Math.abs(c[k]! - a[k]!) / size[k]!, Math.abs(c[k]! - b[k]!) / size[k]!); // biome-ignore format: one maximum
    // Half a cell apart: a surface leaves no hole that a walk from cell to cell could slip through.
    const steps = Math.max(Math.ceil(2 * longest), 1);
    this.#points += (steps + 1) * (steps + 2);
    if (!(this.#points <= MOST_POINTS)) return false;
    for (let i = 0; i <= steps; i++)
      for (let j = 0; j <= steps - i; j++) {
        const [u, v] = [i / steps, j / steps];
        this.#held[this.#cellAt(a[0]! + u * (b[0]! - a[0]!) + v * (c[0]! - a[0]!), a[1]! + u * (b[1]! - a[1]!) + v * (c[1]! - a[1]!), a[2]! + u * (b[2]! - a[2]!) + v * (c[2]! - a[2]!))] = 1; // biome-ignore format: one point
      }
    return true;
  }

  /** How many cells, corners counted as neighbours, it is from each to the nearest that holds a surface, or to the end of the box. */
  clearances(): Uint8Array {
    const far = new Uint8Array(COUNT).fill(255);
    let ring: number[] = [];
    for (let cell = 0; cell < COUNT; cell++) if (this.#held[cell] === 1) ring.push(cell);
    for (const cell of ring) far[cell] = 0;
    for (let distance = 1; ring.length > 0; distance++) {
      const next: number[] = [];
      for (const cell of ring)
        visitNeighbours(cell, (other) => {
          if (far[other] !== 255) return;
          far[other] = distance;
          next.push(other);
        });
      ring = next;
    }
    for (let cell = 0; cell < COUNT; cell++)
      for (const x of placeOf(cell)) far[cell] = Math.min(far[cell]!, x + 1, CELLS - x);
    return far;
  }

  /** The cell with the most room around it among those with a surface on at least five of their six sides; −1 when there is none. */
  freest(clearances: Uint8Array): number {
    const sides = new Uint8Array(COUNT);
    for (let axis = 0; axis < 3; axis++) for (const step of [1, -1]) this.#sweep(axis, step, sides);
    let best = -1;
    let [room, off] = [0, 0];
    for (let cell = 0; cell < COUNT; cell++) {
      if (sides[cell]! < 5 || clearances[cell]! < room) continue;
      const place = placeOf(cell);
      const offset = place.reduce((sum, x) => sum + (x - (CELLS - 1) / 2) ** 2, 0);
      if (clearances[cell]! === room && offset >= off) continue;
      [best, room, off] = [cell, clearances[cell]!, offset];
    }
    return room > 0 ? best : -1;
  }

  /** The middle of a cell, in the world. */
  middle(cell: number): Vec3 {
    return placeOf(cell).map((x, k) => this.bounds.min[k]! + (x + 0.5) * this.size[k]!) as unknown as Vec3;
  }

  /** The last point from `from` on along the direction, metres, before a cell with less room than `least`. */
  walk(from: Vec3, direction: Vec3, clearances: Uint8Array, least: number): number {
    const step = Math.min(...this.size.map((s, k) => s / Math.max(Math.abs(direction[k]!), 1e-9))) / 2;
    let far = 0;
    for (let i = 1; i <= 4 * CELLS; i++) {
      const [x, y, z] = [0, 1, 2].map((k) => from[k]! + i * step * direction[k]!) as [number, number, number];
      if (!this.#isInside(x, y, z) || clearances[this.#cellAt(x, y, z)]! < least) break;
      far = i * step;
    }
    return far;
  }

  /** Adds one to the cells that have a surface somewhere before them along an axis. */
  #sweep(axis: number, step: number, sides: Uint8Array): void {
    const [across, down] = STRIDES.filter((_, k) => k !== axis) as [number, number];
    const along = STRIDES[axis]!;
    for (let i = 0; i < CELLS; i++)
      for (let j = 0; j < CELLS; j++) {
        let met = false;
        for (let k = 0; k < CELLS; k++) {
          const cell = i * across + j * down + (step > 0 ? k : CELLS - 1 - k) * along;
          if (met) sides[cell]!++;
          met ||= this.#held[cell] === 1;
        }
      }
  }

  #isInside(x: number, y: number, z: number): boolean {
    const { min, max } = this.bounds;
    return x >= min[0] && y >= min[1] && z >= min[2] && x <= max[0] && y <= max[1] && z <= max[2];
  }

  #cellAt(x: number, y: number, z: number): number {
    const { min } = this.bounds;
    const at = (value: number, k: number) => Math.min(Math.max(Math.floor((value - min[k]!) / this.size[k]!), 0), CELLS - 1); // biome-ignore format: one line
    return at(x, 0) + at(y, 1) * STRIDES[1] + at(z, 2) * STRIDES[2];
  }
}

const placeOf = (cell: number): [number, number, number] => [
  cell % CELLS,
  Math.floor(cell / STRIDES[1]) % CELLS,
  Math.floor(cell / STRIDES[2]),
];

function visitNeighbours(cell: number, visit: (other: number) => void): void {
  const [x, y, z] = placeOf(cell);
  for (let k = Math.max(z - 1, 0); k <= Math.min(z + 1, CELLS - 1); k++)
    for (let j = Math.max(y - 1, 0); j <= Math.min(y + 1, CELLS - 1); j++)
      for (let i = Math.max(x - 1, 0); i <= Math.min(x + 1, CELLS - 1); i++) visit(i + j * STRIDES[1] + k * STRIDES[2]);
}
