/**
 * Keeps the film of one device, and the canvas, in step with the view: begins the film anew when the view has changed, adds samples
 * until there are enough, only shows it again when no more than the display has changed, and otherwise does nothing. It lives as
 * long as its device; what a lost device still had to do is forgotten with it.
 */
import { FilmRecord } from './film/film-record.ts';
import type { FrameController } from './frame-controller.ts';
import type { DrawnFrame, FrameFigures } from './frame-figures.ts';
import { loadGeometryPacker } from './packed-scene/geometry-packer.ts';
import { hasMeshes } from './packed-scene/refuse-meshes.ts';
import { PosePace } from './pose-pace.ts';
import { contentOf, isAov } from './programs.ts';
import type { FrameStats } from './renderer-types.ts';
import type { Moment } from './scene/motion.ts';
import type { Shot, Stages } from './stages.ts';
import type { View } from './view.ts';

/** Frames that may be on the device at once: one being worked on, one waiting, so that it never idles and never lags. */
const MOST_IN_FLIGHT = 2;

/** A film that shows an earlier time is by this much of no revision. */
const LATE = 0.5;

/** Samples of one frame, where a call may add many. */
const MOST_PER_FRAME = 64;

/** What a painter shares with those before and after it. */
export interface Easel {
  readonly canvas: { readonly width: number; readonly height: number };
  readonly view: View;
  readonly controller: FrameController;
  readonly figures: FrameFigures;
  readonly onFrame: (stats: FrameStats) => void;
}

export class Painter {
  readonly stages: Stages;
  readonly #easel: Easel;
  #inFlight = 0;
  /** What the film holds or is being given. */
  #record = NO_FILM;
  readonly #pace = new PosePace();
  /** What the film was begun with. */
  #begun: { readonly moment: Moment; readonly timeless: number } | null = null;
  /** Of the picture's film, laid aside while another view is looked at. */
  #parked: FilmRecord | null = null;
  #showsPicture = true;
  /** What the canvas shows. */
  #shownRevision = -1;
  #shownFilm = -1;
  #shownLook = '';
  #shownSize = { width: 0, height: 0 };
  /** The sample before was given up half-way. */
  #dropped = false;

  constructor(stages: Stages, easel: Easel) {
    this.stages = stages;
    this.#easel = easel;
  }

  /** Whether a frame may be begun: no sample is half submitted, and the device has not enough to do yet. */
  get free(): boolean {
    return !this.stages.pending && this.#inFlight < MOST_IN_FLIGHT;
  }
  /** The view's revision that the film holds or is being given. */
  get filmRevision(): number {
    return this.#record.revision;
  }
  /** The same, of `View.worldRevision`. */
  get filmWorld(): number {
    return this.#record.world;
  }
  /** The view's revision that the canvas shows, ignoring what only the display uses; -1: none. */
  get shownFilm(): number {
    return this.#shownFilm;
  }
  /** Whether the film holds samples of the integrator and not the preview's. */
  get filmComplete(): boolean {
    return this.#record.complete;
  }

