/**
 * Tangents for normal maps, as MikkTSpace makes them (M. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008), which glTF asks
 * for where a file has none. By meshoptimizer, loaded when first needed.
 */
import type { Mesh } from '../../scene/mesh.ts';
import { type TextureUse, textureTransform } from '../../scene/textures.ts';
import { across, blendedNormals } from './normals.ts';
import { rearranged, unshared } from './rearrange.ts';

/** Four numbers for each corner of each triangle. */
export type TangentMaker = (mesh: Mesh & { normals: Float32Array }, uv: Float32Array) => Float32Array;

export async function loadTangentMaker(): Promise<TangentMaker> {
  const { MeshoptTangents } = await import('meshoptimizer/tangents');
  await MeshoptTangents.ready;
  return ({ indices, positions, normals }, uv) =>
    MeshoptTangents.generateTangents(indices, positions, 3, normals, 3, uv, 2, ['Compatible']);
}

/** Tangents nearer than this are one, so that a vertex is not split for rounding. */
const SAME = 1e-3;

/**
 * The mesh with tangents along the coordinates that this use of a texture has. Vertices at which triangles do not agree are there more
 * than once afterwards; a mesh without normals gets those of its triangles, as tangents are nothing without them.
 */
export function withTangents(mesh: Mesh, use: TextureUse | null, make: TangentMaker): Mesh {
  const uv = mesh.uvs?.[use?.uvSet ?? 0];
  if (uv === undefined) throw new Error('A mesh without texture coordinates has no tangents.');
  const flat = mesh.normals === undefined;
  const whole = flat ? unshared(mesh) : mesh;
  const normals = whole.normals ?? blendedNormals(whole.positions, whole.indices);
  const coordinates = transformed(whole.uvs![use?.uvSet ?? 0]!, use);
  return split({ ...whole, normals }, finite(make({ ...whole, normals }, coordinates), whole.indices, normals));
}

/** Coordinates of 1e30 overflow on the way: some direction across the normal stands for what is no number. */
function finite(corners: Float32Array, indices: Uint32Array, normals: Float32Array): Float32Array {
  for (let i = 0; i < indices.length; i++)
    if (!corners.subarray(4 * i, 4 * i + 4).every(Number.isFinite))
      corners.set([...across(normals, indices[i]!), 1], 4 * i);
  return corners;
}

function transformed(uv: Float32Array, use: TextureUse | null): Float32Array {
  if (!use || (!use.rotation && !use.scale)) return uv;
  const transform = textureTransform(use);
  const out = new Float32Array(uv.length);
  for (let at = 0; at < uv.length; at += 2) out.set(transform(uv[at]!, uv[at + 1]!), at);
  return out;
}

/** One vertex for each tangent that a vertex's corners have. */
function split(mesh: Mesh, corners: Float32Array): Mesh {
  const vertices = mesh.positions.length / 3;
  const source: number[] = [];
  const tangents: number[] = [];
  /** The last vertex made of an old one, and from each the one before it. */
  const last = new Int32Array(vertices).fill(-1);
  const before: number[] = [];
  const indices = new Uint32Array(mesh.indices.length);
  for (let i = 0; i < indices.length; i++) {
    const vertex = mesh.indices[i]!;
    let made = last[vertex]!;
    while (made >= 0 && !isSame(tangents, 4 * made, corners, 4 * i)) made = before[made]!;
    if (made < 0) {
      made = source.length;
      source.push(vertex);
      before.push(last[vertex]!);
      last[vertex] = made;
      // glTF's v runs down, MikkTSpace's up: the frame has the other hand.
      tangents.push(corners[4 * i]!, corners[4 * i + 1]!, corners[4 * i + 2]!, -corners[4 * i + 3]!);
    }
    indices[i] = made;
  }
  return { ...rearranged(mesh, Uint32Array.from(source), indices), tangents: Float32Array.from(tangents) };
}

const isSame = (made: readonly number[], at: number, corners: Float32Array, i: number): boolean =>
  made[at + 3] === -corners[i + 3]! &&
  Math.abs(made[at]! - corners[i]!) < SAME &&
  Math.abs(made[at + 1]! - corners[i + 1]!) < SAME &&
  Math.abs(made[at + 2]! - corners[i + 2]!) < SAME;
