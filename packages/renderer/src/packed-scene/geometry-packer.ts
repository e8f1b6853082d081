/**
 * What packs meshes, with all that builds trees, and their textures comes when the first scene with some does: see
 * scripts/lazy-parts.mjs.
 */
import type { Moment } from '../scene/motion.ts';
import type { Material, Scene, Vec3 } from '../scene/scene.ts';
import { geometryRows } from './layout.ts';
import type * as Packing from './pack-geometry.ts';
import type { BodyRows, PackedGeometry } from './pack-geometry.ts';
import type { TextureRows } from './pack-textures.ts';
import { hasMeshes } from './refuse-meshes.ts';
import { createBlock } from './write-struct.ts';

type Packer = Pick<typeof Packing, 'packGeometry' | 'packTextures'>;

let packer: Packer | null = null;

export async function loadGeometryPacker(): Promise<void> {
  packer ??= await import('./pack-geometry.ts');
}
export const geometryPackerLoaded = (): boolean => packer !== null;

/** `packGeometry`. Throws when there are meshes and their packer has not been loaded. */
export function geometryOf(moment: Moment, rows: BodyRows, eye: Vec3, before: PackedGeometry | null): PackedGeometry {
  return hasMeshes(moment.played) ? loaded().packGeometry(moment, rows, eye, before) : NO_GEOMETRY;
}

/** `materials`: those of meshes. Throws likewise. */
export function texturesOf(scene: Scene, materials: readonly Material[]): TextureRows {
  return materials.length === 0 ? NO_TEXTURES : loaded().packTextures(scene, materials);
}

function loaded(): Packer {
  if (packer === null) throw new Error('Meshes are to be packed, and loadGeometryPacker() has not been awaited.');
  return packer;
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

/** No material asks. */
const NO_TEXTURES: TextureRows = {
  textures: { uses: createBlock(16), images: [], rows: 1 },
  rowOf: new Map(),
};
