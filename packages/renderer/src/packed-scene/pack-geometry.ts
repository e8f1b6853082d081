/**
 * The meshes of a scene → the geometry, rows of four words: in row 0 the root of the tree over all instances, its other nodes, the
 * instances; then, mesh by mesh, the nodes of its tree, its triangles and its vertices. The first part is written for every frame that moves, in
 * coordinates relative to the eye; a mesh only when it comes in, or when its form changes. Arrays are kept from frame to frame.
 */

import { type Bvh, sahCost } from '../bvh/bvh.ts';
import { InstanceTree } from '../bvh/instance-tree.ts';
import { Bodies, type Body } from '../scene/bodies.ts';
import { meshBounds } from '../scene/bounds.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { Moment } from '../scene/motion.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { Bending, mostPlanRows } from './bending.ts';
import { BentMesh } from './bent-mesh.ts';
import type { EmitterValues } from './emitter-values.ts';
import { WideEncoder } from './encode-wide-bvh.ts';
import { type InstancedMesh, InstanceRows, SHARED } from './instance-rows.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { GEOMETRY_ROW, geometryRows } from './layout.ts';
import { MeshLamps } from './mesh-lamps.ts';
import type { LampTable } from './pack-lamps.ts';
import { packMesh } from './pack-mesh.ts';
import { type PackedMesh, wordsOf } from './packed-mesh.ts';
import { type FollowingMesh, PosedMesh } from './posed-mesh.ts';
import { RemoteMesh } from './remote-mesh.ts';
import type { WorkerPoses } from './worker-poses.ts';
import { type Block, createBlock } from './write-struct.ts';

// Comes with the rest of what meshes need.
export { sketchInSteps } from '../sketch/sketch.ts';
export { layerValues } from './layer-values.ts';
export { packMeshes } from './pack-in-worker.ts';
export { treeOfEmitters } from './pack-light-tree.ts';
export { isPacked, keepPacked, packMesh } from './pack-mesh.ts';
export { packTextures } from './pack-textures.ts';
export { workerPoses } from './worker-poses.ts';

export interface PackedGeometry {
  /** Rows before those of the meshes: room for the tree over the instances, and for them. */
  readonly movingRows: number;
  /** What they hold. */
  readonly moving: Block;
  /** Row of the first instance, and how many there are. */
  readonly instances: number;
  readonly instanceCount: number;
  /** Rows of the tree over them that are in use. */
  readonly treeRows: number;
  /** Grows when `moving` is written anew; and the rows of instances that were written then, up to but not including the second. */
  readonly revision: number;
  readonly changedInstances: readonly [begin: number, end: number];
  /** In the order in which their rows follow one another. */
  readonly meshes: readonly PackedMesh[];
  /** Row of the first table of lamps, after the meshes, and all tables. */
  readonly lampTables: number;
  readonly tables: readonly LampTable[];
  /** What shines among the meshes, in the world. Another object when it is worked out anew. */
  readonly emitters: readonly EmitterValues[];
  /** For the meshes that the device is to bend; null: there are none. Another object when other meshes are, or lie elsewhere. */
  readonly bending: Bending | null;
  /** All rows. */
  readonly rows: number;
}

/** A tree over instances follows them until it costs so many times what it did when it was built: docs/motion.md. */
const FOLLOWED = 1.1;
/** Rows of the longest stack in traverse.wesl. */
const STACK = 64;
const NODE_ROWS = geometryRows('WideNode');
const INSTANCE_ROWS = geometryRows('Instance');
const ROW_BYTES = GEOMETRY_ROW * 4;

/** A tree that leads deeper than a kernel can go: triangles by the thousand at one place, or nested to no end. */
export class DeepTreeError extends Error {
  override readonly name = 'DeepTreeError';
}

