/** What packs meshes, with all that builds trees, comes when the first scene with some does: see scripts/lazy-parts.mjs. */
import type { Moment } from '../scene/motion.ts';
import type { Vec3 } from '../scene/scene.ts';
import { geometryRows } from './layout.ts';
import type { PackedGeometry } from './pack-geometry.ts';
import { hasMeshes } from './refuse-meshes.ts';
import { createBlock } from './write-struct.ts';

type Pack = (moment: Moment, firstRow: number, eye: Vec3, before: PackedGeometry | null) => PackedGeometry;

let pack: Pack | null = null;

export async function loadGeometryPacker(): Promise<void> {
  pack ??= (await import('./pack-geometry.ts')).packGeometry;
}
export const geometryPackerLoaded = (): boolean => pack !== null;

/** `packGeometry`. Throws when there are meshes and their packer has not been loaded. */
export function geometryOf(moment: Moment, firstRow: number, eye: Vec3, before: PackedGeometry | null): PackedGeometry {
  if (!hasMeshes(moment.played)) return NO_GEOMETRY;
  if (pack === null) throw new Error('Meshes are to be packed, and loadGeometryPacker() has not been awaited.');
  return pack(moment, firstRow, eye, before);
}

const rows = geometryRows('WideNode');
/** A root without children. */
const NO_GEOMETRY: PackedGeometry = {
  movingRows: rows,
  moving: createBlock(rows * 16),
  instances: 0,
  instanceCount: 0,
  treeRows: rows,
  revision: 0,
  changedInstances: [0, 0],
  meshes: [],
  rows,
};
