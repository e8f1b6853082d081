/** Meshes: the arrays of one as a primitive of a glTF mesh. */
import { type Mesh, vertexCount } from '../../scene/mesh.ts';
import type { GltfFile, Json } from './gltf-file.ts';

/** Least and greatest, which glTF wants said of positions. */
function extremes(positions: Float32Array): { min: number[]; max: number[] } {
  const [min, max] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]]; // biome-ignore format: a pair
  for (let i = 0; i < positions.length; i++) {
    min[i % 3] = Math.min(min[i % 3]!, positions[i]!);
    max[i % 3] = Math.max(max[i % 3]!, positions[i]!);
  }
  return positions.length > 0 ? { min: min!, max: max! } : { min: [0, 0, 0], max: [0, 0, 0] };
}

/** Arrays shared by meshes are in the file once. */
export function primitiveOf(file: GltfFile, mesh: Mesh): Json {
  const { positions, indices, normals, tangents, uvs = [], colors, skin, morphTargets = [] } = mesh;
  const attributes: Json = { POSITION: file.accessor(positions, 'VEC3', extremes(positions)) };
  // One array cannot be two kinds of attribute's accessor with and without extremes.
  if (normals) attributes.NORMAL = file.accessor(normals === positions ? normals.slice() : normals, 'VEC3');
  if (tangents) attributes.TANGENT = file.accessor(tangents, 'VEC4');
  uvs.forEach((uv, set) => {
    attributes[`TEXCOORD_${set}`] = file.accessor(uv, 'VEC2');
  });
  if (colors) attributes.COLOR_0 = file.accessor(colors, 'VEC4');
  if (skin) {
    const sets = skin.joints.length / vertexCount(mesh) / 4;
    for (let set = 0; set < sets; set++) {
      attributes[`JOINTS_${set}`] = file.accessor(fours(skin.joints, sets, set), 'VEC4');
      attributes[`WEIGHTS_${set}`] = file.accessor(fours(skin.weights, sets, set), 'VEC4');
    }
  }
  const targets = morphTargets.map((target) => ({
    ...(target.positions && { POSITION: file.accessor(target.positions, 'VEC3', extremes(target.positions)) }),
    ...(target.normals && { NORMAL: file.accessor(target.normals, 'VEC3') }),
    ...(target.tangents && { TANGENT: file.accessor(target.tangents, 'VEC3') }),
  }));
  return { attributes, indices: file.accessor(indices, 'SCALAR'), ...(targets.length > 0 && { targets }) };
}

/** One of several sets of four numbers a vertex. */
function fours<Numbers extends Float32Array | Uint16Array>(all: Numbers, sets: number, set: number): Numbers {
  if (sets === 1) return all;
  return all.filter((_, i) => Math.floor(i / 4) % sets === set) as Numbers;
}
