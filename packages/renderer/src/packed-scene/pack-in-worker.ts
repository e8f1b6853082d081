/** Meshes packed in a worker; where none can be made, in slices on this thread. */
import { type Mesh, triangleCount } from '../scene/mesh.ts';
import type { PackMessage } from './pack.worker.ts';
import PackWorker from './pack.worker.ts?worker&inline';
import { isPacked, keepPacked, packInSteps, packMesh } from './pack-mesh.ts';

export interface Preparation {
  /** Gets the share that is done, 0 … 1, now and then. */
  readonly onProgress?: (done: number) => void;
  readonly signal?: AbortSignal;
}

/** So many triangles are packed in less time than a worker takes to start. */
const AT_ONCE = 10_000;
/** Longest stretch of work on the main thread before it may handle events, milliseconds; a step may take longer. */
const SLICE_MS = 12;

/**
 * Resolves when `packMesh` has each of them at hand. They are copied for the worker and stay the caller's. Rejects with a RangeError for
 * what is no mesh, and with the signal's reason when that is aborted.
 */
export async function packMeshes(meshes: readonly Mesh[], preparation: Preparation = {}): Promise<void> {
  preparation.signal?.throwIfAborted();
  const todo = [...new Set(meshes)].filter((mesh) => !isPacked(mesh));
  const triangles = todo.reduce((sum, mesh) => sum + triangleCount(mesh), 0);
  if (triangles <= AT_ONCE) {
    for (const mesh of todo) packMesh(mesh);
    return;
  }
  const progress = new Progress(todo, triangles, preparation);
  const worker = startWorker();
  if (!worker || !(await packThere(worker, progress, preparation))) await packHere(progress, preparation);
}

/** How far all of them are; each counts by its triangles. */
class Progress {
  readonly meshes: readonly Mesh[];
  readonly #all: number;
  readonly #tell: (done: number) => void;
  #packed = 0;
  #at = 0;

  constructor(meshes: readonly Mesh[], all: number, { onProgress = () => {} }: Preparation) {
    this.meshes = meshes;
    this.#all = all;
    this.#tell = onProgress;
  }

  /** The one that is being packed; undefined when all are. */
  get current(): Mesh | undefined {
    return this.meshes[this.#at];
  }
  step(done: number): void {
    this.#tell((this.#packed + done * triangleCount(this.current!)) / this.#all);
  }
  next(): void {
    this.#packed += triangleCount(this.current!);
    this.#at++;
    this.#tell(this.#packed / this.#all);
  }
}

/** Null where a page may have none; what else is in its way shows as an error of the worker. */
export function startWorker(): Worker | null {
  try {
    return new PackWorker();
  } catch {
    return null;
  }
}

/** Resolves with false when the worker could not be started at all. */
function packThere(worker: Worker, progress: Progress, { signal }: Preparation): Promise<boolean> {
  return new Promise<boolean>((resolve, reject) => {
    let started = false;
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.onmessage = ({ data }: MessageEvent<PackMessage>) => {
      if (signal?.aborted) return;
      started = true;
      if ('problem' in data) return reject(new RangeError(data.problem));
      if ('done' in data) return progress.step(data.done);
      keepPacked(progress.current!, data.packed);
      progress.next();
      if (!progress.current) resolve(true);
    };
    worker.onerror = (event) => {
      // A policy of the page may refuse the worker's script; that shows here and not in the constructor.
      event.preventDefault();
      if (started) reject(new Error(`Meshes could not be packed in their worker: ${event.message}`));
      else resolve(false);
    };
    worker.postMessage(progress.meshes.map(({ skin: _, morphTargets: __, ...mesh }) => mesh));
  }).finally(() => worker.terminate());
}

async function packHere(progress: Progress, { signal }: Preparation): Promise<void> {
  let sliceStart = performance.now();
  for (let mesh = progress.current; mesh; mesh = progress.current) {
    const steps = packInSteps(mesh);
    for (;;) {
      const { done, value } = steps.next();
      if (done) {
        keepPacked(mesh, value);
        break;
      }
      progress.step(value);
      if (performance.now() - sliceStart < SLICE_MS) continue;
      await new Promise((resume) => setTimeout(resume, 0));
      signal?.throwIfAborted();
      sliceStart = performance.now();
    }
    progress.next();
  }
}
