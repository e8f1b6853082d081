/**
 * Meshes bent in a worker, for pictures that go on meanwhile: whoever draws asks for a moment and gets the last one of which all poses are
 * there. A mesh has three pieces of memory, which change places: what is shown, what has come since, and what the worker writes. What is asked
 * for otherwise, as a still at a time of its own, is worked out on this thread, and so is all when there is no worker.
 */
import { Bodies, type Body } from '../scene/bodies.ts';
import type { Pose } from '../scene/deform.ts';
import { triangleCount } from '../scene/mesh.ts';
import type { Moment } from '../scene/motion.ts';
import type { Scene } from '../scene/scene.ts';
import { mostPlanRows } from './bending.ts';
import type { PosesMessage } from './pack.worker.ts';
import { startWorker } from './pack-in-worker.ts';
import { packMesh } from './pack-mesh.ts';
import type { BentSource, OtherTree, PosedWords, PoseOrder } from './pose-job.ts';

type Words = Uint32Array<ArrayBuffer>;

/** So many triangles are bent in little more time than it takes to tell a worker: docs/motion.md. */
const AT_ONCE = 4000;
/** A mesh in a pose. */
export interface Posed {
  readonly pose: Pose;
  readonly words: Words;
  readonly box: readonly number[];
  /** Null: the tree that the mesh came with. */
  readonly tree: OtherTree | null;
}

/** What is known of a mesh that bends. */
interface Place {
  /** As the worker has last sent it. */
  newest: Posed | null;
  /** As it is shown, if the worker has sent that. */
  shown: Posed | null;
  readonly spares: Words[];
}

/** Somebody wanted this moment; wishes are numbered one after the other. */
interface Wish {
  readonly moment: Moment;
  readonly number: number;
}

function equal(a: ArrayLike<number> = [], b: ArrayLike<number> = []): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}
const isIn = (posed: Posed | null, { weights, joints }: Pose): posed is Posed =>
  posed !== null && equal(posed.pose.weights, weights) && equal(posed.pose.joints, joints);

/**
 * Those for a scene that is to be played; null where there is little to bend, or the device does it. `before`: gone on with if it is of the
 * same meshes, else ended.
 */
export function workerPoses(scene: Scene, deviceRows: number, before: WorkerPoses | null): WorkerPoses | null {
  const bodies = new Bodies(scene);
  const meshes = bentOf(bodies).map(({ mesh }) => mesh);
  const triangles = meshes.reduce((sum, mesh) => sum + triangleCount(mesh), 0);
  const needed = triangles > AT_ONCE && mostPlanRows(meshes) > deviceRows;
  if (needed && before?.play(bodies)) return before;
  before?.end();
  return needed ? new WorkerPoses(bodies) : null;
}

const bentOf = ({ all }: Bodies): Body[] => all.filter(({ pose }) => pose !== null);

export class WorkerPoses {
  #bodies: Bodies;
  #bent: readonly Body[];
  readonly #places: readonly Place[];
  /** The last moment of which the worker has sent all poses, and the last one that was to be drawn. */
  #complete: Wish | null = null;
  #drawn: Wish | null = null;
  /** What the worker is at; null: nothing. */
  #asked: (Wish & { readonly poses: ReadonlyMap<number, Pose> }) | null = null;
  #wishes = 0;
  /** Whether it has ever answered. */
  #isUp = false;
  /** Null: there is none, and all is left to this thread. */
  #worker: Worker | null;

  constructor(bodies: Bodies) {
    this.#bodies = bodies;
    this.#bent = bentOf(bodies);
    this.#places = this.#bent.map(() => ({ newest: null, shown: null, spares: [] }));
    this.#worker = this.#start();
  }

