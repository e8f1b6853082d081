/**
 * A mesh that joints and weights bend. Its tree is built once, for the form that the scene gives it; for every other form the boxes are
 * fitted to the triangles and written over the old ones. Triangles keep their places, so that the same form is the same words whatever
 * came before it. Only where the tree becomes a bad one, as that of triangles which all began at one place, another is built for the form
 * of the moment, a step in each frame. Rays hit the same triangles in any tree.
 */
import { type Bvh, sahCost } from '../bvh/bvh.ts';
import { planRefit, type RefitPlan, refit } from '../bvh/refit.ts';
import type { Body } from '../scene/bodies.ts';
import type { Deformed } from '../scene/deform.ts';
import type { Mesh } from '../scene/mesh.ts';
import { type DecodedBvh, decodeWideBvh } from './decode-wide-bvh.ts';
import { writeBoxes } from './encode-wide-bvh.ts';
import { packInSteps, packMesh, writePlaces } from './pack-mesh.ts';
import { type PackedVertices, writeForm } from './pack-vertices.ts';
import { floatsOf, type PackedMesh, wordsOf } from './packed-mesh.ts';

/** A tree is built anew when it costs so many times what it did at first: docs/motion.md says what meshes come to. */
export const WORN = 2;
/** The new one is taken if it costs at most this share of the other. */
export const WORTH = 0.9;

/** A mesh that follows the pose of a body. */
export interface FollowingMesh extends PackedMesh {
  /** The box around its triangles, six numbers: least x, y, z, greatest x, y, z. */
  readonly box: ArrayLike<number>;
  /** Takes the form that the body has now. Throws a RangeError when a place in it is not finite. */
  pose(body: Body): void;
  /** Call it after `pose`: gives another mesh in the same form once there is one with a better tree, and else null. */
  renewed(body: Body): FollowingMesh | null;
}

/** What follows from a packed mesh: its tree, and the vertices of each leaf. */
interface Plan extends DecodedBvh {
  readonly vertices: RefitPlan;
}
/** Bodies that share a mesh share it. */
const known = new WeakMap<PackedMesh, Plan>();

function planOf(packed: PackedMesh, mesh: Mesh): Plan {
  let plan = known.get(packed);
  if (!plan) {
    const decoded = decodeWideBvh(packed.nodes, packed.order);
    known.set(packed, (plan = { ...decoded, vertices: planRefit(decoded.bvh, mesh) }));
  }
  return plan;
}

type Words = Uint32Array<ArrayBuffer>;

/** Copies of them in one piece of memory. */
function joined(from: readonly Words[]): { readonly whole: Words; readonly parts: readonly Words[] } {
  const whole = new Uint32Array(from.reduce((sum, { length }) => sum + length, 0));
  let end = 0;
  const parts = from.map((words) => {
    const part = whole.subarray(end, end + words.length);
    part.set(words);
    end += words.length;
    return part;
  });
  return { whole, parts };
}

export class PosedMesh implements FollowingMesh {
  readonly whole: Uint32Array<ArrayBuffer>;
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly vertices: PackedVertices;
  readonly order: Uint32Array;
  readonly stackNeed: number;
  revision = 0;
  /** With bounds of its own. */
  readonly bvh: Bvh;
  readonly #plan: Plan;
  readonly #nodeFloats: Float32Array;
  readonly #triangleFloats: Float32Array;

  readonly #mesh: Mesh;
  /** What the tree cost when it was built. */
  #firstCost: number;
  #cost = 0;
  /** The next one, and the form that its tree is built for. */
  #building: { readonly steps: Generator<number, PackedMesh, void>; readonly positions: Float32Array } | null = null;

  /** `packed`: for the mesh in the form of `positions`. */
  constructor(mesh: Mesh, packed = packMesh(mesh), positions = mesh.positions) {
    this.#mesh = mesh;
    this.#plan = planOf(packed, mesh);
    const { whole, parts } = joined(wordsOf(packed));
    const [nodes, triangles, vertices] = parts as [Words, Words, Words];
    this.whole = whole;
    this.nodes = nodes;
    this.triangles = triangles;
    this.vertices = { ...packed.vertices, words: vertices };
    this.order = packed.order;
    this.stackNeed = packed.stackNeed;
    this.bvh = { ...this.#plan.bvh, bounds: this.#plan.bvh.bounds.slice() };
    this.#nodeFloats = floatsOf(nodes);
    this.#triangleFloats = floatsOf(triangles);
    refit(this.bvh, positions, this.#plan.vertices);
    this.#firstCost = sahCost(this.bvh);
  }

  pose({ form }: Pick<Body, 'form'>): void {
    this.#take(form!);
  }

  #take(form: Deformed): void {
    const { vertices, sources } = this.#plan;
    refit(this.bvh, form.positions, vertices);
    writeBoxes(sources, sources.length / 4, this.bvh, this.#nodeFloats);
    writePlaces(this.triangles, this.#triangleFloats, form.positions);
    writeForm(this.vertices, form);
    this.#cost = sahCost(this.bvh);
    this.revision++;
  }

  renewed({ form }: Pick<Body, 'form'>): PosedMesh | null {
    if (!this.#building && this.#cost <= WORN * this.#firstCost) return null;
    this.#building ??= this.#startBuilding(form!.positions.slice());
    const { done, value } = this.#building.steps.next();
    if (!done) return null;
    const { positions } = this.#building;
    this.#building = null;
    const next = new PosedMesh(this.#mesh, value, positions);
    next.#take(form!);
    if (next.#cost <= WORTH * this.#cost) return next;
    // Forms like this one have no better tree.
    this.#firstCost = this.#cost;
    return null;
  }

  #startBuilding(positions: Float32Array) {
    return { steps: packInSteps({ ...this.#mesh, positions }), positions };
  }

  get box(): ArrayLike<number> {
    return this.bvh.bounds;
  }
}