/** What the meshes of a scene are made of. */
export interface BodyRows {
  /** Of the scene table, for the first of them; the others follow. */
  readonly first: number;
  /** `Instance.cover` of each. */
  readonly covers: readonly number[];
  /** How the light of each is sampled; null: it does not shine, or only rays find its light. */
  readonly glows: readonly (MeshGlow | null)[];
}

/**
 * `rows`: of the bodies of the scene that plays. `before`: a geometry that is no longer needed; when it
 * is of the same scene it is brought up to date and given back. `deviceRows`: of the data that a device takes which bends meshes itself; where
 * they do not suffice, and by default, meshes are bent here, or in a worker where there are `poses` of this scene.
 */
export function packGeometry(
  { played, time }: Pick<Moment, 'played' | 'time'>,
  rows: BodyRows,
  eye: Vec3,
  before: PackedGeometry | null = null,
  deviceRows = 0,
  poses: WorkerPoses | null = null,
): PackedGeometry {
  const isSame = (geometry: GeometryOfScene) => geometry.scene === played && geometry.deviceRows === deviceRows && geometry.poses === poses; // biome-ignore format: one thought
  const mine = before instanceof GeometryOfScene && isSame(before);
  const geometry = mine ? before : new GeometryOfScene(played, deviceRows, poses);
  geometry.update(time, rows, eye);
  return geometry;
}

/** A body and its mesh in the geometry. */
class PackedBody implements InstancedMesh {
  readonly box = new Float64Array(6);
  boxChanged = false;
  rowChanged = true;
  readonly shared = new Uint32Array(SHARED.length);
  #poseRevision = -1;

  /** `mesh`: one that follows the body if the body bends. */
  constructor(
    readonly body: Body,
    public mesh: PackedMesh,
  ) {
    const { min, max } = meshBounds(body.mesh);
    this.box.set([...min, ...max]);
  }

  /** Where its parts lie, and what it is made of. */
  share(values: Partial<Record<(typeof SHARED)[number], number>>): void {
    SHARED.forEach((field, k) => {
      const value = values[field] ?? this.shared[k]!;
      if (value !== this.shared[k]) this.rowChanged = true;
      this.shared[k] = value;
    });
  }

  /** Takes another mesh that follows the body. */
  follow(mesh: FollowingMesh): void {
    this.mesh = mesh;
    this.#poseRevision = -1;
  }

  /** Takes the form that the body has now. Returns whether that has led to another `mesh`. */
  update(): boolean {
    const { body } = this;
    this.boxChanged = body.pose !== null && body.poseRevision !== this.#poseRevision;
    if (!this.boxChanged) return false;
    this.#poseRevision = body.poseRevision;
    const mesh = this.mesh as FollowingMesh;
    mesh.pose(body);
    for (let i = 0; i < 6; i++) this.box[i] = mesh.box[i]!;
    const renewed = mesh.renewed(body);
    if (renewed) this.mesh = renewed;
    return renewed !== null;
  }
}

class GeometryOfScene implements PackedGeometry {
  readonly movingRows: number;
  readonly moving: Block;
  readonly instances: number;
  meshes: readonly PackedMesh[] = [];
  bending: Bending | null = null;
  lampTables = 0;
  readonly changedInstances: [number, number] = [0, 0];
  treeRows = 0;
  revision = 0;
  readonly #bodies: Bodies;
  #time = Number.NaN;
  #bodyRows: BodyRows | null = null;
  readonly #packed: readonly PackedBody[];
  readonly #bent: readonly PackedBody[];
  /** Whether the device bends those that do not shine. */
  readonly #onDevice: boolean;
  /** Of each instance. */
  readonly #meshOf: readonly PackedBody[];
  readonly #instanceRows: InstanceRows;
  #deepest = 0;
  readonly #builder = new InstanceTree();
  readonly #encoder = new WideEncoder();
  readonly #lamps = new MeshLamps();
  /** The one in use, what it cost when it was built, and whether it is a good one for where the boxes are. */
  #tree: Bvh | null = null;
  #treeCost = 0;
  #isGood = false;

