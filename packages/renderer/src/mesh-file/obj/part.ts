/** The faces of one material → vertices that have everything of a kind, and triangles. */
import { cutPolygons } from '../cut-polygons.ts';
import type { FileProblems } from '../file-problems.ts';
import type { RawMesh } from '../finish-mesh.ts';
import { IndexList } from '../number-lists.ts';
import { blendNormals } from '../smooth-normals.ts';
import { NONE, type ObjStatements } from './statements.ts';
import { Unifier } from './unify.ts';

/** Which faces make up a part, in their order, and where the corners of each begin. */
export interface Faces {
  readonly faces: Uint32Array;
  readonly firstCorners: Uint32Array;
}

export function partOf(obj: ObjStatements, { faces, firstCorners }: Faces, problems: FileProblems): RawMesh {
  const { sizes } = obj;
  const needs = needsOf(obj, faces, firstCorners);
  // A vertex is a combination of position, texture coordinate, normal, and, where it has no normal, whose faces blend into one.
  const vertices = new Unifier();
  const [corners, counts] = [new IndexList(), new IndexList()];
  for (const face of faces) {
    const [first, size] = [firstCorners[face]!, sizes.at(face)];
    const group = obj.groups.at(face);
    for (let k = first; k < first + size; k++) {
      const uv = needs.uvs ? uvOf(obj, k) : NONE;
      const normal = needs.normals ? normalOf(obj, k) : NONE;
      const blend = !needs.normals || normal !== NONE ? 0 : group > 0 ? group : -1 - face;
      corners.push(vertices.add(obj.corners.at(3 * k), uv, normal, blend));
    }
    counts.push(size);
  }
  const count = vertices.length;
  const gather = (from: { at(k: number): number }, width: number, part: 0 | 1 | 2, missing = 0) => {
    const numbers = new Float32Array(width * count);
    for (let vertex = 0; vertex < count; vertex++) {
      const at = vertices.part(vertex, part);
      for (let c = 0; c < width; c++) numbers[width * vertex + c] = at === NONE ? missing : from.at(width * at + c);
    }
    return numbers;
  };
  const positions = gather(obj.positions, 3, 0);
  const indices = cutPolygons(corners.view(), counts.view(), positions, problems);
  return {
    positions,
    indices,
    normals: needs.normals ? withBlended(gather(obj.normals, 3, 2), vertices, positions, indices) : undefined,
    uvs: needs.uvs ? fromAbove(gather(obj.uvs, 2, 1)) : undefined,
    colors: obj.colors.length > 0 ? withOpacity(gather(obj.colors, 3, 0)) : undefined,
  };
}

/** Some programs write numbers of texture coordinates or normals and none of these: then there are none. */
const uvOf = ({ corners, uvs }: ObjStatements, k: number): number => (uvs.length === 0 ? NONE : corners.at(3 * k + 1));
const normalOf = ({ corners, normals }: ObjStatements, k: number): number =>
  normals.length === 0 ? NONE : corners.at(3 * k + 2);

/** Normals are wanted where the file gives some, or says which faces blend into one another. */
function needsOf(obj: ObjStatements, faces: Uint32Array, firstCorners: Uint32Array) {
  let [uvs, normals] = [false, false];
  for (const face of faces) {
    if (obj.groups.at(face) > 0) normals = true;
    for (let k = firstCorners[face]!; k < firstCorners[face]! + obj.sizes.at(face); k++) {
      if (uvOf(obj, k) !== NONE) uvs = true;
      if (normalOf(obj, k) !== NONE) normals = true;
    }
  }
  return { uvs, normals };
}

/** Vertices without a normal get one of the triangles around that blend with theirs. */
function withBlended(
  normals: Float32Array,
  vertices: Unifier,
  positions: Float32Array,
  indices: Uint32Array,
): Float32Array {
  const places = new Unifier();
  const placeOf = new Uint32Array(vertices.length);
  let missing = false;
  for (let vertex = 0; vertex < vertices.length; vertex++) {
    if (vertices.part(vertex, 2) === NONE) missing = true;
    placeOf[vertex] = places.add(vertices.part(vertex, 0), vertices.part(vertex, 3), 0, 0);
  }
  if (!missing) return normals;
  const blended = blendNormals(positions, indices, placeOf, places.length);
  for (let vertex = 0; vertex < vertices.length; vertex++)
    if (vertices.part(vertex, 2) === NONE) normals.set(blended.subarray(3 * vertex, 3 * vertex + 3), 3 * vertex);
  return normals;
}

/** Our images begin in their upper left corner, those of these files in the lower left one. */
function fromAbove(uvs: Float32Array): Float32Array {
  for (let k = 1; k < uvs.length; k += 2) uvs[k] = 1 - uvs[k]!;
  return uvs;
}

const withOpacity = (rgb: Float32Array): Float32Array =>
  Float32Array.from({ length: (rgb.length / 3) * 4 }, (_, k) => (k % 4 === 3 ? 1 : rgb[(k >> 2) * 3 + (k % 4)]!));
