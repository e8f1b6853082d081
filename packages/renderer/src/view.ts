/**
 * What is to be seen: scene, time, camera, settings, and whether it moves. Shared by the GPU renderer and the CPU one, which
 * look at `revision` to know that the picture changed. No GPU, no DOM.
 */

import { VIEW_NAMES } from './display/views.ts';
import { PIXEL_FILTERS } from './packed-scene/pack-filter.ts';
import type { Subject } from './programs.ts';
import type { Panel, RendererSettings } from './renderer-types.ts';
import { PROJECTIONS, wholeCamera } from './scene/camera.ts';
import { SCENE_LIMITS } from './scene/limits.ts';
import { type Moment, Motion } from './scene/motion.ts';
import { playingClip } from './scene/node-transforms.ts';
import type { Camera, Scene } from './scene/scene.ts';
import { TONE_MAPPINGS } from './scene/tone-mappings.ts';
import { cameraFault } from './scene/well-formed.ts';
import { usableScene } from './scene-file/usable-scene.ts';

export const DEFAULT_SETTINGS: RendererSettings = {
  integrator: 'classic',
  view: 'picture',
  maxDepth: -1,
  pixelFilter: 'box',
  independentSamples: false,
  maxReflections: 5,
  lightSamples: 9,
  exposure: 0,
  toneMapping: 'none',
  resolutionScale: 1,
  adaptive: true,
  targetFps: 60,
  maxSamples: 1024,
  seed: 0,
  comparison: null,
  framing: null,
};

/** Segments that paths without limit are taken to have. */
const USUAL_DEPTH = 8;
/** Longest step of the animation in one frame, seconds: a tab that slept goes on where it was. */
const LONGEST_STEP = 0.25;
/** Settings that only the display uses, or only the loop: the film stays valid. */
const NOT_IN_FILM = new Set<keyof RendererSettings>(['exposure', 'toneMapping', 'adaptive', 'targetFps', 'maxSamples']);

const wholeIn = (least: number, most: number) => (n: number) => Number.isInteger(n) && n >= least && n <= most;
const isReflections = wholeIn(0, SCENE_LIMITS.maxReflections);
const isSamples = wholeIn(1, SCENE_LIMITS.lightSamples);

/** For each setting: whether a value is allowed, and what is, in words. */
const ALLOWED: { [K in keyof RendererSettings]: [(value: RendererSettings[K]) => boolean, string] } = {
  integrator: [(name) => name === 'classic' || name === 'path', '"classic" or "path"'],
  view: [(name) => VIEW_NAMES.includes(name), VIEW_NAMES.map((name) => `"${name}"`).join(', ')],
  maxDepth: [
    (n) => n !== 0 && wholeIn(-1, SCENE_LIMITS.maxDepth)(n),
    `-1, or a whole number from 1 to ${SCENE_LIMITS.maxDepth}`,
  ],
  pixelFilter: [(name) => PIXEL_FILTERS.includes(name), PIXEL_FILTERS.map((name) => `"${name}"`).join(', ')],
  independentSamples: [(b) => typeof b === 'boolean', 'true or false'],
  maxReflections: [isReflections, `a whole number from 0 to ${SCENE_LIMITS.maxReflections}`],
  lightSamples: [isSamples, `a whole number from 1 to ${SCENE_LIMITS.lightSamples}`],
  exposure: [(n) => Math.abs(n) <= 32, 'stops from -32 to 32'],
  toneMapping: [(name) => TONE_MAPPINGS.includes(name), `one of ${TONE_MAPPINGS.join(', ')}`],
  resolutionScale: [(n) => n >= 0.1 && n <= 1, 'a number from 0.1 to 1'],
  adaptive: [(b) => typeof b === 'boolean', 'true or false'],
  targetFps: [(n) => n === 30 || n === 60, '30 or 60'],
  maxSamples: [wholeIn(1, 2 ** 24), 'a whole number from 1 to 16777216'],
  seed: [wholeIn(0, 2 ** 32 - 1), 'a whole number from 0 to 4294967295'],
  comparison: [
    (c) =>
      c === null ||
      (c?.panels?.length === 3 &&
        c.panels.every((p) => isReflections(p.maxReflections) && isSamples(p.lightSamples)) &&
        c.dividers?.length === 2 &&
        c.dividers.every((d) => d >= 0 && d <= 1)),
    'null, or three panels and two dividers from 0 to 1',
  ],
  framing: [
    (f) =>
      f === null ||
      (f?.center?.length === 2 && f.center.every((c) => c >= 0 && c <= 1) && f.height >= 0.01 && f.height <= 100),
    'null, or a center of two shares from 0 to 1 and a height from 0.01 to 100',
  ],
};

