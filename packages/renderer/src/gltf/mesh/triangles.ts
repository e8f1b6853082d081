/** Lists of triangles from all that glTF calls triangles. */

export const MODE_NAMES = [
  'points',
  'lines',
  'line loops',
  'line strips',
  'triangles',
  'triangle strips',
  'triangle fans',
] as const;
const [TRIANGLES, STRIP] = [4, 5];

/** Three indices a triangle, in the order that keeps the outside outside; what is left over at the end is dropped. */
export function triangleList(mode: number, indices: ArrayLike<number> | null, vertices: number): Uint32Array {
  const at = (i: number): number => (indices === null ? i : indices[i]!);
  const count = indices === null ? vertices : indices.length;
  if (mode === TRIANGLES) {
    const whole = count - (count % 3);
    if (indices instanceof Uint32Array && whole === count) return indices;
    return Uint32Array.from({ length: whole }, (_, i) => at(i));
  }
  const list = new Uint32Array(3 * Math.max(count - 2, 0));
  for (let i = 0; i + 2 < count; i++) {
    // Every other triangle of a strip runs the other way round (glTF 2.0, 3.7.2.1).
    const corners = mode === STRIP ? [i, i + 1 + (i % 2), i + 2 - (i % 2)] : [i + 1, i + 2, 0];
    list.set(corners.map(at), 3 * i);
  }
  return list;
}
