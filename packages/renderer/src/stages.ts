/**
 * Everything that lives on one device: the passes, the film, the packed scene. Made anew when a device was lost. One film
 * sample is a visible list of calls: pack, trace in short submits, show.
 */
import type { Bender } from './bender.ts';
import { AovDisplay, type Sight } from './display/aov-view.ts';
import { Display, type Look } from './display/display.ts';
import { EnvironmentTexture } from './environment-texture.ts';
import { Film } from './film/film.ts';
import { FilmError } from './film/film-error.ts';
import type { FrameController } from './frame-controller.ts';
import { GeometryBuffer } from './geometry-buffer.ts';
import {
  type Compute,
  checkTableRows,
  type Device,
  DeviceError,
  type FilmArea,
  type Pass,
  type Region,
  shareOfRow,
  type TableTexture,
  type UniformBuffer,
} from './gpu/device.ts';
import { aovFrame, drawAov } from './integrator/aov/aov.ts';
import { createPreviewPass, drawClassic } from './integrator/classic/classic.ts';
import { drawPath, groupsOf, isRelay, MOST_GROUPS, type PathInputs, type RelayPass } from './integrator/path/path.ts';
import type { ProgramPlan } from './integrator/path/path-programs.ts';
import { RelayRoom } from './integrator/path/relay-room.ts';
import { geometryPacker, loadGeometryPacker } from './packed-scene/geometry-packer.ts';
import { structSize, TABLE_WIDTH } from './packed-scene/layout.ts';
import { packFrame, viewReach } from './packed-scene/pack-frame.ts';
import { needsPacker, packPathScene } from './packed-scene/pack-path-scene.ts';
import { type PackedScene, packScene } from './packed-scene/pack-scene.ts';
import type { WorkerPoses } from './packed-scene/worker-poses.ts';
import { workgroupOf } from './packed-scene/workgroup.ts';
import { createBlock, writeStruct } from './packed-scene/write-struct.ts';
import { type Content, contentOfSubject, isAov, layersOf, Programs, type Subject } from './programs.ts';
import { hasDeformables } from './scene/deform.ts';
import type { Moment } from './scene/motion.ts';
import type { Scene } from './scene/scene.ts';
import { sceneSeenBy } from './scene/seen-by.ts';
import { Sketcher, type SketchWish } from './sketcher.ts';
import { TexelBuffer } from './texel-buffer.ts';

/** One state of the world, as the film is to hold it. */
export interface Shot extends Subject, Moment {
  /** At most. */
  readonly raysPerPixel: number;
  /** The part of the picture that the film holds; all of it when left out. What is drawn there is the same. */
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
  #film: Film;
  /** The picture's, laid aside while another view is looked at. */
  #parked: Film | null = null;
  #filmError: FilmError | null = null;
  #openingFilmError: Promise<void> | null = null;
  readonly #display: Display;
  #aovDisplay: AovDisplay | null = null;
  #openingAovDisplay: Promise<void> | null = null;
  readonly #preview: Pass;
  readonly #frame: UniformBuffer;
  readonly #frameBlock = createBlock(structSize('Frame'));
  readonly #programs: Programs;
  #table: TableTexture | null = null;
  #packed: PackedScene | undefined;
  readonly #environment: EnvironmentTexture;
  readonly #geometry: GeometryBuffer;
  readonly #texels: TexelBuffer;
  readonly #relayRoom: RelayRoom;
  /** Bends meshes where the device can; null: not yet, or they are bent on this thread. */
  #bender: Bender | null = null;
  #openingBender: Promise<void> | null = null;
  #benderOpened = false;
  /** Where a worker bends meshes, and of which scene it was asked whether one should; undefined: of none, or never again. */
  #poses: WorkerPoses | null = null;
  #posesFor: Scene | null | undefined = null;
  #shot: Shot | null = null;
  /** Pixels of the shot's whole picture. */
  #picture = { width: 0, height: 0 };
  /** What draws the samples of the shot, and what it draws; null: the preview. */
  #pass: Pass;
  #content: Content | null = null;
  #shown: Sight | null = null;
  readonly #sketcher: Sketcher;
  /** When the device finished the work before, for timing what overlaps. */
  #lastFinish = 0;
  #pending = false;
  /** The submit before the last one, done or not. */
  #before: Promise<void> | null = null;
  /** Held as long as scenes that need it may be on show. */
  #packer: object | null = null;
  /** The integrators that have drawn something. */
  readonly #warm = new Set<Pass>();

