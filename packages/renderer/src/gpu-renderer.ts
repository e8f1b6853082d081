import { FrameController } from './frame-controller.ts';
import type { Device } from './gpu/device.ts';
import type { FrameStats, Renderer, RendererOptions, RendererSettings } from './renderer-types.ts';
import type { Camera, Scene } from './scene/scene.ts';
import { Stages } from './stages.ts';
import { View } from './view.ts';

/** Frames that may be on the device at once: one being worked on, one waiting, so that it never idles and never lags. */
const MOST_IN_FLIGHT = 2;
/** After the last change by hand the picture counts as moving for this long, milliseconds. */
const STILL_AFTER_MS = 150;
/** How often a lost device is asked for again, and how long is waited between, milliseconds. */
const REOPEN_TRIES = 8;
const REOPEN_PAUSE_MS = 150;

/** Draws with a GPU device; gets a new one when it is lost. */
export class GpuRenderer implements Renderer {
  readonly canvas: HTMLCanvasElement;
  readonly #options: RendererOptions;
  readonly #view: View;
  readonly #controller = new FrameController();
  #device: Device;
  #stages: Stages | null = null;
  #stats: FrameStats;
  #frameRequest = 0;
  #lastTick: number | null = null;
  #lastShown = 0;
  #interval = 1000;
  #lastChange = 0;
  #inFlight = 0;
  /** A sample that takes several submits is under way. */
  #tracing = false;
  #disposed = false;
  /** What the film holds: its revision and whether the whole integrator made it. */
  #filmRevision = -1;
  #filmComplete = false;
  #shownRevision = -1;
  #rays = 0;

  static async create(canvas: HTMLCanvasElement, device: Device, options: RendererOptions): Promise<GpuRenderer> {
    const renderer = new GpuRenderer(canvas, device, options);
    renderer.#stages = await Stages.open(device);
    renderer.#watch(device);
    return renderer;
  }