function checkSettings(settings: Partial<RendererSettings>): void {
  for (const [key, value] of Object.entries(settings)) {
    const rule = ALLOWED[key as keyof RendererSettings] as [(v: unknown) => boolean, string] | undefined;
    if (!rule) throw new TypeError(`There is no setting "${key}". There are: ${Object.keys(ALLOWED).join(', ')}.`);
    if (!rule[0](value))
      throw new RangeError(`The setting "${key}" is ${JSON.stringify(value)}; it must be ${rule[1]}.`);
  }
}

const isTriple = (v: unknown) => Array.isArray(v) && v.length === 3 && v.every(Number.isFinite);

const isIn = (n: number, least: number) => typeof n === 'number' && n >= least && n <= 1e9;

function checkCamera(camera: Camera): void {
  const { eye, target, up, verticalFov } = camera;
  if (![eye, target, up].every(isTriple) || !(verticalFov > 0 && verticalFov < 180))
    throw new TypeError(
      'A camera needs eye, target and up, each of three finite numbers, and a verticalFov between 0 and 180 degrees.',
    );
  const { projection, viewHeight, aperture, focusDistance } = wholeCamera(camera);
  if (!PROJECTIONS.includes(projection) || !isIn(viewHeight, 1e-6) || !isIn(aperture, 0) || !isIn(focusDistance, 0))
    throw new TypeError(
      `A camera's projection is one of ${PROJECTIONS.join(', ')}; its viewHeight is from 1e-6, its aperture and focusDistance are from 0 to 1e9 metres.`,
    );
  const fault = cameraFault(camera);
  if (fault)
    throw new RangeError(
      `The camera has no direction: its "${fault}" must not lie on the line of sight or at the eye.`,
    );
}

type WorkSettings = Panel & Pick<RendererSettings, 'integrator' | 'maxDepth'>;

/** Rays that one film pixel may need: camera and mirror rays, and a shadow ray for each light sample of each. */
export function raysPerPixel(scene: Scene | null, settings: WorkSettings): number {
  const { integrator, maxDepth, maxReflections, lightSamples } = settings;
  if (integrator === 'path') return 2 * (maxDepth < 0 ? USUAL_DEPTH : Math.min(maxDepth, USUAL_DEPTH));
  return (1 + maxReflections) * (1 + Object.keys(scene?.lights ?? {}).length * lightSamples);
}

/** Whether it is not the same at every time. */
const hasMotion = (scene: Scene): boolean => scene.animation.length > 0 || (playingClip(scene)?.tracks.length ?? 0) > 0;

export class View {
  /** Grows whenever the film's content would change. */
  revision = 0;
  /** The same but for the setting `view`: while it stays, a film of the picture is still good after a look at depths. */
  worldRevision = 0;
  /** Grows whenever anything that is shown would change. */
  shownRevision = 0;
  /** Grows whenever the film's content would change for another reason than the time. */
  timelessRevision = 0;
  /** Grows whenever somebody changes the world, not when its own time passes. */
  changesByHand = 0;
  playing = true;
  #settings: RendererSettings;
  #scene: Scene | null = null;
  #motion: Motion | null = null;
  /** Where `#motion` is. */
  #moment: Moment | null = null;
  #time = 0;
  #speed = 1;
  #camera: Camera | null = null;

  constructor(settings: Partial<RendererSettings> = {}) {
    checkSettings(settings);
    this.#settings = { ...DEFAULT_SETTINGS, ...settings };
  }

