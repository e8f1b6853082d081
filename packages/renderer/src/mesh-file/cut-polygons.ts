import { checkCount, type FileProblems, WHOLE } from './file-problems.ts';
import { triangulate } from './triangulate.ts';

/** Polygons → triangles, in their order. `corners`: vertices of one polygon after the other; `sizes`: how many each has, 3 or more. */
export function cutPolygons(
  corners: Uint32Array<ArrayBuffer>,
  sizes: Uint32Array,
  positions: Float32Array,
  problems: FileProblems,
): Uint32Array<ArrayBuffer> {
  const triangles = corners.length - 2 * sizes.length;
  checkCount('triangles', triangles, WHOLE, problems);
  if (triangles === sizes.length) return corners.slice();
  const indices = new Uint32Array(3 * triangles);
  let first = 0;
  let at = 0;
  for (const size of sizes) {
    const begin = first;
    first += size;
    if (size === 3) {
      for (let k = 0; k < 3; k++) indices[at++] = corners[begin + k]!;
      continue;
    }
    for (const corner of triangulate(size, (k, c) => positions[3 * corners[begin + k]! + c]!))
      indices[at++] = corners[begin + corner]!;
  }
  return indices;
}
