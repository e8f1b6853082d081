/** A scene with its trees, on the way from a worker, where it was read, to the page that shows it: what is large goes over without a copy. */
import type { Mesh } from '../scene/mesh.ts';
import type { Scene } from '../scene/scene.ts';
import { adoptedScene } from '../scene-file/trusted-scenes.ts';
import { keepMeshes, packHere } from './geometry-packer.ts';
import type { PackedMesh } from './packed-mesh.ts';

/** Plain data that can be posted; a mesh here and in the scene is the same object, and stays so on the way. */
export interface PreparedScene {
  readonly scene: Scene;
  readonly meshes: readonly (readonly [Mesh, PackedMesh])[];
}

/** In the worker: packs the scene's meshes, on this thread. `onProgress` gets the share that is done, 0 … 1. */
export async function prepareScene(scene: Scene, onProgress?: (done: number) => void): Promise<PreparedScene> {
  return { scene, meshes: await packHere(scene, onProgress) };
}

/** All memory that the value's typed arrays stand on, to be transferred. What shares memory is there once. */
export function buffersOf(value: unknown): ArrayBuffer[] {
  const buffers = new Set<ArrayBuffer>();
  const seen = new Set<object>();
  const look = (part: unknown): void => {
    if (typeof part !== 'object' || part === null || seen.has(part)) return;
    seen.add(part);
    if (!ArrayBuffer.isView(part)) for (const inner of Object.values(part)) look(inner);
    else if (part.buffer instanceof ArrayBuffer) buffers.add(part.buffer);
  };
  look(value);
  return [...buffers];
}

/** On the page: the scene as good as it was in the worker. Only for what `prepareScene` has given there. */
export async function adoptScene({ scene, meshes }: PreparedScene): Promise<Scene> {
  if (meshes.length > 0) await keepMeshes(meshes);
  return adoptedScene(scene);
}
