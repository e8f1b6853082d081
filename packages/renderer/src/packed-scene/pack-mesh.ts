/**
 * Mesh → its tree, its triangles and its vertices as the kernels read them. Triangles lie in the order of the tree's leaves, each with its
 * three places, so that a ray needs no indices until it is known where it ends. It is done once for each mesh, however many instances it
 * has.
 */

import { buildBvh } from '../bvh/build-bvh.ts';
import type { Bvh } from '../bvh/bvh.ts';
import type { Mesh } from '../scene/mesh.ts';
import { encodeWideBvh, MOST_IN_LEAF } from './encode-wide-bvh.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';
import { packVertices } from './pack-vertices.ts';
import type { PackedMesh } from './packed-mesh.ts';

const TRIANGLE_WORDS = geometryRows('Triangle') * GEOMETRY_ROW;
const PLACES = (['a', 'b', 'c'] as const).map((field) => fieldOffset('Triangle', field) / 4);
const NUMBERS = (['vertexA', 'vertexB', 'vertexC'] as const).map((field) => fieldOffset('Triangle', field) / 4);

/** A mesh does not change. */
const known = new WeakMap<Mesh, PackedMesh>();

export function packMesh(mesh: Mesh): PackedMesh {
  let packed = known.get(mesh);
  if (!packed) known.set(mesh, (packed = packWithTree(mesh, buildBvh(mesh, { maxLeafSize: MOST_IN_LEAF }))));
  return packed;
}

function packWithTree(mesh: Mesh, bvh: Bvh): PackedMesh {
  const { words: nodes, stackNeed } = encodeWideBvh(bvh);
  return { nodes, triangles: trianglesOf(mesh, bvh.order), vertices: packVertices(mesh), order: bvh.order, stackNeed };
}

function trianglesOf({ positions, indices }: Mesh, order: Uint32Array): Uint32Array<ArrayBuffer> {
  const words = new Uint32Array(order.length * TRIANGLE_WORDS);
  const floats = new Float32Array(words.buffer);
  for (let place = 0; place < order.length; place++) {
    const at = place * TRIANGLE_WORDS;
    const triangle = order[place]! * 3;
    for (let corner = 0; corner < 3; corner++) {
      const vertex = indices[triangle + corner]!;
      const to = at + PLACES[corner]!;
      floats[to] = positions[3 * vertex]!;
      floats[to + 1] = positions[3 * vertex + 1]!;
      floats[to + 2] = positions[3 * vertex + 2]!;
      words[at + NUMBERS[corner]!] = vertex;
    }
  }
  return words;
}