  /**
   * Resolves when a first picture can be drawn; `ready` tells when the whole integrator can. `plan`: which path programs are made.
   */
  static async open(device: Device, plan: ProgramPlan = 'three'): Promise<Stages> {
    const [display, preview] = await Promise.all([Display.create(device), createPreviewPass(device)]);
    device.attach();
    return new Stages(device, display, preview, plan);
  }

  private constructor(device: Device, display: Display, preview: Pass, plan: ProgramPlan) {
    this.device = device;
    this.#programs = new Programs(device, plan);
    this.#display = display;
    this.#preview = preview;
    this.#pass = preview;
    this.#film = new Film(device);
    this.#frame = device.createUniforms(structSize('Frame'));
    this.#environment = new EnvironmentTexture(device);
    this.#geometry = new GeometryBuffer(device);
    this.#sketcher = new Sketcher(device);
    this.#texels = new TexelBuffer(device);
    this.#relayRoom = new RelayRoom(device);
  }

  get film(): Film {
    return this.#film;
  }
  /** What the film's newest whole picture shows, when it is no picture. */
  get shown(): Sight | null {
    return this.#shown;
  }

  /** Lays the film aside with all that is in it, and takes an empty one. */
  park(): void {
    this.discardParked();
    this.#parked = this.#film;
    this.#film = new Film(this.device);
  }

  /** Goes on with the film that was laid aside, which was of this shot. The one in use until now is gone. */
  takeParked(shot: Shot): void {
    this.#film.destroy();
    this.#film = this.#parked!;
    this.#parked = null;
    this.#shown = null;
    this.#aim(shot, this.#film.width, this.#film.height);
  }

  /** The film that was laid aside is of no use any more. */
  discardParked(): void {
    this.#parked?.destroy();
    this.#parked = null;
  }

  /** Whether a sample has been begun whose last rows are not submitted yet. */
  get pending(): boolean {
    return this.#pending;
  }

  /** Whether the film of this subject gets what it asks for and not the preview's samples. */
  has(subject: Subject): boolean {
    return this.#programs.get(subject) !== undefined && this.#hasPacker(subject) && this.#hasBender(subject);
  }

