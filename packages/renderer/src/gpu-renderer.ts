import { FrameController } from './frame-controller.ts';
import { FrameFigures } from './frame-figures.ts';
import { checkTableRows, type Device, DeviceError } from './gpu/device.ts';
import { areMeshesReady, prepareMeshes } from './packed-scene/geometry-packer.ts';
import type { Preparation } from './packed-scene/pack-in-worker.ts';
import { packPathScene } from './packed-scene/pack-path-scene.ts';
import { hasMeshes, refuseMeshes } from './packed-scene/refuse-meshes.ts';
import { refuseUndrawn } from './packed-scene/refuse-undrawn.ts';
import { Painter } from './painter.ts';
import { readShown } from './read-film.ts';
import type { FrameStats, Renderer, RendererOptions, RendererSettings } from './renderer-types.ts';
import { Motion } from './scene/motion.ts';
import type { Camera, Integrator, Scene } from './scene/scene.ts';
import { readyScene } from './scene-file/usable-scene.ts';
import { Stages } from './stages.ts';
import { View } from './view.ts';

/** After the last change by hand the picture counts as moving for this long, milliseconds. */
const STILL_AFTER_MS = 150;
/** How often a lost device is asked for again, and how long is waited between, milliseconds. */
const REOPEN_TRIES = 8;
const REOPEN_PAUSE_MS = 150;
/** Work on a lost device may fail before the loss itself is told, but not much longer, milliseconds. */
const LOSS_NEWS_MS = 250;

/** What a ray and its shading cost, roughly; measured soon after. */
const RAY_WORK: Readonly<Record<Integrator, number>> = { classic: 1, path: 8 };

/** Draws with a GPU device; gets a new one when it is lost. */
export class GpuRenderer implements Renderer {
  readonly canvas: HTMLCanvasElement;
  readonly #options: RendererOptions;
  readonly #view: View;
  readonly #controller = new FrameController();
  readonly #figures: FrameFigures;
  #device: Device;
  /** Null while there is no device. */
  #painter: Painter | null = null;
  #frameRequest = 0;
  #lastTick: number | null = null;
  #lastChange = 0;
  #work = 0;
  /** Scenes asked for so far, and the last one that can be drawn. */
  #asked = 0;
  #sceneTurn = 0;
  /** Why nothing can be drawn any more. */
  #gone: string | null = null;

  static async create(canvas: HTMLCanvasElement, device: Device, options: RendererOptions): Promise<GpuRenderer> {
    const renderer = new GpuRenderer(canvas, device, options);
    try {
      await renderer.#open();
    } catch (error) {
      renderer.dispose();
      throw error;
    }
    return renderer;
  }

