/** A mesh that is bent in a worker; in poses that did not come from there, on this thread. */
import type { Body } from '../scene/bodies.ts';
import type { Mesh } from '../scene/mesh.ts';
import { packMesh } from './pack-mesh.ts';
import type { PackedVertices } from './pack-vertices.ts';
import type { PackedMesh } from './packed-mesh.ts';
import type { OtherTree } from './pose-job.ts';
import { type FollowingMesh, PosedMesh } from './posed-mesh.ts';
import type { WorkerPoses } from './worker-poses.ts';

type Words = Uint32Array<ArrayBuffer>;

export class RemoteMesh implements FollowingMesh {
  nodes: Words;
  triangles: Words;
  vertices: PackedVertices;
  whole: Words | undefined = undefined;
  readonly order: Uint32Array;
  readonly stackNeed: number;
  revision = 0;
  box: ArrayLike<number> = [];
  readonly #poses: WorkerPoses;
  readonly #place: number;
  readonly #mesh: Mesh;
  readonly #tree: OtherTree | null;
  /** For poses that the worker has not sent. */
  #here: PosedMesh | null = null;
  #next: RemoteMesh | null = null;

  /** `place`: among all that bend. */
  constructor(poses: WorkerPoses, place: number, mesh: Mesh, tree: OtherTree | null = null) {
    const packed: PackedMesh = packMesh(mesh);
    this.#poses = poses;
    this.#place = place;
    this.#mesh = mesh;
    this.#tree = tree;
    this.nodes = packed.nodes;
    this.triangles = packed.triangles;
    this.vertices = packed.vertices;
    this.order = tree?.order ?? packed.order;
    this.stackNeed = tree?.stackNeed ?? packed.stackNeed;
  }

  pose(body: Body): void {
    const there = this.#poses.show(this.#place, body.pose!);
    const { words, box, tree } = there ?? this.#bendHere(body);
    if (there) this.#here = null;
    this.box = box;
    if (tree === this.#tree) this.#take(words);
    else {
      this.#next = new RemoteMesh(this.#poses, this.#place, this.#mesh, tree);
      this.#next.box = box;
      this.#next.#here = this.#here;
      this.#next.#take(words);
    }
  }

  #bendHere(body: Body) {
    this.#here ??= new PosedMesh(this.#mesh);
    this.#here.pose(body);
    return { words: this.#here.whole, box: this.#here.box, tree: null };
  }

  #take(words: Words): void {
    const nodes = this.#tree?.nodes ?? this.nodes.length;
    const end = nodes + (this.#tree?.triangles ?? this.triangles.length);
    this.whole = words;
    this.nodes = words.subarray(0, nodes);
    this.triangles = words.subarray(nodes, end);
    this.vertices = { ...this.vertices, words: words.subarray(end) };
    this.revision++;
  }

  renewed(): RemoteMesh | null {
    const next = this.#next;
    this.#next = null;
    return next;
  }
}