  #hasBender({ scene }: Subject): boolean {
    return this.#benderOpened || !this.device.compute || !hasDeformables(scene);
  }

  #hasPacker({ scene }: Subject): boolean {
    if (this.#packer !== null || !needsPacker(scene)) return true;
    this.#packer = geometryPacker();
    return this.#packer !== null;
  }

  /** Compiles the subject's program, and what shows it, once. Call it when the first picture is on its way. */
  async ready(subject: Subject): Promise<void> {
    const content = contentOfSubject(subject);
    const display = isAov(content) ? this.#aovReady() : this.#display.ready();
    const packer = needsPacker(subject.scene) && this.#packerReady();
    const bender = !this.#hasBender(subject) && this.#benderReady(this.device.compute!);
    const filmError = content === 'path' && this.#filmErrorReady();
    await Promise.all([this.#programs.ready(subject), packer, display, filmError, bender]);
  }

  #benderReady(compute: Compute): Promise<void> {
    this.#openingBender ??= import('./bender.ts')
      .then(({ Bender }) => Bender.create(this.device, compute))
      .catch((error: unknown) => {
        // Then this thread does it.
        if (error instanceof DeviceError) return null;
        throw error;
      })
      .then((bender) => {
        this.#bender = bender;
        this.#benderOpened = true;
      });
    return this.#openingBender;
  }

  async #packerReady(): Promise<void> {
    this.#packer = await loadGeometryPacker();
  }

  #filmErrorReady(): Promise<void> {
    this.#openingFilmError ??= FilmError.create(this.device).then((filmError) => {
      this.#filmError = filmError;
    });
    return this.#openingFilmError;
  }

  /** The relative error of the film as it is now, when the device has worked it out; null where there is none to be had. */
  async measureError(): Promise<number | null> {
    const { film } = this;
    if (this.#content !== 'path' || !this.#filmError || film.samples < 2) return null;
    return this.#filmError.measure(film.current, film.width, film.height);
  }

  #aovReady(): Promise<void> {
    this.#openingAovDisplay ??= AovDisplay.create(this.device).then((display) => {
      this.#aovDisplay = display;
    });
    return this.#openingAovDisplay;
  }

  /** Layers that the film of such a subject has now. */
  layersFor(subject: Subject): number {
    return this.has(subject) ? layersOf(contentOfSubject(subject)) : 1;
  }

  /** Points the film at a new shot, empty; the whole picture has this size in pixels. */
  begin(shot: Shot, width: number, height: number): void {
    const held = shot.area ?? { width, height };
    this.film.restart(held.width, held.height);
    this.#aim(shot, width, height);
  }

  /**
   * The model on show has been left: gives back what only it used, without waiting for the next film to begin. A sample of which rows are
   * still to be submitted needs it for these; then it goes when the next film begins.
   */
  leaveModel(): void {
    this.#packer = null;
    this.#endPoses();
    this.#posesFor = null;
    if (this.#pending) return;
    this.#environment.release();
    this.#bender?.release();
    this.#geometry.release();
    this.#texels.release();
    this.#relayRoom.release();
    this.#sketcher.release();
    this.#packed = undefined;
  }

  /**
   * For a picture that moves: the moment to draw when this one is wanted. Where a worker bends meshes it may be an earlier one, of which all
   * are bent. Who begins with another moment than what this gives waits while this thread bends them.
   */
  posed(moment: Moment): Moment {
    this.#play(moment.played);
    return this.#poses?.at(moment) ?? moment;
  }

  #play(scene: Scene): void {
    if (this.#posesFor === scene || this.#posesFor === undefined) return;
    this.#posesFor = scene;
    const packer = hasDeformables(scene) ? geometryPacker() : null;
    if (packer) this.#poses = packer.workerPoses(scene, this.#deviceRows, this.#poses);
    else this.#endPoses();
  }

  #endPoses(): void {
    this.#poses?.end();
    this.#poses = null;
  }

  /** Ends what goes on beside the device. Call it when nothing more will be drawn. */
  end(): void {
    this.#endPoses();
    this.#posesFor = undefined;
  }

  get #deviceRows(): number {
    return this.#bender ? this.device.compute!.maxRows : 0;
  }

  /** Makes ready what the next samples need. */
  #aim(shot: Shot, width: number, height: number): void {
    this.#shot = shot;
    if (this.#poses) this.#play(shot.played);
    this.#picture = { width, height };
    const { integrator } = shot.settings;
    const program = this.#programs.get(shot);
    this.#pass = program ?? this.#preview;
    this.#content = program ? contentOfSubject(shot) : null;
    if (!isRelay(this.#pass)) this.#relayRoom.release();
    const { camera } = shot;
    const scene = isAov(this.#content) ? sceneSeenBy(integrator, shot.scene) : shot.scene;
    const reach = viewReach(camera, width / height, shot.settings.framing);
    const options = { reuse: this.#packed, reach, deviceRows: this.#deviceRows, poses: this.#poses };
    const packed =
      this.#content === 'path' || isAov(this.#content)
        ? packPathScene({ ...shot, scene }, camera.eye, options)
        : packScene(scene, camera.eye, options);
    const before = this.#packed;
    this.#packed = packed;
    // The classic integrator uses none of them, and a model that has been left would stay in memory.
    if (packed.environment) this.#environment.hold(packed.environment);
    else this.#environment.release();
    this.#holdGeometry(packed.geometry);
    if (packed.textures) this.#texels.hold(packed.textures);
    else this.#texels.release();
    if (!this.#table || this.#table.height < packed.rows) {
      checkTableRows(this.device, packed.rows);
      this.#table?.destroy();
      this.#table = this.device.createTable(TABLE_WIDTH, Math.max(packed.rows, 32));
    } else if (packed.source === before?.source) return;
    this.#table.write(packed.table.f32, packed.rows);
  }

  #holdGeometry(geometry: PackedScene['geometry']): void {
    const rewritten = geometry !== null && this.#geometry.hold(geometry);
    if (geometry?.bending) this.#bender!.hold(geometry.bending, this.#geometry.buffer, rewritten);
    else this.#bender?.release();
    if (!geometry) this.#geometry.release();
  }

  /** Whether one call of `addSamples` may add more than one: of as many groups as integrator/path/path.ts says. */
  get addsMany(): boolean {
    return this.#pass.addsMany;
  }

  /**
   * Adds `count` samples to every pixel of the film, in submits of as many rows as the controller allows. What fits into one submit is
   * submitted before this returns. `submitted` is called with the last one, when the film holds the sample; the promise is for
   * those who want to know that the device has finished. It resolves to false when the sample was given up since `unwanted` said
   * between two submits that nobody needs it any more.
   */
  async addSamples(
    count: number,
    controller: FrameController,
    submitted: () => void,
    unwanted: () => boolean,
  ): Promise<boolean> {
    const { film, device } = this;
    const { width, height } = film;
    // The whole program may have come meanwhile.
    if (isRelay(this.#pass)) this.#pass = this.#programs.get(this.#shot!) ?? this.#pass;
    const pass = this.#pass;
    if (pass.addsMany && groupsOf(film.nextSample, count) > MOST_GROUPS)
      throw new RangeError(`${count} samples from ${film.nextSample} on are more than one call can add.`);
    this.#writeFrame(count);
    if (isRelay(pass)) return this.#addByRelay(pass, controller, submitted, unwanted);
    const { tile } = workgroupOf(count);
    let row = 0;
    this.#pending = true;
    try {
      for (;;) {
        const rowCount = Math.min(this.#rowsPerSubmit(controller, pass, width * count), height - row);
        const begun = performance.now();
        this.#draw(pass, { width, height, firstRow: row, rowCount, samples: count, tile });
        row += rowCount;
        if (row === height) this.#complete(count, submitted);
        const done = device.finished().then(() => this.#measure(controller, pass, width * rowCount * count, begun));
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

  /** A sample by a program of several passes. It is complete when the device is done with it. */
  async #addByRelay(
    pass: RelayPass,
    controller: FrameController,
    submitted: () => void,
    unwanted: () => boolean,
  ): Promise<boolean> {
    const { film } = this;
    const { width, height } = film;
    const { maxDepth } = this.#shot!.settings;
    this.#pending = true;
    try {
      const whole = await pass.addSample({
        film: film.next,
        inputs: this.#pathInputs(),
        words: this.#relayRoom.wordsFor(width, height),
        width,
        height,
        maxDepth: maxDepth < 0 ? Number.POSITIVE_INFINITY : maxDepth,
        rowsPerSubmit: () => this.#rowsPerSubmit(controller, pass, width),
        takeRow: (relayRow) => {
          writeStruct(this.#frameBlock, 'Frame', 0, { relayRow });
          this.#frame.write(this.#frameBlock.bytes);
        },
        unwanted,
        measured: (pixels, begun) => this.#measure(controller, pass, pixels, begun),
      });
      if (whole) this.#complete(1, submitted);
      return whole;
    } finally {
      this.#pending = false;
    }
  }

  /** Where paths or AOVs are drawn, there is data. */
  #rowShares() {
    if (this.#content !== 'path' && !isAov(this.#content)) return {};
    return { geometryShare: shareOfRow(this.#geometry.buffer), texelShare: shareOfRow(this.#texels.buffer) };
  }

  #pathInputs(): PathInputs {
    return {
      frame: this.#frame,
      sceneTable: this.#table!,
      previous: this.film.current.layers,
      environment: this.#environment.texture,
      geometry: this.#geometry.buffer,
      texels: this.#texels.buffer,
    };
  }

  #draw(pass: Pass, region: Region): void {
    const { device, film } = this;
    if (this.#content === 'path') drawPath(device, pass, film.next, this.#pathInputs(), region);
    else if (isAov(this.#content)) drawAov(device, pass, film.next, this.#pathInputs(), region);
    else {
      const inputs = { frame: this.#frame, sceneTable: this.#table!, previous: film.current.layers };
      drawClassic(device, pass, film.next, inputs, region);
    }
  }

  #writeFrame(count: number): void {
    const { camera, settings, area } = this.#shot!;
    const held = area ? { ...this.#picture, origin: [area.x, area.y] as const } : this.#picture;
    packFrame(this.#frameBlock, held, camera, this.#packed!, settings, this.film.nextSample, count);
    writeStruct(this.#frameBlock, 'Frame', 0, { rowHeight: 1 / this.#table!.height, ...this.#rowShares() });
    if (isAov(this.#content)) writeStruct(this.#frameBlock, 'Frame', 0, aovFrame(settings.integrator));
    this.#frame.write(this.#frameBlock.bytes);
  }

  #complete(count: number, submitted: () => void): void {
    this.#pending = false;
    this.#sketcher.release();
    this.film.swap(count);
    this.#shown = this.#sight();
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

  /**
   * Works for a moment on a sketch of what no program can draw yet; `show` then shows it. `key` tells one picture from another. Returns
   * whether there is a new one.
   */
  sketch(key: string, wish: () => SketchWish): boolean {
    return this.#sketcher.step(key, wish);
  }
  get hasSketch(): boolean {
    return this.#sketcher.sketch !== null;
  }

  /** Puts the newest sketch or whole picture on the canvas; false when there is none. */
  show(look: Look): boolean {
    const { sketch } = this.#sketcher;
    if (sketch) {
      this.#display.show(sketch.film.layers[0]!, sketch.width, sketch.height, look);
      return true;
    }
    // A film just begun has no picture yet; then there is the one laid aside.
    const picture = this.film.picture ?? this.#parked?.picture;
    if (!picture) return false;
    const { film, width, height } = picture;
    if (this.#shown && this.film.picture) this.#aovDisplay!.show(film, width, height, this.#shown);
    else this.#display.show(film.layers[0]!, width, height, look);
    return true;
  }
}