  async #open(): Promise<void> {
    const device = this.#device;
    try {
      this.#use(await Stages.open(device));
    } catch (error) {
      const lost = await Promise.race([device.lost.then(() => true), pause(LOSS_NEWS_MS).then(() => false)]);
      if (!lost) throw error;
      await this.#reopen();
    }
  }

  private constructor(canvas: HTMLCanvasElement, device: Device, options: RendererOptions) {
    this.canvas = canvas;
    this.#device = device;
    this.#options = options;
    this.#view = new View(options.settings);
    this.#figures = new FrameFigures(device.backend, canvas);
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
  get drawnBy(): Integrator {
    return this.#view.settings.integrator;
  }
  get stats() {
    return this.#figures.stats;
  }
  get compiling() {
    return this.#view.scene !== null && this.#painter !== null && !this.#painter.stages.has(this.#view.subject);
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

  async prepare(scene: Scene, preparation?: Preparation): Promise<void> {
    await prepareMeshes(drawable(await readyScene(scene)), preparation);
  }

  async setScene(scene: Scene): Promise<void> {
    const turn = ++this.#asked;
    const ready = readyScene(scene);
    const good = drawable(ready instanceof Promise ? await ready : ready);
    // A later one was there sooner.
    if (turn < this.#sceneTurn) return;
    this.#sceneTurn = turn;
    if (!areMeshesReady(good)) {
      await prepareMeshes(good);
      // Another one has been asked for meanwhile.
      if (turn !== this.#sceneTurn) return;
    }
    if (hasMeshes(good)) this.#tryOut(good);
    this.#view.setScene(good);
    if (!hasMeshes(good)) this.#painter?.stages.leaveModel();
    this.#workChanged();
    const wanted = this.#view.revision;
    const { canvas } = this;
    while (this.running && canvas.width * canvas.height > 0 && (this.#painter?.shownFilm ?? -1) < wanted)
      await nextFrame();
  }

  /** Throws now what would otherwise end the drawing later: what the device has no room for, trees that kernels cannot go down. */
  #tryOut(scene: Scene): void {
    const { geometry, textures, rows } = packPathScene(new Motion(scene).at(0), scene.camera.eye);
    checkTableRows(this.#device, rows);
    if (geometry) this.#device.checkData(geometry.rows, 'meshes');
    if (textures) this.#device.checkData(textures.rows, 'textures');
  }

  set(settings: Partial<RendererSettings>): void {
    if (settings.integrator === 'classic' && this.#view.scene) refuseMeshes(this.#view.scene);
    this.#view.set(settings);
    this.#workChanged();
  }

  #workChanged(): void {
    const work = this.#view.raysPerPixel() * RAY_WORK[this.#view.settings.integrator];
    if (this.#work > 0 && work > this.#work) this.#controller.workChanged(work / this.#work);
    this.#work = work;
  }

  start(): void {
    if (this.running || this.#gone !== null) return;
    this.#controller.watched = true;
    this.#lastTick = null;
    this.#frameRequest = requestAnimationFrame(this.#tick);
  }

  stop(): void {
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = 0;
  }

  readonly #tick = (now: number): void => {
    this.#frameRequest = requestAnimationFrame(this.#tick);
    const view = this.#view;
    const moved = this.#lastTick !== null && view.moves;
    view.advance(this.#lastTick === null ? 0 : Math.max(now - this.#lastTick, 0) / 1000);
    this.#lastTick = now;
    const painter = this.#painter;
    if (!painter || !view.scene) return;
    if (!painter.free) {
      painter.refresh();
      return;
    }
    if (view.worldRevision !== painter.filmWorld && !moved) this.#lastChange = now;
    const moving = view.moves || now - this.#lastChange < STILL_AFTER_MS;
    const reduced = view.settings.adaptive && moving;
    const changed = painter.changesByHand();
    painter
      .draw(reduced, () => !this.running || (!reduced && changed()), true)
      .catch((error: unknown) => this.#report(painter, error));
  };

  /** Work went wrong: with a lost device nothing that is not being mended already, else the end. */
  async #report(painter: Painter, error: unknown): Promise<void> {
    if (!(await this.#isReplaced(painter))) this.#fail(reasonOf(error));
  }

  #fail(reason: string): void {
    if (this.#gone !== null) return;
    this.#gone = reason;
    this.stop();
    this.#options.onDevice?.('failed', reason);
  }

  async #isReplaced(painter: Painter): Promise<boolean> {
    for (let waited = 0; waited < LOSS_NEWS_MS && painter === this.#painter; waited += 10) await pause(10);
    return painter !== this.#painter;
  }

  async render(): Promise<void> {
    if (!this.#view.scene) throw new Error('Set a scene before rendering.');
    for (;;) {
      const painter = await this.#waitForPainter();
      try {
        if (await this.#renderWith(painter)) return;
      } catch (error) {
        if (!(await this.#isReplaced(painter))) throw error;
      }
    }
  }

  /** Resolves to false when the device was lost on the way. */
  async #renderWith(painter: Painter): Promise<boolean> {
    this.#controller.watched = this.running;
    if (!this.running) await painter.stages.ready(this.#view.subject);
    if (!painter.free) painter.refresh();
    while (!painter.free && painter === this.#painter) await pause(4);
    if (painter !== this.#painter) return false;
    await painter.draw(this.running && this.#view.moves && this.#view.settings.adaptive, () => false, false);
    return painter === this.#painter;
  }

  async #waitForPainter(): Promise<Painter> {
    while (!this.#painter && this.#gone === null) await pause(4);
    if (this.#gone !== null) throw new DeviceError(this.#gone);
    return this.#painter!;
  }

  async readFilm() {
    const painter = await this.#waitForPainter();
    const held = painter.stages.shown?.view ?? 'picture';
    // What the preview drew is not the integrator's, and what is of another view is not what is asked for.
    if (painter.filmRevision >= 0 && !(painter.filmComplete && held === this.settings.view))
      await painter.stages.ready(this.#view.subject).then(() => this.render());
    while (painter === this.#painter && painter.stages.pending && painter.stages.film.samples === 0) await pause(4);
    const { stages } = await this.#waitForPainter();
    if (stages.film.samples === 0) throw new Error('Nothing has been rendered yet.');
    return readShown(stages);
  }

  #use(stages: Stages): void {
    const onFrame = (stats: FrameStats) => {
      if (painter === this.#painter) this.#tell(stats);
    };
    const { canvas } = this;
    const easel = { canvas, view: this.#view, controller: this.#controller, figures: this.#figures, onFrame };
    const painter = new Painter(stages, easel);
    this.#painter = painter;
    stages.device.lost.then((reason) => {
      if (this.#gone === null) void this.#recover(reason);
    });
  }

  /** What goes wrong at the listener's is not the renderer's end. */
  #tell(stats: FrameStats): void {
    try {
      this.#options.onFrame?.(stats);
    } catch (error) {
      setTimeout(() => {
        throw error;
      });
    }
  }

  /** A lost device keeps scene, view and time; the film is traced again. */
  async #recover(reason: string): Promise<void> {
    this.#putAwayPainter();
    this.#options.onDevice?.('lost', reason);
    let failure = reason;
    for (let attempt = 0; attempt < REOPEN_TRIES && this.#gone === null; attempt++) {
      try {
        if (await this.#reopen()) this.#options.onDevice?.('restored', reason);
        return;
      } catch (error) {
        failure = reasonOf(error);
        await pause(REOPEN_PAUSE_MS);
      }
    }
    this.#fail(failure);
  }

  /** Resolves to false when nobody wants the new device any more. */
  async #reopen(): Promise<boolean> {
    this.#device = await this.#device.reopen();
    const stages = this.#gone === null ? await Stages.open(this.#device) : null;
    if (stages && this.#gone === null) this.#use(stages);
    else this.#device.destroy();
    return this.#painter !== null;
  }

  dispose(): void {
    this.stop();
    this.#gone ??= 'The renderer was disposed of.';
    this.#putAwayPainter();
    this.#device.destroy();
  }

  #putAwayPainter(): void {
    this.#painter?.stages.end();
    this.#painter = null;
  }
}

/** The scene, if there is a picture of it. */
function drawable(scene: Scene): Scene {
  if (scene.render.integrator === 'classic') refuseMeshes(scene);
  else refuseUndrawn(scene);
  return scene;
}

const reasonOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));
const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));
const pause = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));
