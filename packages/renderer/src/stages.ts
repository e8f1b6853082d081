/**
 * Everything that lives on one device: the passes, the film, the packed scene. Made anew when a device was lost. One film
 * sample is a visible list of calls: pack, trace in short submits, show.
 */
import { Display, type Look } from './display/display.ts';
import { Film } from './film/film.ts';
import type { FrameController } from './frame-controller.ts';
import type { Device, Pass, TableTexture, UniformBuffer } from './gpu/device.ts';
import { type ClassicInputs, createClassicPass, createPreviewPass, drawClassic } from './integrator/classic/classic.ts';
import { structSize, TABLE_WIDTH } from './packed-scene/layout.ts';
import { packFrame, viewReach } from './packed-scene/pack-frame.ts';
import { type PackedScene, packScene } from './packed-scene/pack-scene.ts';
import { createBlock } from './packed-scene/write-struct.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Camera, Scene } from './scene/scene.ts';

/** One state of the world, as the film is to hold it. */
export interface Shot {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Readonly<RendererSettings>;
  /** At most. */
  readonly raysPerPixel: number;
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
  readonly #preview: Pass;
  readonly #frame: UniformBuffer;
  readonly #frameBlock = createBlock(structSize('Frame'));
  #classic: Pass | null = null;
  #classicReady: Promise<void> | null = null;
  #table: TableTexture | null = null;
  #packed: PackedScene | undefined;
  #shot: Shot | null = null;
  /** When the device finished the work before, for timing what overlaps. */
  #lastFinish = 0;
  #pending = false;
  /** The submit before the last one, done or not. */
  #before: Promise<void> | null = null;
  /** Whether the integrator has drawn something. */
  #warm = false;

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
    this.film = new Film(device);
    this.#frame = device.createUniforms(structSize('Frame'));
  }

  /** Whether a sample has been begun whose last rows are not submitted yet. */
  get pending(): boolean {
    return this.#pending;
  }

  /** Whether the film gets the integrator's samples and not the preview's. */
  get complete(): boolean {
    return this.#classic !== null;
  }

  /** Compiles the integrator, and the display's tone mapping, once. Call it when the first picture is on its way. */
  ready(): Promise<void> {
    this.#classicReady ??= Promise.all([createClassicPass(this.device), this.#display.ready()]).then(([pass]) => {
      this.#classic = pass;
    });
    return this.#classicReady;
  }

  /** Points the film at a new shot, empty, of this size in pixels. */
  begin(shot: Shot, width: number, height: number): void {
    this.#shot = shot;
    this.film.restart(width, height);
    const reach = viewReach(shot.camera, width / height);
    const packed = packScene(shot.scene, shot.camera.eye, this.#packed, reach);
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
    const pass = this.#classic ?? this.#preview;
    const inputs = this.#writeFrame();
    let row = 0;
    this.#pending = true;
    try {
      for (;;) {
        const rowCount = Math.min(this.#rowsPerSubmit(controller, pass), height - row);
        const begun = performance.now();
        drawClassic(device, pass, film.next, inputs, { width, height, firstRow: row, rowCount });
        row += rowCount;
        if (row === height) this.#complete(submitted);
        const done = device.finished().then(() => this.#measure(controller, pass, width * rowCount, begun));
        done.catch(() => {}); // awaited below, or one submit later, or not at all when something else failed first
        // Two submits at once, so that the device has the next one when it has finished one.
        const before = this.#before;
        this.#before = done;
        await (row === height ? done : before);
        if (row === height) return true;
        if (unwanted()) return false;
      }
    } finally {
      // Once all is submitted, `pending` may be the next sample's.
      if (row < height) this.#pending = false;
    }
  }

  #writeFrame(): ClassicInputs {
    const { scene, camera, settings } = this.#shot!;
    packFrame(this.#frameBlock, this.film, camera, scene.sky, this.#packed!, settings, this.film.samples);
    this.#frame.write(this.#frameBlock.bytes);
    return { frame: this.#frame, sceneTable: this.#table!, previousFilm: this.film.current };
  }

  #complete(submitted: () => void): void {
    this.#pending = false;
    this.film.swap();
    submitted();
  }

  /** Before the first measurement nobody knows how fast the device is, only how many rays a pixel may ask for. */
  #rowsPerSubmit(controller: FrameController, pass: Pass): number {
    const { width } = this.film;
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
    if (pass !== this.#classic) return;
    if (this.#warm) controller.measured(pixels, milliseconds);
    this.#warm = true;
  }

  /** Puts the newest whole picture on the canvas; false when there is none. */
  show(look: Look): boolean {
    const { picture } = this.film;
    if (picture) this.#display.show(picture.texture, picture.width, picture.height, look);
    return picture !== null;
  }
}
