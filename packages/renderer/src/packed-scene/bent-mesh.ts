/**
 * A mesh that the device bends: here are its words at rest, which go there once, and how large it is now. Its tree is built for the form
 * that the scene gives it. When the device says that the tree has come to cost twice what it did, another is built for the form of the
 * moment, a step in each frame, as posed-mesh.ts does it with meshes that are bent on this thread.
 */
import type { Body } from '../scene/bodies.ts';
import type { Mesh } from '../scene/mesh.ts';
import { PoseBounds } from '../scene/pose-bounds.ts';
import { type NodeLevels, nodeLevels } from './node-levels.ts';
import { packInSteps, packMesh } from './pack-mesh.ts';
import type { PackedVertices } from './pack-vertices.ts';
import type { PackedMesh } from './packed-mesh.ts';
import { type FollowingMesh, WORN, WORTH } from './posed-mesh.ts';
import { treeCost } from './tree-cost.ts';

/** What follows from a packed mesh; bodies that share a mesh share it. */
interface Plan {
  readonly levels: NodeLevels;
  readonly cost: number;
}
const known = new WeakMap<Uint32Array, Plan>();

function planOf({ nodes }: PackedMesh): Plan {
  let plan = known.get(nodes);
  if (!plan) known.set(nodes, (plan = { levels: nodeLevels(nodes), cost: treeCost(nodes) }));
  return plan;
}

export class BentMesh implements FollowingMesh {
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly vertices: PackedVertices;
  readonly order: Uint32Array;
  readonly stackNeed: number;
  readonly revision = 0;
  readonly box = new Float64Array(6);
  readonly levels: NodeLevels;
  /** What the tree cost when it was built, and by what the device last said. */
  #firstCost: number;
  #cost = 0;
  readonly #bounds: PoseBounds;
  #building: Generator<number, PackedMesh, void> | null = null;

  /** `packed`: in any form of the body's mesh. */
  constructor(
    readonly body: Body,
    packed = packMesh(body.mesh),
    bounds = new PoseBounds(body.mesh, body.pose?.joints !== undefined),
  ) {
    this.nodes = packed.nodes;
    this.triangles = packed.triangles;
    this.vertices = packed.vertices;
    this.order = packed.order;
    this.stackNeed = packed.stackNeed;
    const { levels, cost } = planOf(packed);
    this.levels = levels;
    this.#firstCost = cost;
    this.#bounds = bounds;
  }

  get mesh(): Mesh {
    return this.body.mesh;
  }

  /** Finds a box around the form that the body has now. */
  pose(): void {
    this.#bounds.write(this.body.pose!, this.box);
  }

  /** What the tree costs in a form that it had some frames ago. */
  weighed(cost: number): void {
    this.#cost = cost;
  }

  renewed(): BentMesh | null {
    if (!this.#building && this.#cost <= WORN * this.#firstCost) return null;
    // The only time that its form is needed here.
    this.#building ??= packInSteps({ ...this.mesh, ...this.body.form!, positions: this.body.form!.positions.slice() });
    const { done, value } = this.#building.next();
    if (!done) return null;
    this.#building = null;
    const next = new BentMesh(this.body, value, this.#bounds);
    next.pose();
    if (next.#firstCost <= WORTH * this.#cost) return next;
    // Forms like this one have no better tree.
    this.#firstCost = this.#cost;
    return null;
  }
}
