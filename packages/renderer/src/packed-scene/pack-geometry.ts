/**
 * The meshes of a scene → the geometry, rows of four words: in row 0 the root of the tree over all instances, its other nodes, the
 * instances; then, mesh by mesh, the nodes of its tree, its triangles and its vertices. The first part is written for every frame that moves, in
 * coordinates relative to the eye; the second only when other meshes come in.
 */

import { type Bvh, firstPlace, leafCount } from '../bvh/bvh.ts';
import { InstanceTree } from '../bvh/instance-tree.ts';
import { AFFINE_LENGTH, IDENTITY, invertAffine, isSolid, type Numbers } from '../scene/affine.ts';
import { meshBounds, placedBounds } from '../scene/bounds.ts';
import type { Mesh } from '../scene/mesh.ts';
import { meshMatrices } from '../scene/placed.ts';
import type { MeshShape, Scene, Vec3 } from '../scene/scene.ts';
import { subtract } from '../scene/vec3.ts';
import type { EmitterValues } from './emitter-values.ts';
import { encodeWideBvh } from './encode-wide-bvh.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { GEOMETRY_ROW, geometryRows } from './layout.ts';
import { type LampTable, lampTable, meshEmitters } from './pack-lamps.ts';
import { packMesh } from './pack-mesh.ts';
import { type PackedMesh, wordsOf } from './packed-mesh.ts';
import { type Block, createBlock, writeStruct } from './write-struct.ts';

// Comes with what packs meshes: geometry-packer.ts.
export { packTextures } from './pack-textures.ts';

export interface PackedGeometry {
  /** Rows before those of the meshes: room for the tree over the instances, and for them. */
  readonly movingRows: number;
  /** What they hold. */
  readonly moving: Block;
  /** Row of the first instance, and how many there are. */
  readonly instances: number;
  readonly instanceCount: number;
  /** In the order in which their rows follow one another. */
  readonly meshes: readonly PackedMesh[];
  /** After them: row of the first table of lamps, and the tables. */
  readonly lampTables: number;
  readonly tables: readonly LampTable[];
  /** The emitters that a shape is, in the world, by its row of the scene table. */
  readonly lamps: ReadonlyMap<number, readonly EmitterValues[]>;
  /** All rows. */
  readonly rows: number;
}

export { treeOfEmitters } from './pack-light-tree.ts';

/** Rows of the longest stack in traverse.wesl. */
const STACK = 64;
const NODE_ROWS = geometryRows('WideNode');
const INSTANCE_ROWS = geometryRows('Instance');
const ROW_BYTES = GEOMETRY_ROW * 4;

/** A tree that leads deeper than a kernel can go: triangles by the thousand at one place, or nested to no end. */
export class DeepTreeError extends Error {
  override readonly name = 'DeepTreeError';
}

/** One instance. */
interface Placed {
  /** To the world, 12 numbers. */
  readonly placement: Numbers;
  readonly mesh: Mesh;
  /** Of the scene table. */
  readonly row: number;
  readonly glow: MeshGlow | null;
  readonly cover: number;
}

/** A mesh that stands in the world: `row` of the scene table says what it is made of; `glow`: how its light is sampled. */
export interface MeshInRow {
  readonly shape: MeshShape;
  readonly row: number;
  readonly glow: MeshGlow | null;
  /** `Instance.cover` */
  readonly cover: number;
}

/** `shapes`: those of the scene that are meshes; no node carries them any more (`placedSceneAt`). Every mesh has its data. */
export function packGeometry(scene: Scene, shapes: readonly MeshInRow[], eye: Vec3): PackedGeometry {
  const placed = shapes.flatMap((shape) => instancesOf(scene, shape));
  const meshes = new Map([...new Set(placed.map(({ mesh }) => mesh))].map((mesh) => [mesh, packMesh(mesh)]));
  // Up to twice the room that is needed, so that a few more instances move nothing.
  const room = 2 ** Math.ceil(Math.log2(Math.max(placed.length, 1)));
  const instances = room * NODE_ROWS;
  const movingRows = instances + room * INSTANCE_ROWS;
  const starts = new Map<Mesh, number>();
  let rows = movingRows;
  for (const [mesh, packed] of meshes) {
    starts.set(mesh, rows);
    rows += wordsOf(packed).reduce((sum, { length }) => sum + length, 0) / GEOMETRY_ROW;
  }
  const moving = createBlock(movingRows * ROW_BYTES);
  writeTree(moving, placed, eye, Math.max(0, ...[...meshes.values()].map(({ stackNeed }) => stackNeed)));
  placed.forEach(({ placement, mesh, row, cover }, i) => {
    const nodes = starts.get(mesh)!;
    const packed = meshes.get(mesh)!;
    const triangles = nodes + packed.nodes.length / GEOMETRY_ROW;
    writeStruct(moving, 'Instance', (instances + i * INSTANCE_ROWS) * ROW_BYTES, {
      ...rowsInto(placement, eye),
      nodes,
      triangles,
      row,
      cover,
      vertices: triangles + packed.triangles.length / GEOMETRY_ROW,
      vertexRows: packed.vertices.rows,
      vertexFlags: packed.vertices.flags,
    });
  });
  const glowing = lampsOf(placed, meshes);
  return {
    movingRows,
    moving,
    instances,
    instanceCount: placed.length,
    meshes: [...meshes.values()],
    lampTables: rows,
    ...glowing,
    rows: rows + glowing.tables.reduce((sum, { words }) => sum + words.length / GEOMETRY_ROW, 0),
  };
}

