/** What must hold for a mesh before anything later may rely on it, as environment.ts has it for the sky's map. */
import { SCENE_LIMITS } from './limits.ts';
import type { LoadedMesh, Mesh, MorphTarget, SkinWeights } from './mesh.ts';
import { triangleCount, vertexCount } from './mesh.ts';

/** Metres from the mesh's own origin. */
export const FARTHEST_VERTEX = 1e9;
/** How far from 1 the length of a normal may be. */
const NORMAL_SLACK = 0.01;

/** Meshes are not changed, so that one that has been looked through stays good. */
const good = new WeakSet<object>();

/** What is wrong with a mesh, in words that follow "the mesh has", or null. */
export function meshFault(mesh: Mesh): string | null {
  if (typeof mesh !== 'object' || mesh === null) return 'no content';
  if (good.has(mesh)) return null;
  const fault = faultOfTriangles(mesh) ?? faultOfVertices(mesh);
  if (fault === null) good.add(mesh);
  return fault;
}

function faultOfTriangles({ positions, indices }: Mesh): string | null {
  if (!(positions instanceof Float32Array)) return 'positions that are no Float32Array';
  if (!(indices instanceof Uint32Array)) return 'indices that are no Uint32Array';
  const [vertices, triangles] = [positions.length / 3, indices.length / 3];
  if (!Number.isInteger(vertices)) return `${positions.length} numbers as positions, which is no multiple of three`;
  if (!Number.isInteger(triangles)) return `${indices.length} indices, which is no multiple of three`;
  if (triangles === 0) return 'no triangle';
  const { meshVertices, meshTriangles } = SCENE_LIMITS;
  if (vertices > meshVertices) return `${vertices} vertices, where at most ${meshVertices} are allowed`;
  if (triangles > meshTriangles) return `${triangles} triangles, where at most ${meshTriangles} are allowed`;
  const far = firstBad(positions, (x) => Math.abs(x) <= FARTHEST_VERTEX);
  if (far >= 0)
    return `the coordinate ${positions[far]} at vertex ${Math.floor(far / 3)}, where −1e9 to 1e9 is allowed`;
  const wild = firstBad(indices, (i) => i < vertices);
  if (wild < 0) return null;
  return `the vertex ${indices[wild]} in triangle ${Math.floor(wild / 3)}, where there are ${vertices} vertices, counted from 0`;
}

/** The index of the first number that is not good, or −1. */
function firstBad(numbers: Float32Array | Uint32Array | Uint16Array, isGood: (x: number) => boolean): number {
  for (let k = 0; k < numbers.length; k++) if (!isGood(numbers[k]!)) return k;
  return -1;
}

function faultOfVertices(mesh: Mesh): string | null {
  const { normals, tangents, uvs = [], colors, skin, morphTargets = [] } = mesh;
  const vertices = vertexCount(mesh);
  if (uvs.length > 2) return `${uvs.length} sets of texture coordinates, where at most two are allowed`;
  return (
    faultOfNumbers('normals', normals, 3 * vertices) ??
    faultOfNormals(normals) ??
    faultOfNumbers('tangents', tangents, 4 * vertices) ??
    uvs.map((uv) => faultOfNumbers('texture coordinates', uv, 2 * vertices)).find((fault) => fault !== null) ??
    faultOfNumbers('colours', colors, 4 * vertices, 0) ??
    faultOfSkin(skin, vertices) ??
    morphTargets.map((target) => faultOfTarget(target, vertices)).find((fault) => fault !== null) ??
    null
  );
}

function faultOfNumbers(what: string, numbers: Float32Array | undefined, wanted: number, least = -FARTHEST_VERTEX) {
  if (numbers === undefined) return null;
  if (!(numbers instanceof Float32Array)) return `${what} that are no Float32Array`;
  if (numbers.length !== wanted) return `${numbers.length} numbers as ${what}, where its vertices need ${wanted}`;
  const strange = firstBad(numbers, (x) => x >= least && x <= FARTHEST_VERTEX);
  if (strange < 0) return null;
  return `the number ${numbers[strange]} among its ${what}, where ${least === 0 ? '0' : '−1e9'} to 1e9 is allowed`;
}

function faultOfNormals(normals: Float32Array | undefined): string | null {
  if (normals === undefined) return null;
  for (let k = 0; k < normals.length; k += 3) {
    const length = Math.hypot(normals[k]!, normals[k + 1]!, normals[k + 2]!);
    if (!(Math.abs(length - 1) <= NORMAL_SLACK))
      return `a normal of length ${length} at vertex ${k / 3}, where it is 1`;
  }
  return null;
}

function faultOfSkin(skin: SkinWeights | undefined, vertices: number): string | null {
  if (skin === undefined) return null;
  const { joints, weights } = skin;
  if (!(joints instanceof Uint16Array)) return 'joints that are no Uint16Array';
  if (joints.length !== 4 * vertices && joints.length !== 8 * vertices)
    return `${joints.length} joints, where its vertices need ${4 * vertices} or ${8 * vertices}`;
  return faultOfNumbers('weights', weights, joints.length, 0);
}

function faultOfTarget({ positions, normals, tangents }: MorphTarget, vertices: number): string | null {
  const lists = { positions, normals, tangents };
  const faults = Object.entries(lists).map(([name, list]) =>
    faultOfNumbers(`${name} of a morph target`, list, 3 * vertices),
  );
  return faults.find((fault) => fault !== null) ?? null;
}

/** What is wrong with all meshes of a scene together, in words that follow "the meshes have", or null. */
export function crowdFault(meshes: readonly LoadedMesh[]): string | null {
  const sum = (count: (mesh: Mesh) => number) => [...new Set(meshes.map(({ data }) => data))].reduce((s, m) => s + count(m), 0); // biome-ignore format: short
  const [vertices, triangles] = [sum(vertexCount), sum(triangleCount)];
  const { meshVertices, meshTriangles } = SCENE_LIMITS;
  if (vertices > meshVertices) return `${vertices} vertices together, where at most ${meshVertices} are allowed`;
  if (triangles > meshTriangles) return `${triangles} triangles together, where at most ${meshTriangles} are allowed`;
  return null;
}
