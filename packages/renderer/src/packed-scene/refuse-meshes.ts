/**
 * No kernel traces meshes yet, and a picture without them would be a wrong one. When kernels can, this file goes, and with it the lines
 * that the compiler then points at.
 */
import type { Scene } from '../scene/scene.ts';

/** A scene that is good, and that what should draw it cannot. */
export class UntraceableSceneError extends Error {
  constructor(shape: string) {
    super(
      `The shape "${shape}" is a mesh, and this version traces meshes with the classic integrator on the CPU only, not on a GPU.`,
    );
    this.name = 'UntraceableSceneError';
  }
}

export function refuseMeshes({ shapes }: Scene): void {
  const mesh = Object.entries(shapes).find(([, { type }]) => type === 'mesh');
  if (mesh) throw new UntraceableSceneError(mesh[0]);
}
