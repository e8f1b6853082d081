/** Boxes of primitives: six floats each, least x, y, z, greatest x, y, z. What builders start from. */
import type { TriangleMesh } from './bvh.ts';

const least = (a: number, b: number, c: number): number => {
  const m = a < b ? a : b;
  return m < c ? m : c;
};
const greatest = (a: number, b: number, c: number): number => {
  const m = a > b ? a : b;
  return m > c ? m : c;
};

/** Returns 0, or NaN when a coordinate is missing, infinite or no number: any such times 0 is NaN, which no sum loses. */
function writeBoxes(positions: Float32Array, indices: Uint32Array, boxes: Float32Array): number {
  let finite = 0;
  for (let i = 0, at = 0; i < indices.length; i += 3, at += 6) {
    const a = indices[i]! * 3;
    const b = indices[i + 1]! * 3;
    const c = indices[i + 2]! * 3;
    let p = positions[a]!;
    let q = positions[b]!;
    let r = positions[c]!;
    boxes[at] = least(p, q, r);
    boxes[at + 3] = greatest(p, q, r);
    finite += (p + q + r) * 0;
    p = positions[a + 1]!;
    q = positions[b + 1]!;
    r = positions[c + 1]!;
    boxes[at + 1] = least(p, q, r);
    boxes[at + 4] = greatest(p, q, r);
    finite += (p + q + r) * 0;
    p = positions[a + 2]!;
    q = positions[b + 2]!;
    r = positions[c + 2]!;
    boxes[at + 2] = least(p, q, r);
    boxes[at + 5] = greatest(p, q, r);
    finite += (p + q + r) * 0;
  }
  return finite;
}

function whatIsWrong({ positions, indices }: TriangleMesh): string {
  const vertices = Math.floor(positions.length / 3);
  for (let i = 0; i < indices.length; i++) {
    const v = indices[i]!;
    const where = `Triangle ${Math.floor(i / 3)}`;
    if (v >= vertices) return `${where} has index ${v}, but there are ${vertices} positions`;
    const place = [...positions.subarray(3 * v, 3 * v + 3)];
    if (!place.every(Number.isFinite)) return `${where} has a vertex at ${place.join(', ')}, which is no place`;
  }
  return 'Coordinates add up to more than 1e308';
}

/** Throws when an index leads nowhere or a position that is used is not finite: a tree of such boxes would lose triangles. */
export function triangleBoxes(mesh: TriangleMesh): Float32Array {
  const { positions, indices } = mesh;
  if (indices.length % 3 !== 0) throw new RangeError(`${indices.length} indices are not three for each triangle`);
  const boxes = new Float32Array(indices.length * 2);
  if (writeBoxes(positions, indices, boxes) !== 0) throw new RangeError(whatIsWrong(mesh));
  return boxes;
}

/** The union, into `union`, of the boxes of what `codes` has: codes of primitives and pairs as in items.ts. */
export function uniteBoxes(boxes: Float32Array, codes: Uint32Array, count: number, union: Float64Array): void {
  let x0 = Infinity;
  let y0 = Infinity;
  let z0 = Infinity;
  let x1 = -Infinity;
  let y1 = -Infinity;
  let z1 = -Infinity;
  for (let k = 0; k < count; k++) {
    const i = (codes[k]! >>> 1) * 6;
    if (boxes[i]! < x0) x0 = boxes[i]!;
    if (boxes[i + 1]! < y0) y0 = boxes[i + 1]!;
    if (boxes[i + 2]! < z0) z0 = boxes[i + 2]!;
    if (boxes[i + 3]! > x1) x1 = boxes[i + 3]!;
    if (boxes[i + 4]! > y1) y1 = boxes[i + 4]!;
    if (boxes[i + 5]! > z1) z1 = boxes[i + 5]!;
  }
  union[0] = x0;
  union[1] = y0;
  union[2] = z0;
  union[3] = x1;
  union[4] = y1;
  union[5] = z1;
}
