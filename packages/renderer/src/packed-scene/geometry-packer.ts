/** What packs meshes, with all that builds trees, comes when the first scene with some does: see scripts/lazy-parts.mjs. */
import type { Scene, Vec3 } from '../scene/scene.ts';
import { geometryRows } from './layout.ts';
import type { MeshInRow, PackedGeometry } from './pack-geometry.ts';
import { createBlock } from './write-struct.ts';

type Pack = (scene: Scene, shapes: readonly MeshInRow[], eye: Vec3) => PackedGeometry;

let pack: Pack | null = null;

export async function loadGeometryPacker(): Promise<void> {
  pack ??= (await import('./pack-geometry.ts')).packGeometry;
}
export const geometryPackerLoaded = (): boolean => pack !== null;

/** Throws when there are meshes and their packer has not been loaded. */
export function geometryOf(scene: Scene, shapes: readonly MeshInRow[], eye: Vec3): PackedGeometry {
  if (shapes.length === 0) return NO_GEOMETRY;
  if (pack === null) throw new Error('Meshes are to be packed, and loadGeometryPacker() has not been awaited.');
  return pack(scene, shapes, eye);
}

const rows = geometryRows('WideNode');
/** A root without children. */
const NO_GEOMETRY: PackedGeometry = {
  movingRows: rows,
  moving: createBlock(rows * 16),
  instances: 0,
  instanceCount: 0,
  meshes: [],
  rows,
};
