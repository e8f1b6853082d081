import { weld } from './weld.ts';

/**
 * A normal for each vertex: the mean of the normals of the triangles around its place, each by its angle there, so that it does not
 * matter how a polygon was cut (G. Thürmer and C. A. Wüthrich, "Computing Vertex Normals from Polygonal Facets", JGT 3(1), 1998).
 * Vertices at the same place share one, whatever file kept them apart.
 */
export function smoothNormals(positions: Float32Array, indices: Uint32Array): Float32Array<ArrayBuffer> {
  const { placeOf, places } = weld(positions);
  return blendNormals(positions, indices, placeOf, places);
}

/** As `smoothNormals`, where the caller knows which vertices share a normal: those of the same place. */
export function blendNormals(
  positions: Float32Array,
  indices: Uint32Array,
  placeOf: Uint32Array,
  places: number,
): Float32Array<ArrayBuffer> {
  const sums = new Float64Array(3 * places);
  const last = new Uint32Array(places);
  for (let k = 0; k < indices.length; k += 3) {
    for (let corner = 0; corner < 3; corner++) {
      const here = indices[k + corner]!;
      const place = placeOf[here]!;
      addCorner(positions, here, indices[k + ((corner + 1) % 3)]!, indices[k + ((corner + 2) % 3)]!, sums, 3 * place);
      last[place] = k;
    }
  }
  const normals = new Float32Array(positions.length);
  for (let vertex = 0; vertex < normals.length / 3; vertex++) {
    const place = placeOf[vertex]!;
    const [x, y, z] = [sums[3 * place]!, sums[3 * place + 1]!, sums[3 * place + 2]!];
    const length = Math.hypot(x, y, z);
    // Two sides back to back cancel out: any of their normals will do, and where there is no triangle any direction.
    if (length > 1e-6) normals.set([x / length, y / length, z / length], 3 * vertex);
    else normals.set(triangleNormal(positions, indices, last[place]!), 3 * vertex);
  }
  return normals;
}

/** Adds the unit normal of the triangle a b c, times its angle at a. */
function addCorner(p: Float32Array, a: number, b: number, c: number, sums: Float64Array, at: number): void {
  const [ux, uy, uz] = [p[3 * b]! - p[3 * a]!, p[3 * b + 1]! - p[3 * a + 1]!, p[3 * b + 2]! - p[3 * a + 2]!];
  const [vx, vy, vz] = [p[3 * c]! - p[3 * a]!, p[3 * c + 1]! - p[3 * a + 1]!, p[3 * c + 2]! - p[3 * a + 2]!];
  const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const sine = Math.hypot(nx, ny, nz);
  if (!(sine > 0)) return;
  const share = Math.atan2(sine, ux * vx + uy * vy + uz * vz) / sine;
  sums[at] = sums[at]! + nx * share;
  sums[at + 1] = sums[at + 1]! + ny * share;
  sums[at + 2] = sums[at + 2]! + nz * share;
}

/** Of the triangle whose indices begin at k; straight up when it has no area. */
function triangleNormal(positions: Float32Array, indices: Uint32Array, k: number): readonly number[] {
  const sums = new Float64Array(3);
  if (k + 2 < indices.length) addCorner(positions, indices[k]!, indices[k + 1]!, indices[k + 2]!, sums, 0);
  const length = Math.hypot(...sums);
  return length > 0 ? [...sums].map((x) => x / length) : [0, 1, 0];
}
