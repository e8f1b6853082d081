/** Trees built in a worker; where none can be made, in slices on this thread. */
import { type BuildJob, type BuildMessage, buildAndTell } from './build-job.ts';
import type { Bvh, TriangleMesh } from './bvh.ts';
import BvhWorker from './bvh.worker.ts?worker&inline';
import type { SahOptions } from './split.ts';

export interface WorkerBuild {
  readonly options?: SahOptions;
  /** Gets a tree to trace with until the good one is there. It is the caller's. */
  readonly onFastTree?: (bvh: Bvh) => void;
  /** Gets the share that is done, 0 … 1, now and then. */
  readonly onProgress?: (done: number) => void;
  readonly signal?: AbortSignal;
}

/** Longest stretch of work on the main thread before it may handle events, milliseconds; a step may take longer. */
const SLICE_MS = 12;

/** Returns the tree when it is the good one; rejects what is no mesh. */
function take({ done, bvh, problem }: BuildMessage, { onFastTree, onProgress }: WorkerBuild): Bvh | null {
  if (problem !== undefined) throw new RangeError(problem);
  onProgress?.(done);
  if (bvh && done < 1) onFastTree?.(bvh);
  return done === 1 ? (bvh ?? null) : null;
}

/** Resolves with null when the worker could not be started at all. */
function buildInThisWorker(worker: Worker, job: BuildJob, build: WorkerBuild): Promise<Bvh | null> {
  return new Promise<Bvh | null>((resolve, reject) => {
    let started = false;
    build.signal?.addEventListener('abort', () => reject(build.signal?.reason), { once: true });
    worker.onmessage = ({ data }: MessageEvent<BuildMessage>) => {
      if (build.signal?.aborted) return;
      started = true;
      try {
        const bvh = take(data, build);
        if (bvh) resolve(bvh);
      } catch (error) {
        reject(error);
      }
    };
    worker.onerror = (event) => {
      // A policy of the page may refuse the worker's script; that shows here and not in the constructor.
      event.preventDefault();
      if (started) reject(new Error(`A tree could not be built in its worker: ${event.message}`));
      else resolve(null);
    };
    worker.postMessage(job);
  }).finally(() => worker.terminate());
}

async function buildInSlices(job: BuildJob, build: WorkerBuild): Promise<Bvh> {
  let sliceStart = performance.now();
  for (const message of buildAndTell(job)) {
    const bvh = take(message, build);
    build.signal?.throwIfAborted();
    if (bvh) return bvh;
    if (performance.now() - sliceStart < SLICE_MS) continue;
    await new Promise((resume) => setTimeout(resume, 0));
    build.signal?.throwIfAborted();
    sliceStart = performance.now();
  }
  throw new Error('A build ended without a tree');
}

function startWorker(): Worker | null {
  try {
    return new BvhWorker();
  } catch {
    return null;
  }
}

/**
 * Resolves with the tree that `buildBvh` gives. The mesh is copied for the worker and stays the caller's. Rejects with a RangeError
 * for what is no mesh, and with the signal's reason when `signal` is aborted.
 */
export async function buildBvhInWorker(mesh: TriangleMesh, build: WorkerBuild = {}): Promise<Bvh> {
  build.signal?.throwIfAborted();
  const job: BuildJob = { mesh, options: build.options, fastFirst: build.onFastTree !== undefined };
  const worker = startWorker();
  const bvh = worker && (await buildInThisWorker(worker, job, build));
  return bvh ?? buildInSlices(job, build);
}
