/**
 * Everything that lives on one device: the passes, the film, the packed scene. Made anew when a device was lost. One film
 * sample is a visible list of calls: pack, trace in short submits, show.
 */
import { AovDisplay, type Sight } from './display/aov-view.ts';
import { Display, type Look } from './display/display.ts';
import { AOV_VIEWS } from './display/views.ts';
import { Film } from './film/film.ts';
import type { FrameController } from './frame-controller.ts';
import type { Device, FilmArea, Pass, Region, TableTexture, UniformBuffer } from './gpu/device.ts';
import { AOV_LAYERS, type AovContent, aovFrame, createAovPass, drawAov } from './integrator/aov/aov.ts';
import { createClassicPass, createPreviewPass, drawClassic } from './integrator/classic/classic.ts';
import { createPathPass, drawPath, PATH_LAYERS } from './integrator/path/path.ts';
import { structSize, TABLE_WIDTH } from './packed-scene/layout.ts';
import { packFrame, viewReach } from './packed-scene/pack-frame.ts';
import { packPathScene } from './packed-scene/pack-path-scene.ts';
import { type PackedScene, packScene } from './packed-scene/pack-scene.ts';
import { createBlock, writeStruct } from './packed-scene/write-struct.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Camera, Integrator, Scene } from './scene/scene.ts';
import { sceneSeenBy } from './scene/seen-by.ts';

/** What a film can hold: the light that an integrator finds, or what the camera sees first. */
export type Content = Integrator | AovContent;

/** What the film holds for such settings. */
export const contentOf = ({ view, integrator }: Pick<RendererSettings, 'view' | 'integrator'>): Content =>
  view === 'picture' ? integrator : AOV_VIEWS[view].content;

const isAov = (content: Content | null): content is AovContent => content === 'features' || content === 'data';

/** One state of the world, as the film is to hold it. */
export interface Shot {
  /** Default: what `settings` want to see. */
  readonly content?: Content;
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Readonly<RendererSettings>;
  /** At most. */
  readonly raysPerPixel: number;
  /** The only part of the film to be drawn; all of it when left out. What is drawn there is the same. */
  readonly area?: FilmArea;
}

/** Rays that the first submits may ask for, while the device's speed is unknown: even a slow GPU does these in a blink. */
const UNMEASURED_RAYS = 2 ** 25;
/** Least time that a submit is taken to need, milliseconds. */
const LEAST_MS = 0.01;
/** Pixels in a submit of the preview, whose work does not grow with the settings. */
const PREVIEW_PIXELS = 512 * 512;

export class Stages {
  readonly device: Device;
  readonly film: Film;
  readonly #display: Display;
  #aovDisplay: AovDisplay | null = null;
  readonly #preview: Pass;
  readonly #frame: UniformBuffer;
  readonly #frameBlock = createBlock(structSize('Frame'));
  readonly #passes = new Map<Content, Pass>();
  readonly #compiling = new Map<Content, Promise<void>>();
  #table: TableTexture | null = null;
  #packed: PackedScene | undefined;
  #shot: Shot | null = null;
  /** What draws the samples of the shot, and what it draws; null: the preview. */
  #pass: Pass;
  #content: Content | null = null;
  /** What the film's newest whole picture shows, when it is no picture. */
  #pictured: Sight | null = null;
  /** When the device finished the work before, for timing what overlaps. */
  #lastFinish = 0;
  #pending = false;
  /** The submit before the last one, done or not. */
  #before: Promise<void> | null = null;
  /** The integrators that have drawn something. */
  readonly #warm = new Set<Pass>();

  /** Resolves when a first picture can be drawn; `ready` tells when the whole integrator can. */
  static async open(device: Device): Promise<Stages> {
    const [display, preview] = await Promise.all([Display.create(device), createPreviewPass(device)]);
    device.attach();
    return new Stages(device, display, preview);
  }

  private constructor(device: Device, display: Display, preview: Pass) {
    this.device = device;
    this.#display = display;
    this.#preview = preview;
    this.#pass = preview;
    this.film = new Film(device);
    this.#frame = device.createUniforms(structSize('Frame'));
  }

  /** Whether a sample has been begun whose last rows are not submitted yet. */
  get pending(): boolean {
    return this.#pending;
  }

  /** Whether the film gets samples of this and not the preview's. */
  has(content: Content): boolean {
    return this.#passes.has(content);
  }

  /** Compiles what draws this, and the display's tone mapping, once. Call it when the first picture is on its way. */
  ready(content: Content): Promise<void> {
    let compiling = this.#compiling.get(content);
    if (!compiling) {
      const display = isAov(content) ? this.#aovReady() : this.#display.ready();
      compiling = Promise.all([createPass(this.device, content), display]).then(([pass]) => {
        this.#passes.set(content, pass);
      });
      this.#compiling.set(content, compiling);
    }
    return compiling;
  }

