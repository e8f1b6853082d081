/** What a mesh gives its material at each point: columns of its PLY file, which Mitsuba calls attributes. */
import type { PlyColumn } from '../../mesh-file/ply/write-ply.ts';
import { AFFINE_LENGTH, cofactors, determinant, IDENTITY } from '../../scene/affine.ts';
import { type Mesh, vertexCount } from '../../scene/mesh.ts';
import { meshMatrices } from '../../scene/placed.ts';
import type { Material, MeshShape } from '../../scene/scene.ts';
import type { TextureUse } from '../../scene/textures.ts';

export interface Carried {
  readonly colors: boolean;
  readonly opacity: boolean;
  readonly secondSet: boolean;
  /** Of normal maps: what takes normals of the mesh into the world, row by row; null where there is no such frame. */
  readonly frame: readonly number[] | null;
}

/** What shapes that are no meshes have. */
export const NOTHING: Carried = { colors: false, opacity: false, secondSet: false, frame: null };

/** As an attribute of Mitsuba's. */
export const ATTRIBUTES = {
  colors: 'vertex_color',
  opacity: 'vertex_opacity',
  secondSet: 'vertex_uv1',
  normal: 'vertex_own_normal',
  tangent: 'vertex_own_tangent',
  hand: 'vertex_own_hand',
} as const;

export const isCut = ({ alphaMode = 'opaque' }: Material): boolean => alphaMode !== 'opaque';

/** The textures that are written. */
export function usesOf(m: Material): TextureUse[] {
  const { weightTexture, colorTexture } = m.specularLobe ?? {};
  const all = [m.baseColorTexture, m.metallicRoughnessTexture, m.normalTexture, m.emissionTexture, weightTexture, colorTexture]; // biome-ignore format: one list
  return all.filter((use) => use !== undefined);
}

export function carriedBy(shape: MeshShape, mesh: Mesh, material: Material): Carried {
  const { colors, normals, tangents } = mesh;
  const has = (wanted: (channel: number) => boolean) => colors?.some((x, i) => wanted(i % 4) && x !== 1) ?? false;
  const matrices = meshMatrices(shape, IDENTITY);
  const isBumpy = material.normalTexture !== undefined && normals !== undefined && tangents !== undefined;
  return {
    colors: has((channel) => channel < 3),
    opacity: isCut(material) && has((channel) => channel === 3),
    secondSet: usesOf(material).some(({ uvSet }) => uvSet === 1),
    frame: isBumpy && matrices.length === AFFINE_LENGTH ? normalsIntoWorld(matrices) : null,
  };
}

function normalsIntoWorld(matrix: Float64Array): number[] {
  const sign = Math.sign(determinant(matrix));
  const turn = cofactors(matrix, 0).map((x) => x * sign);
  const size = Math.hypot(...turn) || 1;
  return turn.map((x) => x / size);
}

/** Of the mesh's file, beside its places, normals and first coordinates. */
export function columnsOf(mesh: Mesh, { colors, opacity, secondSet, frame }: Carried): PlyColumn[] {
  const vertices = vertexCount(mesh);
  const of = (from: Float32Array, each: number, first: number, count: number) => Float32Array.from({ length: vertices * count }, (_, i) => from[Math.floor(i / count) * each + first + (i % count)]!); // biome-ignore format: one expression
  const columns: PlyColumn[] = [];
  if (colors) columns.push({ names: ['red', 'green', 'blue'], numbers: of(mesh.colors!, 4, 0, 3) });
  if (opacity) columns.push({ names: ['opacity_x'], numbers: of(mesh.colors!, 4, 3, 1) });
  if (secondSet) columns.push({ names: three('uv1'), numbers: padded(mesh.uvs?.[1], vertices) });
  if (frame)
    columns.push(
      { names: three('own_normal'), numbers: mesh.normals! },
      { names: three('own_tangent'), numbers: of(mesh.tangents!, 4, 0, 3) },
      { names: ['own_hand_x'], numbers: of(mesh.tangents!, 4, 3, 1) },
    );
  return columns;
}

const three = (name: string) => ['x', 'y', 'z'].map((axis) => `${name}_${axis}`);

/** Attributes have one number or three. */
const padded = (uv: Float32Array | undefined, vertices: number): Float32Array =>
  Float32Array.from({ length: 3 * vertices }, (_, i) => (i % 3 < 2 ? (uv?.[2 * Math.floor(i / 3) + (i % 3)] ?? 0) : 0));
