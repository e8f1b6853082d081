/** The figures of drawn frames: how many a second, how long each took, how many rays. Pure arithmetic, no clock of its own. */
import type { Backend, FrameStats } from './renderer-types.ts';

/** Figures are those of the frames of the last second, of the newest one at least. */
const WINDOW_MS = 1000;
/** Clocks of browsers are coarse: no frame in one figure takes less. */
const LEAST_MS = 0.1;

export interface DrawnFrame {
  /** When it was begun and when the device had finished it, milliseconds. */
  readonly started: number;
  readonly finished: number;
  /** Samples in each film pixel; 0 for the preview, which is not the integrator's picture. */
  readonly samples: number;
  /** What is known of the film; the time spent on this frame is added to it. */
  readonly record: { busy: number; readonly relativeError: number | null };
  /** Of all samples that this frame added. */
  readonly raysPerPixel: number;
  readonly filmWidth: number;
  readonly filmHeight: number;
  readonly canvasWidth: number;
  readonly canvasHeight: number;
  /** Scene time that it shows, seconds. */
  readonly time: number;
}

/** Before the first frame. */
export const NO_FIGURES = {
  fps: 0,
  frameMs: 0,
  samples: 0,
  relativeError: null,
  filmSeconds: 0,
  mraysPerSecond: 0,
  filmWidth: 0,
  filmHeight: 0,
  time: 0,
};

interface CountedFrame {
  readonly finished: number;
  /** How long the device worked on it, and how long after the one before it was there, milliseconds. */
  readonly busy: number;
  readonly interval: number;
  readonly rays: number;
}

export class FrameFigures {
  stats: FrameStats;
  #window: CountedFrame[] = [];
  #lastFinish = Number.NEGATIVE_INFINITY;

  constructor(backend: Backend, canvas: { readonly width: number; readonly height: number }) {
    this.stats = { backend, ...NO_FIGURES, canvasWidth: canvas.width, canvasHeight: canvas.height };
  }

  /**
   * Sums over a second and not the last frame alone: a page often learns of two frames at once, and of the second one it cannot
   * tell when the device began it. Their sums are right all the same.
   */
  count({ started, finished, raysPerPixel, record, ...frame }: DrawnFrame): FrameStats {
    const busy = Math.max(finished - Math.max(started, this.#lastFinish), 0);
    const gap = finished - this.#lastFinish;
    // After a rest the time before the frame was begun does not count.
    const interval = gap > WINDOW_MS ? busy : gap;
    this.#lastFinish = finished;
    const rays = frame.filmWidth * frame.filmHeight * raysPerPixel;
    const recent = this.#window.filter((earlier) => earlier.finished > finished - WINDOW_MS);
    this.#window = [...recent, { finished, busy, interval, rays }];
    record.busy += busy;
    this.stats = { backend: this.stats.backend, ...frame, ...figuresOf(record), ...this.#averages() };
    return this.stats;
  }

  /** News of a film between two frames, or after the last one. */
  note(record: DrawnFrame['record'], samples: number): void {
    const news = { ...figuresOf(record), samples };
    const known = Object.entries(news).every(([key, value]) => this.stats[key as keyof typeof news] === value);
    if (!known) this.stats = { ...this.stats, ...news };
  }

  #averages(): Pick<FrameStats, 'fps' | 'frameMs' | 'mraysPerSecond'> {
    const sum = (of: 'busy' | 'interval' | 'rays') => this.#window.reduce((total, frame) => total + frame[of], 0);
    const frames = this.#window.length;
    const busy = Math.max(sum('busy'), LEAST_MS);
    const fps = (1000 * frames) / Math.max(sum('interval'), LEAST_MS);
    return { fps, frameMs: busy / frames, mraysPerSecond: sum('rays') / busy / 1000 };
  }

  /** Nothing needs drawing. */
  rest(canvas: { readonly width: number; readonly height: number }): void {
    if (this.stats.fps === 0 && this.stats.canvasWidth === canvas.width && this.stats.canvasHeight === canvas.height)
      return;
    this.#window = [];
    this.stats = { ...this.stats, fps: 0, canvasWidth: canvas.width, canvasHeight: canvas.height };
  }
}

const figuresOf = ({ busy, relativeError }: DrawnFrame['record']) => ({ relativeError, filmSeconds: busy / 1000 });
