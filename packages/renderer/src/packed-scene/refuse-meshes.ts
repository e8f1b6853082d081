/** The classic integrator's kernels trace no meshes, and a picture without them would be a wrong one. */
import type { Scene } from '../scene/scene.ts';

/** A scene that is good, and that what should draw it cannot. */
export class UntraceableSceneError extends Error {
  override readonly name = 'UntraceableSceneError';
}

/** Asked in every frame; a scene may have a thousand shapes, and it does not change. */
const known = new WeakMap<Scene['shapes'], boolean>();

export function hasMeshes({ shapes }: Scene): boolean {
  let found = known.get(shapes);
  if (found === undefined) known.set(shapes, (found = Object.values(shapes).some(({ type }) => type === 'mesh')));
  return found;
}

export function refuseMeshes({ shapes }: Scene): void {
  const mesh = Object.entries(shapes).find(([, { type }]) => type === 'mesh');
  if (mesh)
    throw new UntraceableSceneError(
      `The shape "${mesh[0]}" is a mesh; on a GPU only the path integrator traces meshes ("render": { "integrator": "path" }).`,
    );
}