function lampsOf(placed: readonly Placed[], meshes: ReadonlyMap<Mesh, PackedMesh>) {
  const lamps = new Map<number, EmitterValues[]>();
  const starts = new Map<LampTable, number>();
  let rows = 0;
  placed.forEach(({ placement, mesh, row, glow }, instance) => {
    if (!glow) return;
    const table = lampTable(mesh, meshes.get(mesh)!, placement, glow.bits);
    if (!starts.has(table)) {
      starts.set(table, rows);
      rows += table.words.length / GEOMETRY_ROW;
    }
    const emitters = lamps.get(row) ?? [];
    emitters.push(...meshEmitters(glow, table, placement, { instance, table: starts.get(table)!, row }));
    lamps.set(row, emitters);
  });
  return { lamps, tables: [...starts.keys()] };
}

/** Those that have no thickness left, as a node scaled to nothing has, are not there. */
function instancesOf(scene: Scene, { shape, row, cover, glow }: MeshInRow): Placed[] {
  const mesh = dataOf(scene, shape);
  const matrices = meshMatrices(shape, IDENTITY);
  const placed: Placed[] = [];
  for (let at = 0; at < matrices.length; at += AFFINE_LENGTH) {
    const placement = matrices.subarray(at, at + AFFINE_LENGTH);
    if (isSolid(placement)) placed.push({ placement, mesh, row, cover, glow });
  }
  return placed;
}

function dataOf({ meshes = {} }: Scene, { mesh }: MeshShape): Mesh {
  const data = meshes[mesh]?.data;
  if (!data) throw new TypeError(`The mesh "${mesh}" has not been loaded.`);
  return data;
}

function writeTree(moving: Block, placed: readonly Placed[], eye: Vec3, deepest: number): void {
  const { words, stackNeed } = encodeWideBvh(treeOver(placed, eye));
  // One more to find the way back out of an instance.
  const need = stackNeed + 1 + deepest;
  if (need > STACK)
    throw new DeepTreeError(
      `A ray may have to remember ${need} nodes on its way through the meshes; kernels remember ${STACK}.`,
    );
  moving.u32.set(words);
}

/** Keeps its arrays from frame to frame; what it gives is encoded at once. */
const instanceTree = new InstanceTree();

/** Over the instances' boxes, relative to the eye; each instance is a leaf of its own, which names it. */
function treeOver(placed: readonly Placed[], eye: Vec3): Bvh {
  const boxes = new Float32Array(placed.length * 6);
  placed.forEach(({ placement, mesh }, i) => {
    const { min, max } = placedBounds(meshBounds(mesh), placement);
    boxes.set(subtract(min, eye), 6 * i);
    boxes.set(subtract(max, eye), 6 * i + 3);
  });
  const bvh = instanceTree.build(boxes, placed.length);
  for (let i = 0; i < bvh.nodeCount; i++) if (leafCount(bvh, i) > 0) bvh.links[2 * i] = bvh.order[firstPlace(bvh, i)]!;
  return bvh;
}

/** From places relative to the eye into the mesh, row by row; the way back is found in double precision. */
function rowsInto(placement: Numbers, eye: Vec3) {
  const back = invertAffine(Array.from(placement, (x, i) => (i % 4 < 3 ? x : x - eye[(i - 3) / 4]!)))!;
  return { toMeshX: back.slice(0, 4), toMeshY: back.slice(4, 8), toMeshZ: back.slice(8) };
}
