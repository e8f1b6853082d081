import { filmToSrgb } from './display/srgb.ts';
import { NO_FIGURES } from './frame-figures.ts';
import type { StillStart } from './reference/progressive.ts';
import type { FrameStats, Renderer, RendererOptions, RendererSettings } from './renderer-types.ts';
import type { Camera, Scene } from './scene/scene.ts';
import { readyScene } from './scene-file/usable-scene.ts';
import { openStillScreen, type ShowStill } from './still-screen.ts';
import { View } from './view.ts';

/** Film pixels of a still picture at most: a few seconds' work. */
const MOST_PIXELS = 480 * 360;
/** Samples in each pixel after which a running still picture is fine enough; `maxSamples` may say fewer. */
const MOST_SAMPLES = 16;
/** Changes by hand that follow one another closely start one picture, not many, milliseconds. */
const SETTLE_MS = 120;

/** Why a picture is not finished. */
const REPLACED = new Error('Another picture was begun.');
const DISPOSED = new Error('The renderer was disposed of.');

/**
 * One still picture by the double-precision reference tracer, where there is no GPU interface at all. It does not play; a change
 * of time, view or settings begins a new picture, coarse first. While nothing changes it gets more samples, one after the other.
 */
export class CpuRenderer implements Renderer {
  readonly backend = 'cpu';
  /** It has no path tracing, whatever the settings ask for. */
  readonly drawnBy = 'classic';
  readonly compiling = false;
  readonly canvas: HTMLCanvasElement;
  speed = 1;
  playing = false;
  readonly #options: RendererOptions;
  readonly #view: View;
  readonly #showStill: ShowStill;
  /** What is shown: the film so far. */
  #film: { width: number; height: number; pixels: Float32Array<ArrayBuffer> } | null = null;
  /** The last film with equally many samples in all pixels, and the picture that it is of. */
  #whole: (StillStart & { readonly of: string }) | null = null;
  #stats: FrameStats;
  #abort: AbortController | null = null;
  #timer: ReturnType<typeof setInterval> | undefined;
  /** What the view was like when it was last looked at, and the picture that is being drawn. */
  #seen = '';
  #drawing = '';
  #shownRevision = -1;
  /** Scenes asked for so far, and the last one taken. */
  #asked = 0;
  #taken = 0;
  /** Time spent on the samples of `#whole`, seconds. */
  #wholeSeconds = 0;

  static async create(canvas: HTMLCanvasElement, options: RendererOptions): Promise<CpuRenderer> {
    return new CpuRenderer(canvas, await openStillScreen(canvas), options);
  }

  private constructor(canvas: HTMLCanvasElement, showStill: ShowStill, options: RendererOptions) {
    this.canvas = canvas;
    this.#showStill = showStill;
    this.#options = options;
    this.#view = new View(options.settings);
    this.#view.playing = false;
    const { width: canvasWidth, height: canvasHeight } = canvas;
    this.#stats = { backend: 'cpu', ...NO_FIGURES, canvasWidth, canvasHeight };
  }

  get settings() {
    return this.#view.settings;
  }
  get stats() {
    return this.#stats;
  }
  get scene() {
    return this.#view.scene;
  }
  get camera() {
    return this.#view.camera;
  }
  set camera(camera: Camera) {
    this.#view.camera = camera;
  }
  resetCamera(): void {
    this.#view.camera = null;
  }
  get time() {
    return this.#view.time;
  }
  set time(seconds: number) {
    this.#view.time = seconds;
  }
  get running() {
    return this.#timer !== undefined;
  }
  set(settings: Partial<RendererSettings>): void {
    this.#view.set(settings);
  }

  /** Its tracer builds what it needs in its own worker. */
  async prepare(scene: Scene): Promise<void> {
    await readyScene(scene);
  }

