/** A mesh as the geometry holds it. What makes one, and builds trees, is in pack-mesh.ts and comes later. */
import type { PackedVertices } from './pack-vertices.ts';

export interface PackedMesh {
  /** Rows of the tree's nodes, the root's first. */
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly vertices: PackedVertices;
  /** Which triangle of the mesh stands at each place. */
  readonly order: Uint32Array;
  readonly stackNeed: number;
  /** Grows when the words are written anew. */
  readonly revision: number;
}

/** What it puts into the geometry, in this order. */
export const wordsOf = ({ nodes, triangles, vertices }: PackedMesh) => [nodes, triangles, vertices.words] as const;