  async #aovReady(): Promise<void> {
    const display = await AovDisplay.create(this.device);
    this.#aovDisplay ??= display;
  }

  /** Layers that the film of such a shot has now. */
  layersFor(content: Content): number {
    if (!this.has(content) || content === 'classic') return 1;
    return content === 'path' ? PATH_LAYERS : AOV_LAYERS;
  }

  /** Points the film at a new shot, empty, of this size in pixels. */
  begin(shot: Shot, width: number, height: number): void {
    this.#shot = shot;
    this.film.restart(width, height);
    const { integrator } = shot.settings;
    const content = shot.content ?? contentOf(shot.settings);
    this.#pass = this.#passes.get(content) ?? this.#preview;
    this.#content = this.has(content) ? content : null;
    const pack = this.#content === 'path' || isAov(this.#content) ? packPathScene : packScene;
    const scene = isAov(this.#content) ? sceneSeenBy(integrator, shot.scene) : shot.scene;
    const reach = viewReach(shot.camera, width / height, shot.settings.framing);
    const packed = pack(scene, shot.camera.eye, { reuse: this.#packed, reach });
    this.#packed = packed;
    if (!this.#table || this.#table.height < packed.rows) {
      this.#table?.destroy();
      this.#table = this.device.createTable(TABLE_WIDTH, Math.max(packed.rows, 32));
    }
    this.#table.write(packed.table.f32, packed.rows);
  }

  /**
   * Adds one sample to every pixel of the film, in submits of as many rows as the controller allows. What fits into one submit is
   * submitted before this returns. `submitted` is called with the last one, when the film holds the sample; the promise is for
   * those who want to know that the device has finished. It resolves to false when the sample was given up since `unwanted` said
   * between two submits that nobody needs it any more.
   */
  async addSample(controller: FrameController, submitted: () => void, unwanted: () => boolean): Promise<boolean> {
    const { film, device } = this;
    const { width, height } = film;
    const { x, y, ...area } = this.#shot!.area ?? { x: 0, y: 0, width, height };
    const pass = this.#pass;
    this.#writeFrame();
    const columns = { firstColumn: x, columnCount: area.width };
    const end = y + area.height;
    let row = y;
    this.#pending = true;
    try {
      for (;;) {
        const rowCount = Math.min(this.#rowsPerSubmit(controller, pass, area.width), end - row);
        const begun = performance.now();
        this.#draw(pass, { width, height, firstRow: row, rowCount, ...columns });
        row += rowCount;
        if (row === end) this.#complete(submitted);
        const done = device.finished().then(() => this.#measure(controller, pass, area.width * rowCount, begun));
        done.catch(() => {}); // awaited below, or one submit later, or not at all when something else failed first
        // Two submits at once, so that the device has the next one when it has finished one.
        const before = this.#before;
        this.#before = done;
        await (row === end ? done : before);
        if (row === end) return true;
        if (unwanted()) return false;
      }
    } finally {
      // Once all is submitted, `pending` may be the next sample's.
      if (row < end) this.#pending = false;
    }
  }

  #draw(pass: Pass, region: Region): void {
    const { device, film } = this;
    const inputs = { frame: this.#frame, sceneTable: this.#table!, previous: film.current.layers };
    const draw = this.#content === 'path' ? drawPath : isAov(this.#content) ? drawAov : drawClassic;
    draw(device, pass, film.next, inputs, region);
  }

  #writeFrame(): void {
    const { scene, camera, settings } = this.#shot!;
    packFrame(this.#frameBlock, this.film, camera, scene.sky, this.#packed!, settings, this.film.nextSample);
    if (isAov(this.#content)) writeStruct(this.#frameBlock, 'Frame', 0, aovFrame(settings.integrator));
    this.#frame.write(this.#frameBlock.bytes);
  }

  #complete(submitted: () => void): void {
    this.#pending = false;
    this.film.swap();
    this.#pictured = this.#sight();
    submitted();
  }

  #sight(): Sight | null {
    const { scene, camera, settings } = this.#shot!;
    const { view, integrator } = settings;
    return isAov(this.#content) && view !== 'picture' ? { view, scene, camera, integrator } : null;
  }

  /** Before the first measurement nobody knows how fast the device is, only how many rays a pixel may ask for. */
  #rowsPerSubmit(controller: FrameController, pass: Pass, width: number): number {
    if (pass === this.#preview) return Math.max(Math.floor(PREVIEW_PIXELS / width), 1);
    const rows = controller.rowsPerSubmit(width);
    if (controller.cost) return rows;
    return Math.max(Math.min(rows, Math.floor(UNMEASURED_RAYS / (width * this.#shot!.raysPerPixel))), 1);
  }

  #measure(controller: FrameController, pass: Pass, pixels: number, submitted: number): void {
    const now = performance.now();
    // The clock is coarse, and nothing is free: a cost of 0 would leave the controller dividing by it.
    const milliseconds = Math.max(now - Math.max(submitted, this.#lastFinish), LEAST_MS);
    this.#lastFinish = now;
    // The preview's cost says nothing about the integrator's, whose first frame waits for the driver's code generation.
    if (pass === this.#preview) return;
    if (this.#warm.has(pass)) controller.measured(pixels, milliseconds);
    this.#warm.add(pass);
  }

  /** Puts the newest whole picture on the canvas; false when there is none. */
  show(look: Look): boolean {
    const { picture } = this.film;
    if (!picture) return false;
    const { film, width, height } = picture;
    if (this.#pictured) this.#aovDisplay!.show(film, width, height, this.#pictured);
    else this.#display.show(film.layers[0]!, width, height, look);
    return true;
  }
}

function createPass(device: Device, content: Content): Promise<Pass> {
  if (isAov(content)) return createAovPass(device, content);
  return content === 'path' ? createPathPass(device) : createClassicPass(device);
}
