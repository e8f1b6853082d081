/**
 * What packs meshes and trees over many lights, with all that builds trees, comes when the first scene with some does: see
 * scripts/lazy-parts.mjs.
 */
import type { Scene, Vec3 } from '../scene/scene.ts';
import type { EmitterValues } from './emitter-values.ts';
import { geometryRows } from './layout.ts';
import type { LightTree } from './light-tree.ts';
import type { MeshInRow, PackedGeometry } from './pack-geometry.ts';
import { createBlock } from './write-struct.ts';

let packer: typeof import('./pack-geometry.ts') | null = null;

export async function loadGeometryPacker(): Promise<void> {
  packer ??= await import('./pack-geometry.ts');
}
export const geometryPackerLoaded = (): boolean => packer !== null;

function loaded(): NonNullable<typeof packer> {
  if (packer === null) throw new Error('Meshes or many lights are to be packed, and loadGeometryPacker() has not been awaited.'); // biome-ignore format: one sentence
  return packer;
}

/** Throws when there are meshes and their packer has not been loaded. */
export function geometryOf(scene: Scene, shapes: readonly MeshInRow[], eye: Vec3): PackedGeometry {
  return shapes.length === 0 ? NO_GEOMETRY : loaded().packGeometry(scene, shapes, eye);
}

/** Throws when the packer has not been loaded. */
export const lightTreeOf = (emitters: readonly EmitterValues[], far: number): LightTree =>
  loaded().treeOfEmitters(emitters, far);

const rows = geometryRows('WideNode');
/** A root without children. */
const NO_GEOMETRY: PackedGeometry = {
  movingRows: rows,
  moving: createBlock(rows * 16),
  instances: 0,
  instanceCount: 0,
  meshes: [],
  lampTables: rows,
  tables: [],
  lamps: new Map(),
  rows,
};
