/** Indices in the order of a tree's places, as a kernel wants them: the triangle at place k has corners 3 k … 3 k + 2. */
export function placedIndices(indices: Uint32Array, order: Uint32Array): Uint32Array<ArrayBuffer> {
  const placed = new Uint32Array(order.length * 3);
  for (let k = 0; k < order.length; k++) {
    const i = order[k]! * 3;
    placed[3 * k] = indices[i]!;
    placed[3 * k + 1] = indices[i + 1]!;
    placed[3 * k + 2] = indices[i + 2]!;
  }
  return placed;
}
