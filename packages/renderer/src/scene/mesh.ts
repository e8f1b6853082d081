/**
 * Triangles, as plain arrays that nobody changes. A mesh has one material, which the shape that places it in the world names
 * (`MeshShape`); so what a file calls a mesh of several materials is several meshes here.
 */
export interface Mesh {
  /** x, y, z of each vertex, metres in the mesh's own space; all finite. */
  readonly positions: Float32Array;
  /** Three vertices a triangle, counter-clockwise seen from outside; all below the number of vertices. */
  readonly indices: Uint32Array;
  /** x, y, z of the shading normal at each vertex, of length 1. Left out: every triangle is flat. */
  readonly normals?: Float32Array;
  /** x, y, z of the tangent at each vertex and the handedness, ±1, of its bitangent cross(normal, tangent) · w. */
  readonly tangents?: Float32Array;
  /** Texture coordinates u, v of each vertex, (0, 0) in the image's upper left corner; at most two sets. */
  readonly uvs?: readonly Float32Array[];
  /** Linear r, g, b and opacity of each vertex, multiplied with the material's. */
  readonly colors?: Float32Array;
  /** What moves the vertices with the joints of a skeleton. */
  readonly skin?: SkinWeights;
  /** Shapes that may be added, each by a weight of its own. */
  readonly morphTargets?: readonly MorphTarget[];
}

/** Four joints a vertex, or eight: `joints.length / vertices`. */
export interface SkinWeights {
  /** Positions in the skin's list of joints. */
  readonly joints: Uint16Array;
  /** Of a vertex they add up to 1. */
  readonly weights: Float32Array;
}

/** What is added to each vertex, times the target's weight; same lengths as the mesh's own arrays, three a vertex. */
export interface MorphTarget {
  readonly positions?: Float32Array;
  readonly normals?: Float32Array;
  readonly tangents?: Float32Array;
}

/**
 * A mesh that shapes of the scene place in the world, as often as they like. Like the sky's image: a scene that has been read from a
 * text names the file, and `loadFiles` adds the content; one made by a program may have content without a file.
 */
export interface MeshSource {
  /** Name of a .ply, .obj or .stl file, from the scene file's folder on. */
  readonly file?: string;
  /** How normals come about; `data` has them as this says. Default: `auto`. */
  readonly shading?: MeshShading;
  readonly data?: Mesh;
}
/** `auto`: the file's normals, else flat. `smooth`: the file's, else made by blending those of the triangles. `flat`: none. */
export type MeshShading = 'auto' | 'smooth' | 'flat';

export const triangleCount = (mesh: Mesh): number => mesh.indices.length / 3;
export const vertexCount = (mesh: Mesh): number => mesh.positions.length / 3;