  async setScene(given: Scene): Promise<void> {
    const turn = ++this.#asked;
    const ready = readyScene(given);
    const scene = ready instanceof Promise ? await ready : ready;
    // A later one was there sooner.
    if (turn < this.#taken) return;
    this.#taken = turn;
    this.#view.setScene(scene);
  }

  start(): void {
    this.#timer ??= setInterval(() => this.#look(), SETTLE_MS);
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = undefined;
  }

  /** Begins a picture once the view has changed and then kept still; then goes on with it. */
  #look(): void {
    const { shownRevision, scene } = this.#view;
    const wanted = this.#wanted();
    const settled = wanted === this.#seen;
    this.#seen = wanted;
    if (shownRevision !== this.#shownRevision || this.#canvasCleared()) this.#show();
    if (scene && settled && this.#drawing !== wanted && !this.#enough(wanted)) this.render().catch(this.#report);
  }

  #enough(wanted: string): boolean {
    const samples = this.#whole?.of === wanted ? this.#whole.samples : 0;
    return samples >= Math.min(this.settings.maxSamples, MOST_SAMPLES);
  }

  /** All that a picture depends on, in few words. */
  #wanted(): string {
    const { width, height } = this.#filmSize();
    return `${this.#view.revision} ${width} × ${height}`;
  }

  readonly #report = (error: unknown): void => {
    if (error === REPLACED || error === DISPOSED) return;
    this.stop();
    this.#options.onDevice?.('failed', error instanceof Error ? error.message : String(error));
  };

  #canvasCleared(): boolean {
    return this.canvas.width !== this.#stats.canvasWidth || this.canvas.height !== this.#stats.canvasHeight;
  }

  /** Resolves when each pixel has a sample, or one more than before. Rejects when another picture took its place. */
  async render(): Promise<void> {
    const { scene, time, camera } = this.#view;
    if (!scene) throw new Error('Set a scene before rendering.');
    this.#abort?.abort(REPLACED);
    this.#abort = new AbortController();
    const of = this.#wanted();
    const start = this.#whole?.of === of ? this.#whole : undefined;
    const samples = (start?.samples ?? 0) + 1;
    const { width, height } = this.#filmSize();
    const started = performance.now();
    const before = start ? this.#wholeSeconds : 0;
    const progress = (pixels: Float32Array<ArrayBuffer>, done: number) => {
      this.#film = { width, height, pixels };
      const frameMs = performance.now() - started;
      this.#count(frameMs, done, done === 1 ? samples : samples - 1);
      this.#stats = { ...this.#stats, filmSeconds: before + frameMs / 1000 };
      this.#show();
      this.#options.onFrame?.(this.#stats);
    };
    const still = { ...this.#view.settings, samples, start };
    const { signal } = this.#abort;
    this.#drawing = of;
    try {
      const { posedSceneAt, renderStill } = await import('./reference/reference-renderer.ts');
      const now = posedSceneAt(scene, time);
      const film = await renderStill(now, camera, still, width, height, progress, signal);
      this.#whole = { film, samples, of };
      progress(film, 1);
      this.#wholeSeconds = this.#stats.filmSeconds;
    } finally {
      // Aborted, another picture is being drawn already.
      if (!signal.aborted) this.#drawing = '';
    }
  }

  #filmSize() {
    const { width, height } = this.canvas;
    const scale = Math.min(this.settings.resolutionScale, Math.sqrt(MOST_PIXELS / Math.max(width * height, 1)));
    return { width: Math.max(Math.round(width * scale), 1), height: Math.max(Math.round(height * scale), 1) };
  }

  /** `done`: share of one sample of each pixel. */
  #count(frameMs: number, done: number, samples: number): void {
    const film = this.#film!;
    const rays = film.width * film.height * this.#view.raysPerPixel() * done;
    this.#stats = {
      ...this.#stats,
      frameMs,
      samples,
      mraysPerSecond: rays / frameMs / 1000,
      filmWidth: film.width,
      filmHeight: film.height,
      time: this.#view.time,
    };
  }

  #show(): void {
    const film = this.#film;
    if (!film || this.canvas.width * this.canvas.height === 0) return;
    const { exposure, toneMapping } = this.settings;
    const picture = new ImageData(filmToSrgb(film.pixels, exposure, toneMapping), film.width, film.height);
    this.#showStill(picture);
    this.#shownRevision = this.#view.shownRevision;
    this.#stats = { ...this.#stats, canvasWidth: this.canvas.width, canvasHeight: this.canvas.height };
  }

  async readFilm() {
    if (!this.#film) throw new Error('Nothing has been rendered yet.');
    return { ...this.#film, view: 'picture' as const, pixels: this.#film.pixels.slice() };
  }

  dispose(): void {
    this.stop();
    this.#abort?.abort(DISPOSED);
  }
}
