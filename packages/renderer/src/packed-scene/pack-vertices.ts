/**
 * What a mesh has at its vertices beside their places, as the kernels read it where a ray ends: one row, or two for meshes with colours or
 * a second set of texture coordinates (structs `Vertex` and `VertexMore` of layout.ts). They stand in the order of the mesh: triangles,
 * which the tree puts in order, name them by number, and a vertex that six triangles share is there once.
 */
import { type Mesh, vertexCount } from '../scene/mesh.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows, VERTEX_FLAGS } from './layout.ts';
import { toOctahedral } from './octahedral.ts';

export interface PackedVertices {
  readonly words: Uint32Array<ArrayBuffer>;
  /** Rows of each; 0: nothing but places. */
  readonly rows: number;
  readonly flags: number;
}

const NORMAL = fieldOffset('Vertex', 'normal') / 4;
const TANGENT = fieldOffset('Vertex', 'tangent') / 4;
const UV = fieldOffset('Vertex', 'uv') / 4;
const MORE = geometryRows('Vertex') * GEOMETRY_ROW;
const RED_GREEN = MORE + fieldOffset('VertexMore', 'redGreen') / 4;
const BLUE_ALPHA = MORE + fieldOffset('VertexMore', 'blueAlpha') / 4;
const SECOND_UV = MORE + fieldOffset('VertexMore', 'uv') / 4;
/** Lowest bit of an octahedral vector’s second number: such a vector is off by at most 1.4e-4 radians. */
const LEFT_HANDED = 0x10000;
const WHITE = 0xffffffff;

export function packVertices(mesh: Mesh): PackedVertices {
  const { normals, tangents, uvs = [], colors } = mesh;
  const rows = rowsOf(mesh);
  const stride = rows * GEOMETRY_ROW;
  const words = new Uint32Array(vertexCount(mesh) * stride);
  const floats = new Float32Array(words.buffer);
  if (rows === 0) return { words, rows, flags: 0 };
  if (normals) writeNormals(words, stride, normals);
  if (tangents) writeTangents(words, stride, tangents);
  writePairs(floats, UV, stride, uvs[0]);
  if (rows > geometryRows('Vertex')) {
    writeColors(words, stride, colors);
    writePairs(floats, SECOND_UV, stride, uvs[1]);
  }
  const flags = (normals ? VERTEX_FLAGS.hasNormals : 0) | (tangents ? VERTEX_FLAGS.hasTangents : 0);
  return { words, rows, flags };
}

/** Writes what changes when a mesh is bent over that of the mesh before. */
export function writeForm(
  { words, rows }: PackedVertices,
  { normals, tangents }: Pick<Mesh, 'normals' | 'tangents'>,
): void {
  if (normals) writeNormals(words, rows * GEOMETRY_ROW, normals);
  if (tangents) writeTangents(words, rows * GEOMETRY_ROW, tangents);
}

function rowsOf({ normals, uvs = [], colors }: Mesh): number {
  const more = colors || uvs.length > 1 ? geometryRows('VertexMore') : 0;
  return more + (more || normals || uvs.length > 0 ? geometryRows('Vertex') : 0);
}

function writeNormals(words: Uint32Array, stride: number, normals: Float32Array): void {
  for (let at = NORMAL, from = 0; from < normals.length; at += stride, from += 3)
    words[at] = toOctahedral(normals, from);
}

function writeTangents(words: Uint32Array, stride: number, tangents: Float32Array): void {
  for (let at = TANGENT, from = 0; from < tangents.length; at += stride, from += 4) {
    const code = toOctahedral(tangents, from) & ~LEFT_HANDED;
    words[at] = tangents[from + 3]! < 0 ? code | LEFT_HANDED : code;
  }
}

function writePairs(floats: Float32Array, first: number, stride: number, uv: Float32Array | undefined): void {
  if (!uv) return;
  for (let at = first, from = 0; from < uv.length; at += stride, from += 2) {
    floats[at] = uv[from]!;
    floats[at + 1] = uv[from + 1]!;
  }
}

/**
 * Linear numbers 0 … 1 in 16 bits: those of 8 and 16 bits that files have are held exactly, and a linear 8 bits would show steps in the
 * dark.
 */
function writeColors(words: Uint32Array, stride: number, colors: Float32Array | undefined): void {
  const code = (x: number) => Math.round(Math.min(Math.max(x, 0), 1) * 0xffff);
  const count = words.length / stride;
  for (let vertex = 0; vertex < count; vertex++) {
    const at = vertex * stride;
    const from = 4 * vertex;
    words[at + RED_GREEN] = colors ? code(colors[from]!) | (code(colors[from + 1]!) << 16) : WHITE;
    words[at + BLUE_ALPHA] = colors ? code(colors[from + 2]!) | (code(colors[from + 3]!) << 16) : WHITE;
  }
}
