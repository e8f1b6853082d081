import { filmToSrgb } from './display/srgb.ts';
import { renderStill } from './reference/reference-renderer.ts';
import type { FrameStats, Renderer, RendererOptions, RendererSettings } from './renderer-types.ts';
import type { Camera, Scene } from './scene/scene.ts';
import { View } from './view.ts';

/** Film pixels of a still picture at most: a few seconds' work. */
const MOST_PIXELS = 480 * 360;
/** Changes by hand that follow one another closely start one picture, not many, milliseconds. */
const SETTLE_MS = 120;

/**
 * One still picture by the double-precision reference tracer, where there is no GPU interface at all. It does not play; a change
 * of time, view or settings begins a new picture, coarse first.
 */
export class CpuRenderer implements Renderer {
  readonly backend = 'cpu';
  readonly canvas: HTMLCanvasElement;
  speed = 1;
  playing = false;
  readonly #options: RendererOptions;
  readonly #view: View;
  readonly #context: CanvasRenderingContext2D;
  #film: { width: number; height: number; pixels: Float32Array<ArrayBuffer> } | null = null;
  #stats: FrameStats;
  #abort: AbortController | null = null;
  #timer: ReturnType<typeof setInterval> | undefined;
  #seenRevision = -1;
  #shownRevision = -1;

  constructor(canvas: HTMLCanvasElement, options: RendererOptions) {
    const context = canvas.getContext('2d');
    if (!context) throw new Error('The canvas gives no 2D context; it may have been used with another one before.');
    this.canvas = canvas;
    this.#context = context;
    this.#options = options;
    this.#view = new View(options.settings);
    this.#view.playing = false;
    const { width: canvasWidth, height: canvasHeight } = canvas;
    const none = { fps: 0, frameMs: 0, samples: 0, mraysPerSecond: 0, filmWidth: 0, filmHeight: 0, time: 0 };
    this.#stats = { backend: 'cpu', ...none, canvasWidth, canvasHeight };
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

  async setScene(scene: Scene): Promise<void> {
    this.#view.setScene(scene);
  }

  start(): void {
    this.#timer ??= setInterval(() => this.#look(), SETTLE_MS);
  }

  stop(): void {
    clearInterval(this.#timer);
    this.#timer = undefined;
  }

  /** Begins a picture once the view has changed and then kept still. */
  #look(): void {
    const { revision, shownRevision, scene } = this.#view;
    const settled = revision === this.#seenRevision;
    this.#seenRevision = revision;
    if (!scene || !settled) return;
    if (this.#drawn !== revision) this.render().catch(() => {});
    else if (shownRevision !== this.#shownRevision || this.#canvasCleared()) this.#show();
  }
  #drawn = -1;

  #canvasCleared(): boolean {
    return this.canvas.width !== this.#stats.canvasWidth || this.canvas.height !== this.#stats.canvasHeight;
  }

  /** Resolves when the picture is finished. Rejects when another one took its place. */
  async render(): Promise<void> {
    if (!this.#view.scene) throw new Error('Set a scene before rendering.');
    this.#abort?.abort(new Error('Another picture was begun.'));
    this.#abort = new AbortController();
    this.#drawn = this.#view.revision;
    const { settings } = this.#view;
    const { width, height } = this.#filmSize();
    const started = performance.now();
    const progress = (pixels: Float32Array<ArrayBuffer>) => {
      this.#film = { width, height, pixels };
      this.#count(performance.now() - started);
      this.#show();
      this.#options.onFrame?.(this.#stats);
    };
    const still = { ...settings, samples: 1 };
    const film = await renderStill(
      this.#view.sceneNow(),
      this.#view.camera,
      still,
      width,
      height,
      progress,
      this.#abort.signal,
    );
    progress(film);
  }

  #filmSize() {
    const { width, height } = this.canvas;
    const scale = Math.min(this.settings.resolutionScale, Math.sqrt(MOST_PIXELS / (width * height)));
    return { width: Math.max(Math.round(width * scale), 1), height: Math.max(Math.round(height * scale), 1) };
  }

  #count(frameMs: number): void {
    const film = this.#film!;
    const rays = film.width * film.height * this.#view.raysPerPixel();
    this.#stats = {
      ...this.#stats,
      frameMs,
      samples: 1,
      mraysPerSecond: rays / frameMs / 1000,
      filmWidth: film.width,
      filmHeight: film.height,
      time: this.#view.time,
    };
  }

  #show(): void {
    const film = this.#film;
    if (!film) return;
    const picture = new ImageData(filmToSrgb(film.pixels, this.settings.exposure), film.width, film.height);
    const small = new OffscreenCanvas(film.width, film.height);
    small.getContext('2d')!.putImageData(picture, 0, 0);
    this.#context.drawImage(small, 0, 0, this.canvas.width, this.canvas.height);
    this.#shownRevision = this.#view.shownRevision;
    this.#stats = { ...this.#stats, canvasWidth: this.canvas.width, canvasHeight: this.canvas.height };
  }

  async readFilm() {
    if (!this.#film) throw new Error('Nothing has been rendered yet.');
    return { ...this.#film, pixels: this.#film.pixels.slice() };
  }

  dispose(): void {
    this.stop();
    this.#abort?.abort(new Error('The renderer was disposed of.'));
  }
}
