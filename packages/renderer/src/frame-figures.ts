/** The figures of drawn frames: how many a second, how long each took, how many rays. Pure arithmetic, no clock of its own. */
import type { Backend, FrameStats } from './renderer-types.ts';

/** A pause of this many milliseconds between two frames begins the count of frames a second anew. */
const PAUSE_MS = 1000;

export interface DrawnFrame {
  /** When it was begun and when the device had finished it, milliseconds. */
  readonly started: number;
  readonly finished: number;
  /** Samples in each film pixel; 0 for the preview, which is not the integrator's picture. */
  readonly samples: number;
  readonly raysPerPixel: number;
  readonly filmWidth: number;
  readonly filmHeight: number;
  readonly canvasWidth: number;
  readonly canvasHeight: number;
  /** Scene time that it shows, seconds. */
  readonly time: number;
}

const NONE = { fps: 0, frameMs: 0, samples: 0, mraysPerSecond: 0, filmWidth: 0, filmHeight: 0, time: 0 };

export class FrameFigures {
  stats: FrameStats;
  #interval = PAUSE_MS;
  #lastFinish = 0;

  constructor(backend: Backend, canvas: { readonly width: number; readonly height: number }) {
    this.stats = { backend, ...NONE, canvasWidth: canvas.width, canvasHeight: canvas.height };
  }

  count({ started, finished, raysPerPixel, ...frame }: DrawnFrame): FrameStats {
    const frameMs = Math.max(finished - Math.max(started, this.#lastFinish), 0.01);
    const interval = finished - this.#lastFinish;
    // The mean of the intervals, not of their reciprocals: two frames that finish together are not a thousand a second.
    this.#interval = interval > PAUSE_MS ? interval : this.#interval + (interval - this.#interval) * 0.1;
    this.#lastFinish = finished;
    const mraysPerSecond = (frame.filmWidth * frame.filmHeight * raysPerPixel) / frameMs / 1000;
    this.stats = { backend: this.stats.backend, ...frame, fps: 1000 / this.#interval, frameMs, mraysPerSecond };
    return this.stats;
  }

  /** Nothing needs drawing. */
  rest(canvas: { readonly width: number; readonly height: number }): void {
    if (this.stats.fps === 0 && this.stats.canvasWidth === canvas.width && this.stats.canvasHeight === canvas.height)
      return;
    this.#interval = PAUSE_MS;
    this.stats = { ...this.stats, fps: 0, canvasWidth: canvas.width, canvasHeight: canvas.height };
  }
}
