/** Meshes with their vertices in another order, some left out or there more than once. */
import type { Mesh, MorphTarget } from '../../scene/mesh.ts';

/** The mesh whose vertex i is the old vertex `source[i]`. */
export function rearranged(mesh: Mesh, source: Uint32Array, indices: Uint32Array): Mesh {
  const pick = <Numbers extends Float32Array | Uint16Array>(numbers: Numbers, width: number): Numbers =>
    picked(numbers, width, source);
  const { normals, tangents, uvs, colors, skin, morphTargets } = mesh;
  const perVertex = skin ? skin.joints.length / (mesh.positions.length / 3) : 0;
  return {
    positions: pick(mesh.positions, 3),
    indices,
    ...(normals && { normals: pick(normals, 3) }),
    ...(tangents && { tangents: pick(tangents, 4) }),
    ...(uvs && { uvs: uvs.map((uv) => pick(uv, 2)) }),
    ...(colors && { colors: pick(colors, 4) }),
    ...(skin && { skin: { joints: pick(skin.joints, perVertex), weights: pick(skin.weights, perVertex) } }),
    ...(morphTargets && { morphTargets: morphTargets.map((target) => pickedTarget(target, source)) }),
  };
}

function pickedTarget({ positions, normals, tangents }: MorphTarget, source: Uint32Array): MorphTarget {
  return {
    ...(positions && { positions: picked(positions, 3, source) }),
    ...(normals && { normals: picked(normals, 3, source) }),
    ...(tangents && { tangents: picked(tangents, 3, source) }),
  };
}

/** The elements of `width` numbers at these places. */
export function picked<Numbers extends Float32Array | Uint16Array>(
  numbers: Numbers,
  width: number,
  source: Uint32Array,
): Numbers {
  const out = new (numbers.constructor as new (length: number) => Numbers)(source.length * width);
  for (let i = 0; i < source.length; i++)
    for (let c = 0; c < width; c++) out[i * width + c] = numbers[source[i]! * width + c]!;
  return out;
}

/** Vertices that triangles use, when they are fewer than half of those there are: many primitives may share one long list. */
export function usedVertices(
  indices: Uint32Array,
  vertices: number,
): { source: Uint32Array; indices: Uint32Array } | null {
  // A list as long as all vertices would cost each of ten thousand small primitives as much as a large one.
  const place = indices.length * 8 < vertices ? new Map<number, number>() : null;
  const places = place ? null : new Int32Array(vertices).fill(-1);
  const source: number[] = [];
  const moved = new Uint32Array(indices.length);
  for (let i = 0; i < indices.length; i++) {
    const vertex = indices[i]!;
    let to = place ? (place.get(vertex) ?? -1) : places![vertex]!;
    if (to < 0) {
      to = source.length;
      source.push(vertex);
      if (place) place.set(vertex, to);
      else places![vertex] = to;
    }
    moved[i] = to;
  }
  return source.length * 2 >= vertices ? null : { source: Uint32Array.from(source), indices: moved };
}

/** Every corner of every triangle a vertex of its own. */
export const unshared = (mesh: Mesh): Mesh => rearranged(mesh, mesh.indices, Uint32Array.from(mesh.indices.keys()));
