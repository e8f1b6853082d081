/**
 * What a worker does that bends meshes for another thread: poses come in, packed meshes go out. The memory that words went out in comes back
 * with a later pose, so that frames ask for none.
 */
import { type Deformed, deform, makeDeformed, type Pose } from '../scene/deform.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { PackedMesh } from './packed-mesh.ts';
import { PosedMesh } from './posed-mesh.ts';

type Words = Uint32Array<ArrayBuffer>;

/** A mesh that bends, as it is told once. Bodies may share the object. */
export interface BentSource {
  readonly mesh: Mesh;
  readonly packed: PackedMesh;
}

/** A pose of one of them. */
export interface PoseOrder {
  /** Which, by its place among all. */
  readonly place: number;
  readonly pose: Pose;
  /** Memory that is to be written over. */
  readonly spare: Words | undefined;
}

/** The tree of a mesh, where it is not the one that it came with. */
export interface OtherTree {
  /** Words of its nodes, and of the triangles. */
  readonly nodes: number;
  readonly triangles: number;
  readonly order: Uint32Array;
  readonly stackNeed: number;
}

export interface PosedWords {
  readonly place: number;
  /** `PackedMesh.whole`. */
  readonly words: Words;
  /** Around the triangles, six numbers. */
  readonly box: readonly number[];
  /** Where it is another one than that of the words before. */
  readonly tree: OtherTree | undefined;
}

interface Bent {
  readonly mesh: Mesh;
  readonly form: Deformed;
  posed: PosedMesh;
}

export class PoseJob {
  readonly #bent: readonly Bent[];

  constructor(sources: readonly BentSource[]) {
    this.#bent = sources.map(({ mesh, packed }) => ({
      mesh,
      form: makeDeformed(mesh),
      posed: new PosedMesh(mesh, packed),
    }));
  }

  /** Throws a RangeError when a place is not finite. */
  bend({ place, pose, spare }: PoseOrder): PosedWords {
    const bent = this.#bent[place]!;
    deform(bent.mesh, pose, bent.form);
    bent.posed.pose(bent);
    const renewed = bent.posed.renewed(bent);
    if (renewed) bent.posed = renewed;
    const { whole, box, nodes, triangles, order, stackNeed } = bent.posed;
    const words = spare?.length === whole.length ? spare : new Uint32Array(whole.length);
    words.set(whole);
    const tree = renewed ? { nodes: nodes.length, triangles: triangles.length, order, stackNeed } : undefined;
    return { place, words, box: Array.from({ length: 6 }, (_, i) => box[i]!), tree };
  }
}
