/**
 * What packs meshes, their textures, and trees over many lights, with all that builds trees, comes when the first scene with some does: see
 * scripts/lazy-parts.mjs.
 */
import { type Mesh, triangleCount } from '../scene/mesh.ts';
import type { Moment } from '../scene/motion.ts';
import { meshShapes } from '../scene/placed.ts';
import type { Material, Scene, Vec3 } from '../scene/scene.ts';
import type { EmitterValues } from './emitter-values.ts';
import { geometryRows } from './layout.ts';
import type { LightTree } from './light-tree.ts';
import type * as PackGeometry from './pack-geometry.ts';
import type { BodyRows, PackedGeometry } from './pack-geometry.ts';
import type { Preparation } from './pack-in-worker.ts';
import type { PackOptions } from './pack-scene.ts';
import type { TextureRows } from './pack-textures.ts';
import type { PackedMesh } from './packed-mesh.ts';
import { hasMeshes } from './refuse-meshes.ts';
import { createBlock, type StructValues } from './write-struct.ts';

type Packer = typeof PackGeometry;

/** Not held here: a page whose models have all been left gives its code back. */
let packer: WeakRef<Packer> | null = null;
/** It stays as long as a mesh that it has packed: with its code would go what it knows of the mesh. */
const packerOf = new WeakMap<Mesh, Packer>();

/** Whoever wants to call what needs it holds it until then. */
export async function loadGeometryPacker(): Promise<Packer> {
  const loaded = geometryPacker() ?? (await import('./pack-geometry.ts'));
  packer = new WeakRef(loaded);
  return loaded;
}
/** Null until it has been loaded, and when nobody needed it any more. */
export const geometryPacker = (): Packer | null => packer?.deref() ?? null;

function hold(meshes: readonly Mesh[], packer: Packer): void {
  for (const mesh of meshes) packerOf.set(mesh, packer);
}

/** Each once. Those that bend get their trees for the form that they have in the scene: posed-mesh.ts. */
function meshesOf(scene: Scene): Mesh[] {
  const meshes = meshShapes(scene).map(([, { mesh }]) => scene.meshes?.[mesh]?.data);
  return [...new Set(meshes)].filter((mesh) => mesh !== undefined);
}

/** Whether nothing of the scene's meshes has to be waited for. */
export function areMeshesReady(scene: Scene): boolean {
  const meshes = meshesOf(scene);
  const packer = geometryPacker();
  return packer === null ? meshShapes(scene).length === 0 : meshes.every(packer.isPacked);
}

/** Resolves when nothing has to be waited for: trees are built, in a worker. */
export async function prepareMeshes(scene: Scene, preparation?: Preparation): Promise<void> {
  if (areMeshesReady(scene)) return;
  const packer = await loadGeometryPacker();
  const meshes = meshesOf(scene);
  await packer.packMeshes(meshes, preparation);
  hold(meshes, packer);
}

/** For who has got them packed by another thread. */
export async function keepMeshes(meshes: readonly (readonly [Mesh, PackedMesh])[]): Promise<void> {
  const packer = await loadGeometryPacker();
  for (const [mesh, packed] of meshes) packer.keepPacked(mesh, packed);
  hold(meshes.map(([mesh]) => mesh), packer); // biome-ignore format: short
}

/** Packs them on this thread, as a worker may, and gives them. `onProgress` gets the share that is done, 0 … 1. */
export async function packHere(scene: Scene, onProgress: (done: number) => void = () => {}) {
  const meshes = meshesOf(scene);
  if (meshes.length === 0) return [];
  const { packMesh } = await loadGeometryPacker();
  const all = meshes.reduce((sum, mesh) => sum + triangleCount(mesh), 0);
  let before = 0;
  return meshes.map((mesh) => {
    const packed = packMesh(mesh, (done) => onProgress((before + done * triangleCount(mesh)) / all));
    before += triangleCount(mesh);
    return [mesh, packed] as const;
  });
}

/** `packGeometry`. Throws when there are meshes and their packer has not been loaded. */
export function geometryOf(
  moment: Moment,
  rows: BodyRows,
  eye: Vec3,
  before: PackedGeometry | null,
  { deviceRows, poses }: Pick<PackOptions, 'deviceRows' | 'poses'> = {},
): PackedGeometry {
  return hasMeshes(moment.played) ? loaded().packGeometry(moment, rows, eye, before, deviceRows, poses) : NO_GEOMETRY;
}

/** `materials`: those of meshes. Throws likewise. */
export function texturesOf(scene: Scene, materials: readonly Material[]): TextureRows {
  return materials.length === 0 ? NO_TEXTURES : loaded().packTextures(scene, materials);
}

/** `layerValues`. Throws when the packer has not been loaded. */
export const layerValuesOf = (material: Material): StructValues<'Layers'> => loaded().layerValues(material);

/** `treeOfEmitters`. Throws when the packer has not been loaded. */
export const lightTreeOf = (emitters: readonly EmitterValues[], far: number): LightTree =>
  loaded().treeOfEmitters(emitters, far);

function loaded(): Packer {
  const packer = geometryPacker();
  if (packer === null)
    throw new Error('Meshes or many lights are to be packed, and loadGeometryPacker() has not been awaited.');
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
  lampTables: rows,
  tables: [],
  emitters: [],
  bending: null,
  rows,
};

/** No material asks. */
const NO_TEXTURES: TextureRows = {
  textures: { uses: createBlock(16), images: [], rows: 1 },
  rowOf: new Map(),
};
