/** Makes sketches of a scene while its program is being compiled: a coarse one at once, finer ones while nothing changes. */
import type { Device, FilmTexture } from './gpu/device.ts';
import { geometryPacker } from './packed-scene/geometry-packer.ts';
import { packPathScene } from './packed-scene/pack-path-scene.ts';
import type { Framing } from './renderer-types.ts';
import type { Moment } from './scene/motion.ts';
import type { Camera } from './scene/scene.ts';
import type { SketchView } from './sketch/sketch.ts';

/** Canvas pixels along a side for one of the sketch's, from one sketch to the next. */
const COARSENESS = [16, 8, 4, 2] as const;
/** Pixels that a sketch may have. */
const MOST_PIXELS = 300_000;
/** Longest stretch of work in a frame, milliseconds: the page stays alive. The first sketch is worth a longer one. */
const SLICE_MS = 12;
const FIRST_SLICE_MS = 80;

/** What is to be sketched, on a canvas of this size. */
export interface SketchWish {
  readonly moment: Moment;
  readonly camera: Camera;
  readonly framing: Framing | null;
  readonly width: number;
  readonly height: number;
}

/** A whole sketch: as a film holds pictures. */
export interface Sketch {
  readonly film: FilmTexture;
  readonly width: number;
  readonly height: number;
}

export class Sketcher {
  readonly #device: Device;
  #sketch: Sketch | null = null;
  #key = '';
  #next = 0;
  #work: { readonly steps: Generator<void, void, void>; readonly pixels: Float32Array<ArrayBuffer>; readonly width: number; readonly height: number } | null = null; // biome-ignore format: one type
  #packed: Pick<SketchView, 'geometry' | 'shapeNames'> | null = null;

  constructor(device: Device) {
    this.#device = device;
  }

  /** The newest; null when there is none of what `step` was last asked for. */
  get sketch(): Sketch | null {
    return this.#sketch;
  }

  /** Works for a moment. `key` tells one picture from another: with a new one it begins again. Returns whether there is a new sketch. */
  step(key: string, wish: () => SketchWish): boolean {
    if (key !== this.#key) {
      this.#key = key;
      this.#next = 0;
      this.#work = null;
      this.#packed = null;
    }
    const ends = performance.now() + (this.#next === 0 ? FIRST_SLICE_MS : SLICE_MS);
    this.#work ??= this.#begin(wish);
    if (!this.#work) return false;
    while (!this.#work.steps.next().done) if (performance.now() > ends) return false;
    this.#next++;
    this.#show();
    return true;
  }

  /** Null when the sketch is as fine as it gets, or nothing can be sketched yet. */
  #begin(wish: () => SketchWish) {
    const packer = geometryPacker();
    if (!packer || this.#next >= COARSENESS.length) return null;
    const { moment, camera, framing, width: columns, height: rows } = wish();
    const [width, height] = [columns, rows].map((side) => Math.max(Math.round(side / COARSENESS[this.#next]!), 1)) as [number, number]; // biome-ignore format: two sides
    if (width * height > MOST_PIXELS) return null;
    const packed = this.#packed ?? packPathScene(moment, camera.eye);
    this.#packed = { geometry: packed.geometry!, shapeNames: packed.shapeNames };
    const pixels = new Float32Array(4 * width * height);
    return { steps: packer.sketchInSteps({ scene: moment.scene, camera, framing, width, height, ...this.#packed }, pixels), pixels, width, height }; // biome-ignore format: one object
  }

  #show(): void {
    const { pixels, width, height } = this.#work!;
    this.#work = null;
    if (this.#sketch?.width !== width || this.#sketch.height !== height) {
      this.#sketch?.film.destroy();
      this.#sketch = { film: this.#device.createFilm(width, height), width, height };
    }
    this.#device.write(this.#sketch.film.layers[0]!, pixels, width, height);
  }

  /** The real picture is there. */
  release(): void {
    this.#sketch?.film.destroy();
    this.#sketch = null;
    this.#key = '';
    this.#work = null;
    this.#packed = null;
  }
}
