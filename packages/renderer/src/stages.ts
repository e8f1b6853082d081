/**
 * Everything that lives on one device: the passes, the film, the packed scene. Made anew when a device was lost. One film
 * sample is a visible list of calls: pack, trace in short submits, show.
 */
import { Display } from './display/display.ts';
import { Film } from './film/film.ts';
import type { FrameController } from './frame-controller.ts';
import type { Device, Pass, TableTexture, UniformBuffer } from './gpu/device.ts';
import { createClassicPass, createPreviewPass, drawClassic } from './integrator/classic/classic.ts';
import { structSize, TABLE_WIDTH } from './packed-scene/layout.ts';
import { packFrame } from './packed-scene/pack-frame.ts';
import { type PackedScene, packScene } from './packed-scene/pack-scene.ts';
import { createBlock } from './packed-scene/write-struct.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Camera, Scene } from './scene/scene.ts';

/** One state of the world, as the film is to hold it. */
export interface Shot {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Readonly<RendererSettings>;
}

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
  /** Whether the integrator has drawn something. */
  #warm = false;

  /** Resolves when a first picture can be drawn; `ready` tells when the whole integrator can. */
  static async open(device: Device): Promise<Stages> {
    const [display, preview] = await Promise.all([Display.create(device), createPreviewPass(device)]);
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

  /** Compiles the integrator, once. Call it when the first picture is on its way. */
  ready(): Promise<void> {
    this.#classicReady ??= createClassicPass(this.device).then((pass) => {
      this.#classic = pass;
    });
    return this.#classicReady;
  }

  /** Points the film at a new shot, empty, of this size in pixels. */
  begin(shot: Shot, width: number, height: number): void {
    this.#shot = shot;
    this.film.restart(width, height);
    const packed = packScene(shot.scene, shot.camera.eye, this.#packed);
    this.#packed = packed;
    if (!this.#table || this.#table.height < packed.rows) {
      this.#table?.destroy();
      this.#table = this.device.createTable(TABLE_WIDTH, Math.max(packed.rows, 32));
    }
    this.#table.write(packed.table.f32, packed.rows);
  }

  /**
   * Adds one sample to every pixel of the film, in submits of as many rows as the controller allows, and shows it. What fits into
   * one submit is submitted before this returns; the promise is for those who want to know that the device has finished.
   * Resolves to false when `stale` said between two submits that nobody wants the picture any more.
   */
  async addSample(controller: FrameController, stale: () => boolean): Promise<boolean> {
    const { film, device } = this;
    const { scene, camera, settings } = this.#shot!;
    const pass = this.#classic ?? this.#preview;
    packFrame(this.#frameBlock, film, camera, scene.sky, this.#packed!, settings, film.samples);
    this.#frame.write(this.#frameBlock.bytes);
    const inputs = { frame: this.#frame, sceneTable: this.#table!, previousFilm: film.current };
    const { width, height } = film;
    this.#pending = true;
    for (let row = 0; ; ) {
      const rowCount = Math.min(controller.rowsPerSubmit(width), height - row);
      const submitted = performance.now();
      drawClassic(device, pass, film.next, inputs, { width, height, firstRow: row, rowCount });
      row += rowCount;
      if (row === height) {
        this.#pending = false;
        film.swap();
        this.show(settings.exposure);
      }
      await device.finished();
      this.#measure(controller, pass, width * rowCount, submitted);
      if (row === height) return true;
      if (stale()) {
        this.#pending = false;
        return false;
      }
    }
  }

  #measure(controller: FrameController, pass: Pass, pixels: number, submitted: number): void {
    const now = performance.now();
    const milliseconds = now - Math.max(submitted, this.#lastFinish);
    this.#lastFinish = now;
    // The preview's cost says nothing about the integrator's, whose first frame waits for the driver's code generation.
    if (pass !== this.#classic) return;
    if (this.#warm) controller.measured(pixels, milliseconds);
    this.#warm = true;
  }

  /** Puts the film on the canvas. `exposure` in stops. */
  show(exposure: number): void {
    if (this.film.samples > 0) this.#display.show(this.film.current, this.film.width, this.film.height, exposure);
  }
}
