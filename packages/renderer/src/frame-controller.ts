/**
 * Keeps a moving picture smooth on weak machines: from what frames have taken lately it chooses how many pixels the next one may
 * have, and how many rows one submit may have, so that no submit runs long. Pure arithmetic, no clock of its own.
 *
 * The model is milliseconds = fixed + perPixel · pixels, fitted by least squares over the last frames: showing a film on a large
 * canvas costs something whatever the film's size, and a smaller film cannot buy that back.
 */

/**
 * Longest stretch of device work in one submit, milliseconds: short enough for a page to be used meanwhile while it shows moving
 * pictures, and where a single picture is waited for, still far below any watchdog (browsers give up after seconds).
 */
const LONGEST_SUBMIT_MS = { watched: 100, awaited: 300 };
/** Share of the frame's time that the device may take; the rest is the browser's. */
const SHARE = 0.8;
/** Film pixels to try before anything is known. */
const FIRST_PIXELS = 512 * 512;
/** Smallest film, as a share of the canvas along one side. */
const LEAST_SCALE = 1 / 8;
/** Steps of the scale, so that it does not flicker from frame to frame. */
const STEPS = 16;
/** Weight of the past when a frame is added: about the last thirty count. */
const MEMORY = 0.97;
/** What is left of the past's weight when it is only guessed to hold. */
const GUESS = 0.01;
/** Every so many frames one is a step larger, since frames of one size do not tell the two parts of the cost apart. */
const TRY_LARGER = 24;
const LARGER = 1.3;

export class FrameController {
  /** Whether frame follows frame on the screen, or one picture is waited for. */
  watched = true;
  // Decayed sums over frames of 1, pixels, milliseconds, pixels², pixels · milliseconds.
  #n = 0;
  #x = 0;
  #y = 0;
  #xx = 0;
  #xy = 0;
  #scale = 1;
  #halved = false;
  #frames = 0;

  /** What a finished submit took. */
  measured(pixels: number, milliseconds: number): void {
    this.#n = this.#n * MEMORY + 1;
    this.#x = this.#x * MEMORY + pixels;
    this.#y = this.#y * MEMORY + milliseconds;
    this.#xx = this.#xx * MEMORY + pixels * pixels;
    this.#xy = this.#xy * MEMORY + pixels * milliseconds;
  }

  /** Milliseconds of a frame: `fixed` + `perPixel` · pixels; null while nothing is known. */
  get cost(): { readonly fixed: number; readonly perPixel: number } | null {
    if (this.#n === 0) return null;
    const spread = this.#n * this.#xx - this.#x * this.#x;
    const mean = this.#y / this.#x;
    // Frames of one size tell nothing of the two parts: all counts as the pixels'.
    if (spread < 1e-3 * this.#x * this.#x) return { fixed: 0, perPixel: mean };
    const slope = (this.#n * this.#xy - this.#x * this.#y) / spread;
    const perPixel = Math.min(Math.max(slope, 0.1 * mean), mean);
    return { fixed: (this.#y - perPixel * this.#x) / this.#n, perPixel };
  }

  /** The work of a pixel is about to become up to this many times as large: a guess that the next measurement outweighs. */
  workChanged(factor: number): void {
    this.#n *= GUESS;
    this.#x *= GUESS;
    this.#y *= GUESS * factor;
    this.#xx *= GUESS;
    this.#xy *= GUESS * factor;
  }

  /** Share of the canvas's width and height that a moving frame may have: `largest` or less. */
  movingScale(canvasPixels: number, targetFps: number, largest: number): number {
    const cost = this.cost;
    if (!cost) return Math.min(Math.sqrt(FIRST_PIXELS / canvasPixels), largest);
    const affordable = (fps: number) => ((SHARE * 1000) / fps - cost.fixed) / cost.perPixel;
    // A target that would leave a picture of a few blocks is given up for half of it. Below the size at which the pixels cost no
    // more than the fixed part there is little to win.
    // It is taken up again when there is room for half as much more, so that the two do not take turns.
    const few = 4 * LEAST_SCALE * LEAST_SCALE * canvasPixels;
    this.#halved = affordable(targetFps) < (this.#halved ? 1.5 : 1) * few;
    const pixels = affordable(this.#halved ? targetFps / 2 : targetFps);
    const worthwhile = Math.max(pixels, (0.5 * cost.fixed) / cost.perPixel);
    const fits = Math.min(Math.max(Math.sqrt(worthwhile / canvasPixels), LEAST_SCALE), largest);
    this.#scale = fits >= largest ? largest : this.#stepped(fits, largest);
    return ++this.#frames % TRY_LARGER === 0 ? Math.min(this.#scale * LARGER, largest) : this.#scale;
  }

  /** Down at once; up only when there is room for a good part of the step more, so that the size does not swing. */
  #stepped(fits: number, largest: number): number {
    const down = Math.max(Math.floor(fits * STEPS) / STEPS, Math.min(LEAST_SCALE, largest));
    const oneUp = down > this.#scale && down - this.#scale <= 1 / STEPS;
    return oneUp && fits < down + 0.5 / STEPS ? this.#scale : down;
  }

  /** How many samples of a still film of so many pixels one frame has time for: a power of two, 1 … `most`. */
  samplesPerFrame(pixels: number, targetFps: number, most: number): number {
    const cost = this.cost;
    if (!cost) return 1;
    const affordable = ((SHARE * 1000) / targetFps - cost.fixed) / (cost.perPixel * pixels);
    return 2 ** Math.floor(Math.log2(Math.max(Math.min(affordable, most), 1)));
  }

  /** Rows of this width that one submit may have. */
  rowsPerSubmit(width: number): number {
    const cost = this.cost;
    const longest = LONGEST_SUBMIT_MS[this.watched ? 'watched' : 'awaited'];
    const pixels = cost ? (longest - Math.min(cost.fixed, longest / 2)) / cost.perPixel : FIRST_PIXELS;
    return Math.max(Math.floor(pixels / width), 1);
  }
}
