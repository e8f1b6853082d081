/**
 * Still pictures by the double-precision tracer: in a worker, or, where none can be made, in slices on this thread.
 * Knows no canvas; gives film.
 */
import type { RendererSettings } from '../renderer-types.ts';
import type { Camera, Scene } from '../scene/scene.ts';
import { isWorthShowing, renderProgressively, type StillJob, type StillStart } from './progressive.ts';
import type { StillMessage } from './reference.worker.ts';
import ReferenceWorker from './reference.worker.ts?worker&inline';

export { posedSceneAt } from '../scene/posed.ts';

export interface StillSettings
  extends Pick<RendererSettings, 'maxReflections' | 'lightSamples' | 'seed' | 'comparison'> {
  /** Default: the whole picture. */
  readonly framing?: RendererSettings['framing'];
  /** Film samples a pixel, at least 1. */
  readonly samples: number;
  /** A finished film of the same picture with fewer samples, to go on from. */
  readonly start?: StillStart;
}
/** Called with the film so far, coarse first, and the share of the work that is done. The film is the caller's. */
export type OnStillProgress = (film: Float32Array<ArrayBuffer>, done: number) => void;

/** Longest stretch of work on the main thread before it may handle events, milliseconds. */
const SLICE_MS = 12;

/** Resolves with the film, or with null when the worker could not be started at all. */
function renderInWorker(worker: Worker, job: StillJob, onProgress: OnStillProgress, signal?: AbortSignal) {
  return new Promise<Float32Array<ArrayBuffer> | null>((resolve, reject) => {
    let started = false;
    signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    worker.onmessage = ({ data }: MessageEvent<StillMessage>) => {
      if (signal?.aborted) return;
      started = true;
      if (data.done === 1) resolve(data.film);
      else onProgress(data.film, data.done);
    };
    worker.onerror = (event) => {
      // A policy of the page may refuse the worker's script; that shows here and not in the constructor.
      event.preventDefault();
      if (started) reject(new Error(`The reference tracer failed in its worker: ${event.message}`));
      else resolve(null);
    };
    worker.postMessage(job);
  }).finally(() => worker.terminate());
}

async function renderInSlices(job: StillJob, onProgress: OnStillProgress, signal?: AbortSignal) {
  let film = new Float32Array();
  let shownAt = performance.now();
  let sliceStart = shownAt;
  for (const progress of renderProgressively(job)) {
    film = progress.film;
    const now = performance.now();
    if (progress.done < 1 && isWorthShowing(progress, now - shownAt)) {
      onProgress(film.slice(), progress.done);
      shownAt = now;
    }
    if (now - sliceStart < SLICE_MS) continue;
    await new Promise((resume) => setTimeout(resume, 0));
    signal?.throwIfAborted();
    sliceStart = performance.now();
  }
  return film;
}

/** Nothing but what the tracer needs: a setting may hold what cannot be posted to a worker. */
function stillPart(settings: StillSettings): StillSettings {
  const { maxReflections, lightSamples, seed, comparison, framing, samples, start } = settings;
  return { maxReflections, lightSamples, seed, comparison, framing, samples, start };
}

function startWorker(): Worker | null {
  try {
    return new ReferenceWorker();
  } catch {
    return null;
  }
}

/**
 * `scene` is already animated to the time that is wanted. Resolves with the finished film: width × height × (linear
 * RGB, film samples), row 0 on top. Rejects with the signal's reason when `signal` is aborted.
 */
export async function renderStill(
  scene: Scene,
  camera: Camera,
  settings: StillSettings,
  width: number,
  height: number,
  onProgress: OnStillProgress = () => {},
  signal?: AbortSignal,
): Promise<Float32Array<ArrayBuffer>> {
  signal?.throwIfAborted();
  const job: StillJob = { scene, camera, width, height, ...stillPart(settings) };
  const worker = startWorker();
  const film = worker && (await renderInWorker(worker, job, onProgress, signal));
  return film ?? renderInSlices(job, onProgress, signal);
}