  private constructor(canvas: HTMLCanvasElement, device: Device, options: RendererOptions) {
    this.canvas = canvas;
    this.#device = device;
    this.#options = options;
    this.#view = new View(options.settings);
    this.#stats = {
      backend: device.backend,
      fps: 0,
      frameMs: 0,
      samples: 0,
      mraysPerSecond: 0,
      filmWidth: 0,
      filmHeight: 0,
      canvasWidth: canvas.width,
      canvasHeight: canvas.height,
      time: 0,
    };
  }

  get backend() {
    return this.#device.backend;
  }
  /** The device in use, for tests and diagnosis. */
  get device(): Device {
    return this.#device;
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
  get playing() {
    return this.#view.playing;
  }
  set playing(playing: boolean) {
    this.#view.playing = playing;
  }
  get speed() {
    return this.#view.speed;
  }
  set speed(factor: number) {
    this.#view.speed = factor;
  }
  get running() {
    return this.#frameRequest !== 0;
  }

  async setScene(scene: Scene): Promise<void> {
    this.#view.setScene(scene);
    this.#workChanged();
    if (!this.running) return;
    const wanted = this.#view.revision;
    while (this.running && this.#filmRevision < wanted) await nextFrame();
  }

  set(settings: Partial<RendererSettings>): void {
    this.#view.set(settings);
    this.#workChanged();
  }

  #workChanged(): void {
    const rays = this.#view.raysPerPixel();
    if (this.#rays > 0 && rays > this.#rays) this.#controller.workChanged(rays / this.#rays);
    this.#rays = rays;
  }

  start(): void {
    if (this.running || this.#disposed) return;
    this.#lastTick = null;
    this.#frameRequest = requestAnimationFrame(this.#tick);
  }

  stop(): void {
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = 0;
  }

  readonly #tick = (now: number): void => {
    this.#frameRequest = requestAnimationFrame(this.#tick);
    const moved = this.#lastTick !== null && this.#view.moves;
    this.#view.advance(this.#lastTick === null ? 0 : Math.max(now - this.#lastTick, 0) / 1000);
    this.#lastTick = now;
    if (this.#tracing || this.#inFlight >= MOST_IN_FLIGHT || !this.#view.scene || !this.#stages) return;
    if (this.#view.revision !== this.#filmRevision && !moved) this.#lastChange = now;
    const moving = this.#view.moves || now - this.#lastChange < STILL_AFTER_MS;
    this.#drawFrame(this.#view.settings.adaptive && moving).catch(this.#report);
  };

  /** What went wrong in a frame: with a lost device nothing that is not being mended already. */
  readonly #report = (error: unknown): void => {
    if (this.#stages === null || this.#disposed) return;
    this.stop();
    this.#options.onDevice?.('failed', error instanceof Error ? error.message : String(error));
  };

  /** Adds a sample to the film, begun anew when the view has changed, or only shows it, or does nothing. */
  async #drawFrame(reduced: boolean): Promise<void> {
    const view = this.#view;
    const stages = this.#stages!;
    const { film } = stages;
    const size = this.#filmSize(stages, reduced);
    const outdated = view.revision !== this.#filmRevision || (stages.complete && !this.#filmComplete);
    if (outdated || size.width !== film.width || size.height !== film.height) {
      stages.begin({ scene: view.sceneNow(), camera: view.camera, settings: view.settings }, size.width, size.height);
      this.#filmComplete = stages.complete;
      this.#filmRevision = view.revision;
    } else if (film.samples >= (stages.complete ? view.settings.maxSamples : 1)) {
      if (view.shownRevision !== this.#shownRevision || this.#canvasCleared()) this.#showAgain(stages);
      return;
    }
    this.#shownRevision = view.shownRevision;
    await this.#trace(stages);
  }

  #showAgain(stages: Stages): void {
    stages.show(this.#view.settings.exposure);
    this.#shownRevision = this.#view.shownRevision;
    this.#stats = { ...this.#stats, fps: 0, canvasWidth: this.canvas.width, canvasHeight: this.canvas.height };
  }

  /** Setting a canvas's size clears it. */
  #canvasCleared(): boolean {
    return this.canvas.width !== this.#stats.canvasWidth || this.canvas.height !== this.#stats.canvasHeight;
  }

  #filmSize(stages: Stages, reduced: boolean): { width: number; height: number } {
    const { width, height } = this.canvas;
    const { resolutionScale, targetFps } = this.#view.settings;
    const most = this.#device.maxTextureSize;
    const pixels = (side: number, scale: number) => Math.min(Math.max(Math.round(side * scale), 1), most);
    stages.film.reserve(pixels(width, resolutionScale), pixels(height, resolutionScale));
    const scale = reduced ? this.#controller.movingScale(width * height, targetFps, resolutionScale) : resolutionScale;
    return { width: pixels(width, scale), height: pixels(height, scale) };
  }

  async #trace(stages: Stages): Promise<void> {
    const wanted = this.#filmRevision;
    const started = performance.now();
    this.#inFlight++;
    // Until the first submit is out this runs without a pause; only a sample of several submits stays unfinished here.
    const work = stages.addSample(this.#controller, () => this.#view.revision !== wanted && !this.#view.moves);
    this.#tracing = stages.pending;
    try {
      const complete = await work;
      if (!complete) this.#filmRevision = -1;
      this.#count(stages, started);
    } finally {
      this.#inFlight--;
      this.#tracing = false;
    }
    if (!stages.complete) await stages.ready();
  }

  #count(stages: Stages, started: number): void {
    const now = performance.now();
    const { film } = stages;
    const frameMs = Math.max(now - Math.max(started, this.#lastShown), 0.01);
    const interval = now - this.#lastShown;
    // The mean of the intervals, not of their reciprocals: two frames that finish together are not a thousand a second.
    this.#interval = interval > 1000 ? interval : this.#interval + (interval - this.#interval) * 0.1;
    const fps = 1000 / this.#interval;
    this.#lastShown = now;
    this.#stats = {
      backend: this.backend,
      fps,
      frameMs,
      samples: this.#filmComplete ? film.samples : 0,
      mraysPerSecond: (film.width * film.height * this.#rays) / frameMs / 1000,
      filmWidth: film.width,
      filmHeight: film.height,
      canvasWidth: this.canvas.width,
      canvasHeight: this.canvas.height,
      time: this.#view.time,
    };
    this.#options.onFrame?.(this.#stats);
  }

  async render(): Promise<void> {
    if (!this.#view.scene) throw new Error('Set a scene before rendering.');
    const stages = await this.#waitForStages();
    if (!this.running) await stages.ready();
    while (this.#tracing) await nextTask();
    await this.#drawFrame(this.running && this.#view.moves && this.#view.settings.adaptive);
  }

  async #waitForStages(): Promise<Stages> {
    while (!this.#stages && !this.#disposed) await nextTask();
    if (!this.#stages) throw new Error('The renderer was disposed of.');
    return this.#stages;
  }

  async readFilm() {
    const { film } = await this.#waitForStages();
    return { width: film.width, height: film.height, pixels: await film.read() };
  }

  #watch(device: Device): void {
    device.lost.then((reason) => {
      if (!this.#disposed) void this.#recover(reason);
    });
  }

  /** A lost device keeps scene, view and time; the film is traced again. */
  async #recover(reason: string): Promise<void> {
    this.#stages = null;
    this.#options.onDevice?.('lost', reason);
    let failure: unknown;
    for (let attempt = 0; attempt < REOPEN_TRIES && !this.#disposed; attempt++) {
      try {
        this.#device = await this.#device.reopen();
        this.#stages = await Stages.open(this.#device);
        this.#filmRevision = -1;
        this.#watch(this.#device);
        this.#options.onDevice?.('restored', reason);
        return;
      } catch (error) {
        failure = error;
        await new Promise((resolve) => setTimeout(resolve, REOPEN_PAUSE_MS));
      }
    }
    if (this.#disposed) return;
    this.stop();
    this.#options.onDevice?.('failed', failure instanceof Error ? failure.message : reason);
  }

  dispose(): void {
    this.stop();
    this.#disposed = true;
    this.#stages = null;
    this.#device.destroy();
  }
}

const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));
const nextTask = () => new Promise((resolve) => setTimeout(resolve, 4));
