/** Polygons → triangles. Files have them flat, mostly convex; some are neither. */

/** Of more corners than this a polygon is cut into a fan, whatever its form: looking for ears takes the square of their number. */
const MOST_CORNERS = 256;

/**
 * Gives the corners (0 … count − 1) of count − 2 triangles, three each, in the sense of the polygon. `corner(k, c)`: coordinate c of the
 * polygon's corner k.
 */
export function triangulate(count: number, corner: (k: number, c: number) => number): number[] {
  if (count <= 3) return count === 3 ? [0, 1, 2] : [];
  const flat = flatten(count, corner);
  if (count > MOST_CORNERS || isConvex(flat)) return fan(count);
  return cutEars(flat);
}

function fan(count: number): number[] {
  const triangles: number[] = [];
  for (let k = 2; k < count; k++) triangles.push(0, k - 1, k);
  return triangles;
}

interface Flat {
  readonly x: Float64Array;
  readonly y: Float64Array;
}

/** The polygon seen from the side that it looks to (M. Newell's normal), so that it goes counter-clockwise: the two longest axes. */
function flatten(count: number, corner: (k: number, c: number) => number): Flat {
  const normal = [0, 0, 0];
  for (let k = 0; k < count; k++) {
    const next = (k + 1) % count;
    for (let c = 0; c < 3; c++) {
      const [a, b] = [(c + 1) % 3, (c + 2) % 3];
      normal[c]! += (corner(k, a) - corner(next, a)) * (corner(k, b) + corner(next, b));
    }
  }
  const size = normal.map(Math.abs) as [number, number, number];
  const across = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : size[1] > size[2] ? 1 : 2;
  const [first, second] =
    normal[across]! < 0 ? [(across + 2) % 3, (across + 1) % 3] : [(across + 1) % 3, (across + 2) % 3];
  return {
    x: Float64Array.from({ length: count }, (_, k) => corner(k, first!)),
    y: Float64Array.from({ length: count }, (_, k) => corner(k, second!)),
  };
}

/** Twice the area of the triangle a b c; below 0 when it goes clockwise. */
const area = ({ x, y }: Flat, a: number, b: number, c: number): number =>
  (x[b]! - x[a]!) * (y[c]! - y[a]!) - (x[c]! - x[a]!) * (y[b]! - y[a]!);

/** Whether a fan from corner 0 goes around it once, with no triangle turned over. */
function isConvex(flat: Flat): boolean {
  const count = flat.x.length;
  for (let k = 0; k < count; k++) {
    if (area(flat, k, (k + 1) % count, (k + 2) % count) < 0) return false;
    if (k >= 2 && area(flat, 0, k - 1, k) < 0) return false;
  }
  return true;
}

/** G. Meisters, "Polygons Have Ears", 1975: cuts off one corner after another that no other corner lies in. */
function cutEars(flat: Flat): number[] {
  const left = Array.from(flat.x, (_, k) => k);
  const triangles: number[] = [];
  while (left.length > 3) {
    const count = left.length;
    const at = (k: number) => left[(k + count) % count]!;
    let ear = left.findIndex((_, k) => isEar(flat, left, at(k - 1), at(k), at(k + 1)));
    // A polygon that crosses itself may have none: then any will do.
    if (ear < 0) ear = 0;
    triangles.push(at(ear - 1), at(ear), at(ear + 1));
    left.splice(ear, 1);
  }
  triangles.push(...left);
  return triangles;
}

function isEar(flat: Flat, left: readonly number[], a: number, b: number, c: number): boolean {
  if (!(area(flat, a, b, c) > 0)) return false;
  return !left.some((p) => p !== a && p !== b && p !== c && isWithin(flat, p, a, b, c));
}

/** A corner at the place of one of the three is not in the way: polygons with holes touch themselves there. */
function isWithin(flat: Flat, p: number, a: number, b: number, c: number): boolean {
  const { x, y } = flat;
  if ([a, b, c].some((q) => x[p] === x[q] && y[p] === y[q])) return false;
  return area(flat, a, b, p) >= 0 && area(flat, b, c, p) >= 0 && area(flat, c, a, p) >= 0;
}
