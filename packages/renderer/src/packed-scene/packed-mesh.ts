/** A mesh as the geometry holds it. What makes one, and builds trees, is in pack-mesh.ts and comes later. */
import type { PackedVertices } from './pack-vertices.ts';

export interface PackedMesh {
  /** Rows of the tree's nodes, the root's first. */
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly vertices: PackedVertices;
  /** All of these, where they lie behind one another: a device takes one piece sooner than three. */
  readonly whole?: Uint32Array<ArrayBuffer>;
  /** Which triangle of the mesh stands at each place. */
  readonly order: Uint32Array;
  readonly stackNeed: number;
  /** Grows when the words are written anew. */
  readonly revision: number;
}

/** The same memory. */
export const floatsOf = ({ buffer, byteOffset, length }: Uint32Array<ArrayBuffer>): Float32Array<ArrayBuffer> =>
  new Float32Array(buffer, byteOffset, length);

/** What it puts into the geometry, in this order. */
export const wordsOf = ({ nodes, triangles, vertices, whole }: PackedMesh): readonly Uint32Array<ArrayBuffer>[] =>
  whole ? [whole] : [nodes, triangles, vertices.words];
