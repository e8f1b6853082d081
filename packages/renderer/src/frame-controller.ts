/**
 * Keeps a moving picture smooth on weak machines: from what drawing a pixel has cost lately it chooses how many pixels the next
 * frame may have, and how many rows one submit may have, so that no submit runs long. Pure arithmetic, no clock of its own.
 */

/** Longest stretch of device work in one submit, milliseconds: far below any watchdog, and the page stays responsive. */
const LONGEST_SUBMIT_MS = 40;
/** Share of the frame's time that tracing may take; the rest is the browser's. */
const SHARE = 0.8;
/** Film pixels to try before anything is known. */
const FIRST_PIXELS = 512 * 512;
/** Smallest film, as a share of the canvas along one side. */
const LEAST_SCALE = 1 / 8;
/** Steps of the scale, so that it does not flicker from frame to frame. */
const STEPS = 16;

export class FrameController {
  /** Milliseconds a film pixel; unknown at first. */
  #cost: number | null = null;
  #scale = 1;

  /** Milliseconds that a pixel takes by now, or null. */
  get costPerPixel(): number | null {
    return this.#cost;
  }

  /** What a finished stretch of work took. */
  measured(pixels: number, milliseconds: number): void {
    const cost = milliseconds / pixels;
    // Rises at once, falls slowly: a wrong guess upwards makes a soft picture, one downwards a stutter.
    this.#cost = this.#cost === null || cost > this.#cost ? cost : this.#cost + (cost - this.#cost) * 0.2;
  }

  /** The work of a pixel is about to become this many times as large. */
  workChanged(factor: number): void {
    if (this.#cost !== null) this.#cost *= factor;
  }

  /** Share of the canvas's width and height that a moving frame may have: `largest` or less. */
  movingScale(canvasPixels: number, targetFps: number, largest: number): number {
    if (this.#cost === null) return Math.min(Math.sqrt(FIRST_PIXELS / canvasPixels), largest);
    const reach = (fps: number) => Math.sqrt((SHARE * 1000) / fps / Math.max(this.#cost! * canvasPixels, 1e-9));
    // A target that would need a picture of a few blocks is given up for half of it.
    const wanted = reach(targetFps) < 2 * LEAST_SCALE ? reach(targetFps / 2) : reach(targetFps);
    const fits = Math.min(Math.max(wanted, LEAST_SCALE), largest);
    const stepped = Math.max(Math.floor(fits * STEPS) / STEPS, Math.min(LEAST_SCALE, largest));
    // Up only when a whole step more has room, so that the size does not swing.
    const swings = stepped > this.#scale && stepped - this.#scale <= 1 / STEPS && fits < stepped + 0.5 / STEPS;
    if (!swings || this.#scale > largest) this.#scale = fits === largest ? largest : stepped;
    return this.#scale;
  }

  /** Rows of this width that one submit may have. */
  rowsPerSubmit(width: number): number {
    if (this.#cost === null) return Math.max(Math.floor(FIRST_PIXELS / width), 1);
    return Math.max(Math.floor(LONGEST_SUBMIT_MS / (this.#cost * width)), 1);
  }
}