  get scene(): Scene | null {
    return this.#scene;
  }
  get settings(): Readonly<RendererSettings> {
    return this.#settings;
  }

  /** Throws a TypeError, and changes nothing, when it is no usable scene. */
  setScene(scene: Scene): void {
    this.#motion = new Motion(usableScene(scene));
    this.#moment = null;
    this.#scene = scene;
    this.#time = 0;
    this.#camera = null;
    this.#settings = { ...this.#settings, ...scene.render };
    this.#changedByHand();
  }

  /** What frames are made of at the present time. Good until time passes. */
  momentNow(): Moment {
    if (!this.#motion) throw new Error('Set a scene first.');
    this.#moment ??= this.#motion.at(this.#time);
    return this.#moment;
  }

  /** What is to be drawn now; see `Moment.scene`. It is worked out when somebody reads it. */
  get subject(): Subject {
    const { camera, settings } = this;
    const scene = () => this.momentNow().scene;
    return {
      camera,
      settings,
      get scene() {
        return scene();
      },
    };
  }

  set(settings: Partial<RendererSettings>): void {
    checkSettings(settings);
    const changed = (Object.keys(settings) as (keyof RendererSettings)[]).filter(
      (key) => settings[key] !== this.#settings[key],
    );
    if (changed.length === 0) return;
    this.#settings = { ...this.#settings, ...settings };
    const inFilm = changed.filter((key) => !NOT_IN_FILM.has(key));
    if (inFilm.length === 0) this.shownRevision++;
    else this.#changedByHand(inFilm.some((key) => key !== 'view'));
  }

  get time(): number {
    return this.#time;
  }
  set time(seconds: number) {
    if (!Number.isFinite(seconds)) throw new RangeError(`Time must be a finite number of seconds, not ${seconds}.`);
    if (seconds === this.#time) return;
    this.#time = seconds;
    this.#moment = null;
    this.changesByHand++;
    this.#filmChanged();
  }

  get speed(): number {
    return this.#speed;
  }
  set speed(factor: number) {
    if (!Number.isFinite(factor)) throw new RangeError(`Speed must be a finite number, not ${factor}.`);
    this.#speed = factor;
  }

  /** Whether time passing changes the picture. */
  get moves(): boolean {
    return this.playing && this.#speed !== 0 && this.#scene !== null && hasMotion(this.#scene);
  }

  /** Lets this many seconds of the world's time pass. */
  advance(seconds: number): void {
    if (this.playing && this.#scene) this.#passTime(Math.min(seconds, LONGEST_STEP) * this.#speed);
  }

  #passTime(step: number): void {
    const { moves } = this;
    this.#time += step;
    this.#moment = null;
    if (moves && step !== 0) this.#filmChanged();
  }

  get camera(): Camera {
    return this.cameraAt(this.momentNow());
  }
  /** At another moment: one that is set stays as it is. */
  cameraAt({ scene }: Moment): Camera {
    return this.#camera ?? scene.camera;
  }
  set camera(camera: Camera | null) {
    if (camera !== null) checkCamera(camera);
    this.#camera = camera;
    this.#changedByHand();
  }

  #changedByHand(world = true): void {
    this.changesByHand++;
    this.timelessRevision++;
    this.#filmChanged(world);
  }

  #filmChanged(world = true): void {
    if (world) this.worldRevision++;
    this.revision++;
    this.shownRevision++;
  }

  /** The mean over the panels. */
  raysPerPixel(): number {
    if (this.#settings.view !== 'picture') return 1;
    const panels = this.#settings.comparison?.panels ?? [this.#settings];
    const rays = panels.map((panel) => raysPerPixel(this.#scene, { ...this.#settings, ...panel }));
    return rays.reduce((sum, n) => sum + n, 0) / rays.length;
  }

  /** As `raysPerPixel`, of the preview: a camera ray and one shadow ray a light. */
  previewRaysPerPixel(): number {
    return 1 + Object.keys(this.#scene?.lights ?? {}).length;
  }
}