  /** What bending needs goes there once. */
  #start(): Worker | null {
    const worker = startWorker();
    if (!worker) return null;
    worker.onmessage = ({ data }: MessageEvent<PosesMessage>) => {
      // What is wrong shows again, and is told, where this thread does it.
      if ('problem' in data) this.end();
      else this.#take(data.posed);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.end();
    };
    const sources = new Map<object, BentSource>();
    for (const { mesh } of this.#bent) {
      const { uvs: _, colors: __, ...needed } = mesh;
      if (!sources.has(mesh)) sources.set(mesh, { mesh: needed, packed: packMesh(mesh) });
    }
    worker.postMessage({ bend: this.#bent.map(({ mesh }) => sources.get(mesh)!) });
    return worker;
  }

  /** Goes on with another scene. False, and nothing is changed, when that bends other meshes. */
  play(bodies: Bodies): boolean {
    const bent = bentOf(bodies);
    const isSame = bent.length === this.#bent.length && bent.every(({ mesh }, i) => mesh === this.#bent[i]!.mesh);
    if (!isSame || !this.#worker) return false;
    this.#bodies = bodies;
    this.#bent = bent;
    return true;
  }

  /**
   * The moment to draw when this one is wanted: itself if its poses are there, or if there is none that could be drawn meanwhile; else the last
   * one that can. Pictures do not go back to what was wanted earlier.
   */
  at(moment: Moment): Moment {
    if (!this.#worker) return moment;
    const wish = { moment, number: ++this.#wishes };
    this.#bodies.goTo(moment.time);
    const others = this.#bent.flatMap(({ pose }, i) => (isIn(this.#places[i]!.newest, pose!) ? [] : [i]));
    if (others.length === 0) this.#complete = wish;
    else if (!this.#asked) this.#ask(wish, others);
    const [complete, drawn] = [this.#complete, this.#drawn].map((one) => (one?.moment.played === moment.played ? one : null)); // biome-ignore format: one thought
    if (complete && complete.number > (drawn?.number ?? 0)) this.#drawn = complete;
    // Then this thread does it, as it does until the worker is up.
    else if (!drawn || !this.#isUp) this.#drawn = wish;
    return this.#drawn!.moment;
  }

  #ask(wish: Wish, places: readonly number[]): void {
    const orders = places.map((i): PoseOrder => {
      const place = this.#places[i]!;
      const spare = place.spares.pop();
      const { weights, joints } = this.#bent[i]!.pose!;
      // The body's own arrays may be written over.
      return { place: i, pose: { weights: weights?.slice(), joints: joints?.slice() }, spare };
    });
    this.#asked = { ...wish, poses: new Map(orders.map(({ place, pose }) => [place, pose])) };
    const transfer = orders.flatMap(({ spare }) => (spare ? [spare.buffer] : []));
    this.#worker!.postMessage(orders, transfer);
  }

  #take(all: readonly PosedWords[]): void {
    // Ended while this was on its way.
    if (!this.#asked) return;
    const { poses } = this.#asked;
    this.#complete = this.#asked;
    this.#asked = null;
    this.#isUp = true;
    for (const { place: i, words, box, tree } of all) {
      const place = this.#places[i]!;
      const before = place.newest;
      place.newest = { pose: poses.get(i)!, words, box, tree: tree ?? before?.tree ?? null };
      if (before && before !== place.shown) place.spares.push(before.words);
    }
  }

  /** A mesh in this pose, which is shown from now on; null: this thread is to bend it. The words of the one before are written over. */
  show(i: number, pose: Pose): Posed | null {
    const place = this.#places[i]!;
    const posed = [place.newest, place.shown].find((one) => isIn(one, pose)) ?? null;
    if (posed === null || posed === place.shown) return posed;
    if (place.shown) place.spares.push(place.shown.words);
    place.shown = posed;
    return posed;
  }

  /** Ends the worker and gives the memory back; what is asked for afterwards is worked out on this thread. */
  end(): void {
    this.#worker?.terminate();
    this.#worker = null;
    this.#asked = null;
    this.#complete = null;
    this.#drawn = null;
    for (const place of this.#places) {
      place.newest = null;
      place.shown = null;
      place.spares.length = 0;
    }
  }
}
