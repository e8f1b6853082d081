/**
 * A still picture from coarse to fine: every 8th pixel first, then every 4th, 2nd, all of them, each traced once with
 * film sample 0; then the other film samples, one pass each. A generator, so that whoever drives it decides when to
 * pause: the worker runs it straight on, the main thread in slices.
 */
import type { Comparison, Framing } from '../renderer-types.ts';
import type { Camera, Color, Scene } from '../scene/scene.ts';
import { type ClassicTracer, prepareClassic, traceSample } from './classic.ts';

/** Everything a still picture depends on; plain data that can be posted to a worker. */
export interface StillJob {
  /** Already animated to the time that is wanted. */
  readonly scene: Scene;
  readonly camera: Camera;
  readonly width: number;
  readonly height: number;
  readonly maxReflections: number;
  readonly lightSamples: number;
  readonly seed: number;
  readonly comparison: Comparison | null;
  readonly framing?: Framing | null;
  /** Film samples a pixel in the end, at least 1. */
  readonly samples: number;
  /** A finished film of the same picture with fewer samples, to go on from. */
  readonly start?: StillStart;
}
export interface StillStart {
  readonly film: Float32Array<ArrayBuffer>;
  /** In each of its pixels. */
  readonly samples: number;
}
/** The film so far; the generator goes on writing to it. */
export interface StillProgress {
  /** width × height × (linear RGB, film samples taken), row 0 on top; 0 samples: borrowed from a coarser pixel. */
  readonly film: Float32Array<ArrayBuffer>;
  /** Share of all film samples to be taken that are done, 0 … 1. */
  readonly done: number;
  /** Whether a whole pass has just been finished. */
  readonly passDone: boolean;
}

const COARSEST = 8;

/** Fills the block that pixel (i, j) stands for. The pixels that get their own value later are overwritten then. */
function fillBlock(film: Float32Array, job: StillJob, i: number, j: number, step: number, color: Color): void {
  for (let y = j; y < Math.min(j + step, job.height); y++) {
    for (let x = i; x < Math.min(i + step, job.width); x++) {
      film.set(color, (y * job.width + x) * 4);
    }
  }
  film[(j * job.width + i) * 4 + 3] = 1;
}

/** Row j of the pass with this step: the pixels of its grid that no coarser pass has traced. */
function traceCoarseRow(tracer: ClassicTracer, job: StillJob, film: Float32Array, j: number, step: number): number {
  const inCoarserRow = step < COARSEST && j % (2 * step) === 0;
  let traced = 0;
  for (let i = inCoarserRow ? step : 0; i < job.width; i += inCoarserRow ? 2 * step : step) {
    fillBlock(film, job, i, j, step, traceSample(tracer, i, j, 0));
    traced++;
  }
  return traced;
}

/** Adds film sample s to the running means of row j. */
function refineRow(tracer: ClassicTracer, film: Float32Array, j: number, s: number): void {
  for (let i = 0; i < tracer.width; i++) {
    const at = (j * tracer.width + i) * 4;
    traceSample(tracer, i, j, s).forEach((value, channel) => {
      film[at + channel]! += (value - film[at + channel]!) / (s + 1);
    });
    film[at + 3] = s + 1;
  }
}

/** Yields after each row. */
export function* renderProgressively(job: StillJob): Generator<StillProgress, void> {
  const { width, height, start } = job;
  const tracer = prepareClassic(job.scene, job);
  const film = start ? start.film.slice() : new Float32Array(width * height * 4);
  const total = width * height * (job.samples - (start?.samples ?? 0));
  let traced = 0;
  for (let step = start ? 0 : COARSEST; step >= 1; step /= 2) {
    for (let j = 0; j < height; j += step) {
      traced += traceCoarseRow(tracer, job, film, j, step);
      yield { film, done: traced / total, passDone: j + step >= height };
    }
  }
  for (let s = start?.samples ?? 1; s < job.samples; s++) {
    for (let j = 0; j < height; j++) {
      refineRow(tracer, film, j, s);
      traced += width;
      yield { film, done: traced / total, passDone: j === height - 1 };
    }
  }
}

/** Thins out progress: whether this one is worth showing, at the end of a pass or when the last was long ago. */
export function isWorthShowing(progress: StillProgress, msSinceShown: number): boolean {
  return progress.passDone || msSinceShown > 250;
}
