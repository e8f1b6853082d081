/**
 * A mesh that joints and weights bend. Its tree is built once, for the form that the scene gives it; for every other form the boxes are
 * fitted to the triangles and written over the old ones. Triangles keep their places, so that the same form is the same words whatever
 * came before it.
 */
import type { Bvh } from '../bvh/bvh.ts';
import { planRefit, type RefitPlan, refit } from '../bvh/refit.ts';
import type { Deformed } from '../scene/deform.ts';
import type { Mesh } from '../scene/mesh.ts';
import { writeBoxes } from './encode-wide-bvh.ts';
import { packWithTree, type TreeOfMesh, treeFor, writePlaces } from './pack-mesh.ts';
import { type PackedVertices, writeForm } from './pack-vertices.ts';
import type { PackedMesh } from './packed-mesh.ts';

interface Planned extends TreeOfMesh {
  readonly plan: RefitPlan;
}
/** Bodies that share a mesh share its tree. */
const known = new WeakMap<Mesh, Planned>();

function treeOf(mesh: Mesh): Planned {
  let tree = known.get(mesh);
  if (!tree) {
    const bvh = treeFor(mesh);
    known.set(mesh, (tree = { ...packWithTree(mesh, bvh), plan: planRefit(bvh, mesh) }));
  }
  return tree;
}

export class PosedMesh implements PackedMesh {
  readonly nodes: Uint32Array<ArrayBuffer>;
  readonly triangles: Uint32Array<ArrayBuffer>;
  readonly vertices: PackedVertices;
  readonly order: Uint32Array;
  readonly stackNeed: number;
  revision = 0;
  /** With bounds of its own. */
  readonly bvh: Bvh;
  readonly #tree: Planned;
  readonly #nodeFloats: Float32Array;
  readonly #triangleFloats: Float32Array;

  constructor(mesh: Mesh) {
    const tree = treeOf(mesh);
    this.#tree = tree;
    this.nodes = tree.packed.nodes.slice();
    this.triangles = tree.packed.triangles.slice();
    this.vertices = { ...tree.packed.vertices, words: tree.packed.vertices.words.slice() };
    this.order = tree.packed.order;
    this.stackNeed = tree.packed.stackNeed;
    this.bvh = { ...tree.bvh, bounds: tree.bvh.bounds.slice() };
    this.#nodeFloats = new Float32Array(this.nodes.buffer);
    this.#triangleFloats = new Float32Array(this.triangles.buffer);
  }

  /** Takes another form. Throws a RangeError when a place in it is not finite. */
  pose(form: Deformed): void {
    const { plan, sources } = this.#tree;
    refit(this.bvh, form.positions, plan);
    writeBoxes(sources, sources.length / 4, this.bvh, this.#nodeFloats);
    writePlaces(this.triangles, this.#triangleFloats, form.positions);
    writeForm(this.vertices, form);
    this.revision++;
  }

  /** The box around its triangles, six numbers: least x, y, z, greatest x, y, z. */
  get box(): ArrayLike<number> {
    return this.bvh.bounds;
  }
}
