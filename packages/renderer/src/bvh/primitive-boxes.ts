/** Boxes of primitives: six floats each, least x, y, z, greatest x, y, z. What builders start from. */
import type { TriangleMesh } from './bvh.ts';

/**
 * Least and greatest of three positions' coordinates, chosen without branches: in random order, which is least is as good as random,
 * and a wrong guess of the processor costs more than all of this. A comparison, negated, is a mask: all ones or none.
 * Returns 0, or NaN when a coordinate is missing, infinite or no number: any such times 0 is NaN, which no sum loses.
 */
function writeExtent(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  boxes: Float32Array,
  at: number,
): number {
  const p = positions[a]!;
  const q = positions[b]!;
  const r = positions[c]!;
  const pq = -(p < q) | 0;
  const qr = -(q < r) | 0;
  const pr = -(p < r) | 0;
  const swap = (a ^ b) & pq;
  const other = (qr ^ pr) & pq;
  const lesser = b ^ swap;
  const greater = a ^ swap;
  boxes[at] = positions[c ^ ((lesser ^ c) & (qr ^ other))]!;
  boxes[at + 3] = positions[greater ^ ((greater ^ c) & (pr ^ other))]!;
  return (p + q + r) * 0;
}

/** Returns 0, or NaN as `writeExtent` does. */
function writeBoxes(positions: Float32Array, indices: Uint32Array, boxes: Float32Array): number {
  let finite = 0;
  for (let i = 0, at = 0; i < indices.length; i += 3, at += 6) {
    const a = indices[i]! * 3;
    const b = indices[i + 1]! * 3;
    const c = indices[i + 2]! * 3;
    finite += writeExtent(positions, a, b, c, boxes, at);
    finite += writeExtent(positions, a + 1, b + 1, c + 1, boxes, at + 1);
    finite += writeExtent(positions, a + 2, b + 2, c + 2, boxes, at + 2);
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
