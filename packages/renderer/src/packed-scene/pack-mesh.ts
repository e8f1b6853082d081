/**
 * Mesh → its tree, its triangles and its vertices as the kernels read them. Triangles lie in the order of the tree's leaves, each with its
 * three places, so that a ray needs no indices until it is known where it ends. It is done once for each mesh, however many instances it
 * has.
 */

import { buildInSteps } from '../bvh/build-bvh.ts';
import type { Bvh } from '../bvh/bvh.ts';
import type { Mesh } from '../scene/mesh.ts';
import { encodeWideBvh, MOST_IN_LEAF } from './encode-wide-bvh.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';
import { packVertices } from './pack-vertices.ts';
import type { PackedMesh } from './packed-mesh.ts';

const TRIANGLE_WORDS = geometryRows('Triangle') * GEOMETRY_ROW;
const PLACES = (['a', 'b', 'c'] as const).map((field) => fieldOffset('Triangle', field) / 4);
const NUMBERS = (['vertexA', 'vertexB', 'vertexC'] as const).map((field) => fieldOffset('Triangle', field) / 4);

const RULES = { maxLeafSize: MOST_IN_LEAF };

/** A mesh does not change. */
const known = new WeakMap<Mesh, PackedMesh>();

export const isPacked = (mesh: Mesh): boolean => known.has(mesh);

/** For who has packed it elsewhere. */
export const keepPacked = (mesh: Mesh, packed: PackedMesh): void => void known.set(mesh, packed);

/** At once, unless it has been done before. `onProgress` gets the share that is done, 0 … 1. */
export function packMesh(mesh: Mesh, onProgress: (done: number) => void = () => {}): PackedMesh {
  const before = known.get(mesh);
  if (before) return before;
  const steps = packInSteps(mesh);
  for (;;) {
    const { done, value } = steps.next();
    if (done) {
      keepPacked(mesh, value);
      return value;
    }
    onProgress(value);
  }
}

/** Yields the share that is done, 0 … 1. */
export function* packInSteps(mesh: Mesh): Generator<number, PackedMesh, void> {
  const steps = buildInSteps(mesh, RULES);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return packWithTree(mesh, value);
    yield 0.8 * value;
  }
}

function packWithTree(mesh: Mesh, bvh: Bvh): PackedMesh {
  const { words: nodes, stackNeed } = encodeWideBvh(bvh);
  const triangles = trianglesOf(mesh, bvh.order);
  return { nodes, triangles, vertices: packVertices(mesh), order: bvh.order, stackNeed, revision: 0 };
}

function trianglesOf({ positions, indices }: Mesh, order: Uint32Array): Uint32Array<ArrayBuffer> {
  const words = new Uint32Array(order.length * TRIANGLE_WORDS);
  for (let place = 0; place < order.length; place++)
    for (let corner = 0; corner < 3; corner++)
      words[place * TRIANGLE_WORDS + NUMBERS[corner]!] = indices[3 * order[place]! + corner]!;
  writePlaces(words, new Float32Array(words.buffer), positions);
  return words;
}

/** The places of all corners, by the vertices that the triangles name already. `floats`: the same memory as `words`. */
export function writePlaces(words: Uint32Array, floats: Float32Array, positions: Float32Array): void {
  // Numbers of this function, whose values the engine knows.
  const [numberA, numberB, numberC] = [NUMBERS[0]! | 0, NUMBERS[1]! | 0, NUMBERS[2]! | 0];
  const [placeA, placeB, placeC] = [PLACES[0]! | 0, PLACES[1]! | 0, PLACES[2]! | 0];
  for (let at = 0; at < words.length; at += TRIANGLE_WORDS | 0) {
    const a = 3 * words[at + numberA]!;
    const b = 3 * words[at + numberB]!;
    const c = 3 * words[at + numberC]!;
    floats[at + placeA] = positions[a]!;
    floats[at + placeA + 1] = positions[a + 1]!;
    floats[at + placeA + 2] = positions[a + 2]!;
    floats[at + placeB] = positions[b]!;
    floats[at + placeB + 1] = positions[b + 1]!;
    floats[at + placeB + 2] = positions[b + 2]!;
    floats[at + placeC] = positions[c]!;
    floats[at + placeC + 1] = positions[c + 1]!;
    floats[at + placeC + 2] = positions[c + 2]!;
  }
}
