/**
 * Into how many emitters a glowing mesh is cut. Each is a run of triangles in the order of the mesh's tree, as long as a power of two, so
 * that a triangle's number says which emitter it belongs to. Runs lie together, so the choice among them knows what is near.
 */
import { AFFINE_LENGTH } from '../scene/affine.ts';
import { emissionOf } from '../scene/lamps.ts';
import { triangleCount } from '../scene/mesh.ts';
import type { Color, MeshShape, Scene } from '../scene/scene.ts';

/** Shorter runs are not worth a place in the tree. */
const LEAST_BITS = 5;
/** Emitters of one instance at most; and of one shape, as long as each instance is one. */
const MOST_OF_INSTANCE = 64;
const MOST_OF_SHAPE = 1024;

export interface LampClusters {
  readonly instances: number;
  /** Emitters of one instance. */
  readonly clusters: number;
  /** Each has 2^bits triangles, the last one maybe fewer. */
  readonly bits: number;
  /** Of the mesh. */
  readonly triangles: number;
}

/** What a mesh is as a lamp. */
export interface MeshGlow extends LampClusters {
  readonly radiance: Color;
  /** Only the front of its triangles shines. */
  readonly oneSided: boolean;
}

export function cutLamp(triangles: number, instances: number): LampClusters {
  const most = Math.min(Math.max(Math.floor(MOST_OF_SHAPE / Math.max(instances, 1)), 1), MOST_OF_INSTANCE);
  let bits = LEAST_BITS;
  while (Math.ceil(triangles / 2 ** bits) > most) bits++;
  return { instances, clusters: Math.ceil(triangles / 2 ** bits), bits, triangles };
}

/** How a mesh that shines is cut; null for one that does not. */
export function clustersOf({ materials, meshes = {} }: Scene, shape: MeshShape): LampClusters | null {
  const mesh = meshes[shape.mesh]?.data;
  if (!mesh || Math.max(...emissionOf(materials[shape.material]!)) <= 0) return null;
  return cutLamp(triangleCount(mesh), shape.instances ? shape.instances.length / AFFINE_LENGTH : 1);
}
