/** What is known of one film beside its pixels: what it holds, the work in it, and how far it has come. */

/** A film is measured when its samples have doubled, and so long after the last time, milliseconds. */
const MEASURE_AGAIN_MS = 1000;

export class FilmRecord {
  /** The view's revision that it holds; -1: none that can be gone on with. */
  revision = -1;
  /** The same without what chooses between views: `View.worldRevision`. */
  readonly world: number;
  /** Whether it holds samples of the integrator and not the preview's. */
  readonly complete: boolean;
  /** Scene time, seconds. */
  readonly time: number;
  /** What the device has worked on it, milliseconds. */
  busy = 0;
  /** The last measurement: docs/path.md, "The error of a picture". */
  relativeError: number | null = null;
  #measuredSamples = 1;
  #measuredAt = 0;
  #measuring = false;

  constructor({ revision, world, complete, time }: Pick<FilmRecord, 'revision' | 'world' | 'complete' | 'time'>) {
    this.revision = revision;
    this.world = world;
    this.complete = complete;
    this.time = time;
  }

  /** Whether to measure now. `last`: no more samples will come. One sample alone says nothing of its error. */
  isDue(samples: number, now: number, last: boolean): boolean {
    if (this.#measuring || samples < 2 || samples === this.#measuredSamples) return false;
    return last || samples >= 2 * this.#measuredSamples || now - this.#measuredAt >= MEASURE_AGAIN_MS;
  }

  /** Takes up what `measurement` gives, of so many samples. */
  async take(samples: number, now: number, measurement: Promise<number | null>): Promise<void> {
    this.#measuring = true;
    this.#measuredSamples = samples;
    this.#measuredAt = now;
    try {
      this.relativeError = await measurement;
    } finally {
      this.#measuring = false;
    }
  }
}