  constructor(
    readonly scene: Scene,
    readonly deviceRows: number,
    readonly poses: WorkerPoses | null,
  ) {
    const bodies = new Bodies(scene);
    this.#bodies = bodies;
    const bending = bodies.all.filter(({ pose }) => pose !== null).map(({ mesh }) => mesh);
    const onDevice = mostPlanRows(bending) <= deviceRows;
    const shared = new Map<Mesh, PackedMesh>();
    let place = 0;
    const meshOf = (body: Body): PackedMesh => {
      const { pose, mesh } = body;
      if (pose !== null && onDevice) return new BentMesh(body);
      if (pose !== null) return poses ? new RemoteMesh(poses, place++, mesh) : new PosedMesh(mesh);
      if (!shared.has(mesh)) shared.set(mesh, packMesh(mesh));
      return shared.get(mesh)!;
    };
    this.#packed = bodies.all.map((body) => new PackedBody(body, meshOf(body)));
    this.#bent = this.#packed.filter(({ body }) => body.pose !== null);
    this.#onDevice = onDevice;
    this.#meshOf = this.#packed.flatMap((packed) => new Array<PackedBody>(packed.body.count).fill(packed));
    // Up to twice the room that is needed, so that a few more instances in the next scene move no meshes.
    const room = 2 ** Math.ceil(Math.log2(Math.max(this.#meshOf.length, 1)));
    this.instances = room * NODE_ROWS;
    this.movingRows = this.instances + room * INSTANCE_ROWS;
    this.moving = createBlock(this.movingRows * ROW_BYTES);
    this.#placeMeshes();
    this.#instanceRows = new InstanceRows(this.moving, this.instances * ROW_BYTES, this.#meshOf.length);
  }

  #placeMeshes(): void {
    this.meshes = [...new Set(this.#packed.map(({ mesh }) => mesh))];
    this.#deepest = this.meshes.reduce((most, { stackNeed }) => Math.max(most, stackNeed), 0);
    const starts = new Map<PackedMesh, number>();
    let rows = this.movingRows;
    for (const mesh of this.meshes) {
      starts.set(mesh, rows);
      rows += wordsOf(mesh).reduce((sum, { length }) => sum + length, 0) / GEOMETRY_ROW;
    }
    for (const packed of this.#packed) {
      const { mesh } = packed;
      const nodes = starts.get(mesh)!;
      const triangles = nodes + mesh.nodes.length / GEOMETRY_ROW;
      packed.share({
        nodes,
        triangles,
        vertices: triangles + mesh.triangles.length / GEOMETRY_ROW,
        vertexRows: mesh.vertices.rows,
        vertexFlags: mesh.vertices.flags,
      });
    }
    this.lampTables = rows;
    const bent = this.meshes.filter((mesh) => mesh instanceof BentMesh);
    this.bending = bent.length > 0 ? new Bending(bent.map((mesh) => ({ mesh, row: starts.get(mesh)! }))) : null;
  }

  get instanceCount(): number {
    return this.#instanceRows.count;
  }

  get rows(): number {
    return this.lampTables + this.#lamps.rows;
  }
  get tables(): readonly LampTable[] {
    return this.#lamps.tables;
  }
  get emitters(): readonly EmitterValues[] {
    return this.#lamps.emitters;
  }

  /** Throws a `DeepTreeError`; then the geometry is of no use any more. */
  update(time: number, bodyRows: BodyRows, eye: Vec3): void {
    if (time !== this.#time) this.#bodies.goTo(time);
    this.#time = time;
    const otherRows = bodyRows !== this.#bodyRows;
    let renewed = otherRows && this.#take(bodyRows);
    for (const packed of this.#bent) renewed = packed.update() || renewed;
    if (renewed) this.#placeMeshes();
    this.bending?.update();
    const rows = this.#instanceRows;
    const before = rows.count;
    const news = rows.update(this.#bodies.matrices, this.#meshOf, eye);
    if (otherRows || news === 'instances') this.#lamps.update(this.#packed, bodyRows.glows, this.#bodies.matrices, bodyRows.first); // biome-ignore format: one thought
    this.#forgetChanges();
    const kept = this.revision > 0 && rows.changedTo === 0;
    if (kept && news === 'nothing' && this.#isGood) return;
    // Nobody goes down a tree over one instance, which changes its form.
    if (kept && rows.count === 1 && before === 1) return;
    if (news !== 'nothing' || !this.#isGood) this.#growTree(news);
    this.changedInstances[0] = this.instances + rows.changedFrom * INSTANCE_ROWS;
    this.changedInstances[1] = this.instances + Math.max(rows.changedTo, rows.changedFrom) * INSTANCE_ROWS;
    this.revision++;
  }

  #forgetChanges(): void {
    for (const packed of this.#packed) packed.rowChanged = false;
  }

  /** Returns whether meshes have been replaced: the triangles of lamps must be known here. */
  #take(bodyRows: BodyRows): boolean {
    this.#bodyRows = bodyRows;
    this.#packed.forEach((packed, i) => {
      packed.share({ row: bodyRows.first + i, cover: bodyRows.covers[i]! });
    });
    if (!this.#onDevice) return false;
    let replaced = false;
    for (const packed of this.#bent) {
      const shines = (bodyRows.glows[this.#packed.indexOf(packed)] ?? null) !== null;
      if (shines === packed.mesh instanceof PosedMesh) continue;
      packed.follow(shines ? new PosedMesh(packed.body.mesh) : new BentMesh(packed.body));
      replaced = true;
    }
    return replaced;
  }

  /**
   * The first tree is a good one, and so is that of things which have come to rest; the eye may then move as it likes. While things move the
   * tree follows them, and when that has made it a worse one a quick one is built.
   */
  #growTree(news: string): void {
    const { boxes, count } = this.#instanceRows;
    const moving = news === 'instances' && this.revision > 0;
    if (moving && this.#follow()) return;
    const quick = moving ? this.#builder.buildQuickly(boxes, count) : null;
    if (quick && this.#encode(quick)) this.#keep(quick, false);
    else this.#keep(this.#goodTree(news), true);
  }

  #keep(tree: Bvh, isGood: boolean): void {
    this.#tree = tree;
    this.#treeCost = sahCost(tree);
    this.#isGood = isGood;
  }

  /** Fits the tree in use to other boxes. False when it is not worth it, or over another number of them. */
  #follow(): boolean {
    const { boxes, count } = this.#instanceRows;
    if (this.#tree?.primitiveCount !== count) return false;
    const tree = this.#builder.refit(this.#tree, boxes);
    if (!(sahCost(tree) <= FOLLOWED * this.#treeCost)) return false;
    this.#encoder.fit(tree, this.moving.f32);
    this.#isGood = false;
    return true;
  }

  #goodTree(news: string): Bvh {
    const { boxes, count } = this.#instanceRows;
    const keepsOrder = this.#isGood && news === 'eye';
    const tree = keepsOrder ? this.#builder.refit(this.#tree!, boxes) : this.#builder.build(boxes, count);
    if (!this.#encode(tree))
      throw new DeepTreeError(
        `A ray may have to remember ${this.#stackNeed} nodes on its way through the meshes; kernels remember ${STACK}.`,
      );
    return tree;
  }

  /** One more to find the way back out of an instance, and one at the bottom, where the ray ends. */
  get #stackNeed(): number {
    return 1 + this.#encoder.stackNeed + 1 + this.#deepest;
  }

  /** False when it leads too deep. */
  #encode(tree: Bvh): boolean {
    const { nodeCount } = this.#encoder.encode(tree, this.moving.u32, this.moving.f32, true);
    this.treeRows = nodeCount * NODE_ROWS;
    return this.#stackNeed <= STACK;
  }
}