  /**
   * One frame, or nothing when the film is good and shown. Resolves when the device has finished it; what fits into one submit is
   * submitted before this returns. `unwanted` is asked between two submits whether the sample may be given up. `late`: whether the picture
   * may be of an earlier time while meshes are bent for this one.
   */
  async draw(reduced: boolean, unwanted: () => boolean, late: boolean): Promise<void> {
    const { canvas } = this.#easel;
    if (canvas.width === 0 || canvas.height === 0) return;
    this.#keepPicture();
    // The preview knows no meshes; until there is a program that does a sketch stands in.
    if (this.#needsSketch) return this.#waitForProgram();
    this.#turn();
    const size = this.#reserve(reduced);
    const { moment, wanted } = this.#moments(late);
    if (this.#outdated(size, moment)) {
      this.#begin(size, moment);
      if (moment === wanted) this.#askForNext();
    } else if (moment !== wanted) {
      // The picture shows this already, and there will be a better one in a moment.
      return;
    } else if (this.#enough()) return this.#rest();
    await this.#trace(unwanted);
    if (!this.#complete) await this.stages.ready(this.#easel.view.subject);
  }

  /** While a frame takes its time: a resized canvas is not left blank, and exposure follows the hand. */
  refresh(): void {
    // What was begun for the scene before may take its time too.
    if (this.#needsSketch) this.#sketch();
    if (this.#canvasCleared() || this.#shownLook !== lookOf(this.#easel.view)) this.#show();
  }

  /** For `unwanted`: whether the world has been changed by hand since now. Not twice in a row, lest a long drag show nothing. */
  changesByHand(): () => boolean {
    const { view } = this.#easel;
    const before = view.changesByHand;
    return this.#dropped ? () => false : () => view.changesByHand !== before || this.#canvasCleared();
  }

  /** Setting a canvas's size clears it: it gets what there is until there is better. */
  #keepPicture(): void {
    if (this.#canvasCleared()) this.#show();
  }

  #canvasCleared(): boolean {
    const { width, height } = this.#easel.canvas;
    return width !== this.#shownSize.width || height !== this.#shownSize.height;
  }

  #show(): void {
    const { canvas, view } = this.#easel;
    if (canvas.width === 0 || canvas.height === 0) return;
    if (!this.stages.show(view.settings)) return;
    this.#shownLook = lookOf(view);
    this.#shownSize = { width: canvas.width, height: canvas.height };
  }

  /** What is to be shown next, and what can be. */
  #moments(late: boolean): { readonly moment: Moment; readonly wanted: Moment } {
    const { view } = this.#easel;
    const now = view.momentNow();
    if (!late || this.#record.revision === view.revision) return { moment: now, wanted: now };
    const wanted = this.#pace.wants(now, this.#inFlight > 0);
    return { moment: this.stages.posed(wanted), wanted };
  }

  /** Has meshes bent for the next frame while the device draws this one, where they are bent elsewhere. */
  #askForNext(): void {
    const now = this.#easel.view.momentNow();
    if (!this.#pace.drawn(this.#inFlight > 0)) return;
    if (this.#begun?.moment !== now && this.stages.posed(now) !== now) this.#pace.asked(now);
  }

  #outdated(size: { width: number; height: number }, moment: Moment): boolean {
    const { film } = this.stages;
    const { revision, timelessRevision } = this.#easel.view;
    const isSame = this.#begun?.moment === moment && this.#begun.timeless === timelessRevision;
    if (this.#record.revision !== revision && !isSame) return true;
    if (this.#complete && !this.#record.complete) return true;
    return size.width !== film.width || size.height !== film.height;
  }

  #begin({ width, height }: { width: number; height: number }, moment: Moment): void {
    const { view } = this.#easel;
    const { revision, worldRevision: world, timelessRevision: timeless } = view;
    if (this.#parked && this.#parked.world !== world) this.#discardParked();
    this.stages.begin(this.#shot(moment), width, height);
    const late = moment === view.momentNow() ? 0 : LATE;
    const { time } = moment;
    this.#record = new FilmRecord({ revision: revision - late, world: world - late, complete: this.#complete, time });
    this.#begun = { moment, timeless };
  }

  get #needsSketch(): boolean {
    return !this.#complete && hasMeshes(this.#easel.view.subject.scene);
  }

  /** Compiling begins when a first sketch is shown, as some drivers let nothing else happen meanwhile. */
  async #waitForProgram(): Promise<void> {
    const { stages } = this;
    const { view } = this.#easel;
    await loadGeometryPacker();
    const isPicture = !isAov(contentOf(view.settings));
    const compiled = stages.hasSketch || !isPicture ? stages.ready(view.subject) : null;
    this.#sketch();
    await compiled;
  }

  /** Works on a sketch for a moment, unless it is no picture that is wanted. */
  #sketch(): void {
    const { view, canvas } = this.#easel;
    const { width, height } = canvas;
    const { camera, settings } = view;
    if (isAov(contentOf(settings))) return;
    const wish = () => ({ moment: view.momentNow(), camera, framing: settings.framing, width, height });
    if (this.stages.sketch(`${view.revision} ${width} ${height}`, wish)) this.#show();
  }

  #shot(moment: Moment): Shot {
    const { view } = this.#easel;
    return { ...moment, camera: view.cameraAt(moment), settings: view.settings, raysPerPixel: view.raysPerPixel() };
  }

  /** From the picture to another view its film is laid aside, and gone on with later if the world is still the same. */
  #turn(): void {
    const { view } = this.#easel;
    const showsPicture = !isAov(contentOf(view.settings));
    if (showsPicture === this.#showsPicture) return;
    this.#showsPicture = showsPicture;
    if (!showsPicture) this.#park();
    else if (this.#parked?.world === view.worldRevision) this.#takeParked(this.#parked);
    else this.#discardParked();
  }

  #park(): void {
    const { complete, world } = this.#record;
    if (!complete || this.stages.film.samples === 0 || world !== this.#easel.view.worldRevision) return;
    this.#parked = this.#record;
    this.stages.park();
  }

  #takeParked(record: FilmRecord): void {
    this.#record = record;
    this.#parked = null;
    record.revision = this.#easel.view.revision;
    this.stages.takeParked(this.#shot(this.#easel.view.momentNow()));
    this.#show();
    this.#shownFilm = record.revision;
    this.#note(record);
  }

  #discardParked(): void {
    this.#parked = null;
    this.stages.discardParked();
  }

  /** Whether the integrator that is wanted can draw. */
  get #complete(): boolean {
    return this.stages.has(this.#easel.view.subject);
  }

  #enough(): boolean {
    return this.stages.film.samples >= this.#most;
  }

  /** Samples that the film is to have. */
  get #most(): number {
    return this.#record.complete
      ? Math.min(this.#easel.view.settings.maxSamples, this.stages.device.maxFilmSamples)
      : 1;
  }

  /** Samples of the next frame. The first picture comes with one; a film at most doubles, so that one sees it get better. */
  #samplesOfFrame(): number {
    const { film, addsMany } = this.stages;
    if (!addsMany || film.samples === 0) return 1;
    const { controller, view } = this.#easel;
    const most = Math.min(MOST_PER_FRAME, film.samples, this.#most - film.samples);
    return controller.samplesPerFrame(film.width * film.height, view.settings.targetFps, most);
  }

  #rest(): void {
    const { view, figures, canvas } = this.#easel;
    if (view.shownRevision !== this.#shownRevision) this.#show();
    this.#shownRevision = view.shownRevision;
    this.#measure(true);
    // A frame of another view may have been finished after this film was taken up again.
    if (this.#inFlight === 0) this.#note(this.#record);
    figures.rest(canvas);
  }

  /** The film's size; room for the largest that the settings ask for is made at once. */
  #reserve(reduced: boolean): { width: number; height: number } {
    const { canvas, view, controller } = this.#easel;
    const { width, height } = canvas;
    const { targetFps, resolutionScale } = view.settings;
    const largest = Math.min(resolutionScale, this.stages.device.maxTextureSize / Math.max(width, height));
    const pixels = (side: number, scale: number) => Math.max(Math.round(side * scale), 1);
    this.stages.film.reserve(pixels(width, largest), pixels(height, largest), this.stages.layersFor(view.subject));
    const scale = reduced ? controller.movingScale(width * height, targetFps, largest) : largest;
    return { width: pixels(width, scale), height: pixels(height, scale) };
  }

  async #trace(unwanted: () => boolean): Promise<void> {
    const { controller, figures, onFrame } = this.#easel;
    const { revision } = this.#record;
    const count = this.#samplesOfFrame();
    const started = performance.now();
    // Taken when the sample is submitted: by the time that the device has finished it, the next frame may have been begun.
    let frame: Omit<DrawnFrame, 'finished'> | null = null;
    const submitted = () => {
      this.#show();
      this.#shownFilm = revision;
      this.#shownRevision = this.#easel.view.shownRevision;
      frame = { started, ...this.#frameNow(count) };
      this.#measure(false);
    };
    this.#inFlight++;
    try {
      this.#dropped = !(await this.stages.addSamples(count, controller, submitted, unwanted));
    } finally {
      this.#inFlight--;
    }
    if (this.#dropped) this.#forget();
    if (frame) onFrame(figures.count({ ...(frame as Omit<DrawnFrame, 'finished'>), finished: performance.now() }));
  }

  #forget(): void {
    this.#record.revision = -1;
    this.#begun = null;
  }

  /** Now and then asks how far the film has come. The answer comes later, and no frame waits for it. */
  #measure(last: boolean): void {
    const record = this.#record;
    const { samples } = this.stages.film;
    const now = performance.now();
    if (!record.complete || !record.isDue(samples, now, last)) return;
    // A device that is lost meanwhile is heard of elsewhere.
    record.take(samples, now, this.stages.measureError()).then(
      () => record === this.#record && this.#note(record),
      () => {},
    );
  }

  #note(record: FilmRecord): void {
    this.#easel.figures.note(record, this.#samples);
  }

  /** Samples of the integrator in the film. */
  get #samples(): number {
    return this.#record.complete ? this.stages.film.samples : 0;
  }

  #frameNow(added: number): Omit<DrawnFrame, 'started' | 'finished'> {
    const { canvas, view } = this.#easel;
    const { film } = this.stages;
    return {
      samples: this.#samples,
      record: this.#record,
      raysPerPixel: added * (this.#record.complete ? view.raysPerPixel() : view.previewRaysPerPixel()),
      filmWidth: film.width,
      filmHeight: film.height,
      canvasWidth: canvas.width,
      canvasHeight: canvas.height,
      time: this.#record.time,
    };
  }
}

/** Before the first film. */
const NO_FILM = new FilmRecord({ revision: -1, world: -1, complete: false, time: 0 });

/** What the display does with the film, in a word to compare. */
const lookOf = ({ settings: { exposure, toneMapping } }: View): string => `${exposure} ${toneMapping}`;
