/** Directions at vertices: brought to length 1, and made where a file has none that can be used. */

/** The sum of the triangles' normals at each vertex, weighted by area, of length 1; (0, 0, 1) where there is nothing to go by. */
export function blendedNormals(positions: Float32Array, indices: Uint32Array): Float32Array {
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [3 * indices[i]!, 3 * indices[i + 1]!, 3 * indices[i + 2]!] as const;
    const [a, b, c] = corners;
    const [ux, uy, uz] = [
      positions[b]! - positions[a]!,
      positions[b + 1]! - positions[a + 1]!,
      positions[b + 2]! - positions[a + 2]!,
    ];
    const [vx, vy, vz] = [
      positions[c]! - positions[a]!,
      positions[c + 1]! - positions[a + 1]!,
      positions[c + 2]! - positions[a + 2]!,
    ];
    const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of corners) for (let k = 0; k < 3; k++) normals[corner + k] = normals[corner + k]! + n[k]!;
  }
  for (let at = 0; at < normals.length; at += 3) {
    const length = Math.hypot(normals[at]!, normals[at + 1]!, normals[at + 2]!);
    const good = length > 0 && Number.isFinite(length);
    for (let k = 0; k < 3; k++) normals[at + k] = good ? normals[at + k]! / length : k === 2 ? 1 : 0;
  }
  return normals;
}

/** How far from 1 a length may be and count as 1. */
const SLACK = 1e-4;

/**
 * The vectors, the first three of `width` numbers each, with length 1: the same array when all have it already. `replace` gives what
 * stands for those that have no direction; how many these were comes back too.
 */
export function unitVectors(
  vectors: Float32Array,
  width: number,
  replace: (vertex: number) => ArrayLike<number>,
): { readonly vectors: Float32Array; readonly replaced: number } {
  let out = vectors;
  let replaced = 0;
  for (let at = 0; at < vectors.length; at += width) {
    const length = Math.hypot(vectors[at]!, vectors[at + 1]!, vectors[at + 2]!);
    if (Math.abs(length - 1) <= SLACK) continue;
    if (out === vectors) out = vectors.slice();
    const good = length > 1e-20 && Number.isFinite(length);
    const other = good ? null : replace(at / width);
    if (!good) replaced++;
    for (let k = 0; k < 3; k++) out[at + k] = other ? other[k]! : vectors[at + k]! / length;
  }
  return { vectors: out, replaced };
}

/** Some direction across the normal. */
export function across(normals: Float32Array, vertex: number): readonly number[] {
  const [x, y, z] = [normals[3 * vertex]!, normals[3 * vertex + 1]!, normals[3 * vertex + 2]!];
  const [a, b, c] = Math.abs(x) > 0.9 ? [-z, 0, x] : [0, z, -y];
  const length = Math.hypot(a, b, c) || 1;
  return [a / length, b / length, c / length];
}
