/**
 * Where a program of several passes keeps what it knows of each path. Not of a whole film: paths take 288 bytes each, so a film goes through it
 * a stripe at a time. It has two halves, so that the device has one to work on while the other's stripe is asked whether it is done.
 */
import type { Device, FilmTexture } from '../../gpu/device.ts';

/** Paths of both halves: 72 MiB, and enough at once for a large GPU. */
const PATHS = 2 ** 18;
/** Layers, as path_relay.wesl has them. */
const LAYERS = { path: 8, hit: 2, choice: 8 };

export interface RelayWords {
  readonly path: FilmTexture;
  readonly hit: FilmTexture;
  readonly choice: FilmTexture;
  readonly width: number;
  /** Of one half. */
  readonly rows: number;
}

export class RelayRoom {
  readonly #device: Device;
  #words: RelayWords | null = null;

  constructor(device: Device) {
    this.#device = device;
  }

  /** Words for stripes of a film of this size. Throws a `DeviceError` when there is no room. */
  wordsFor(width: number, height: number): RelayWords {
    const rows = Math.max(Math.min(Math.floor(PATHS / 2 / width), Math.ceil(height / 2)), 1);
    const now = this.#words;
    if (now && now.width >= width && now.rows >= rows && now.width * now.rows <= PATHS) return now;
    this.release();
    const create = (layers: number) => this.#device.relay!.createWords(width, 2 * rows, layers);
    this.#words = { path: create(LAYERS.path), hit: create(LAYERS.hit), choice: create(LAYERS.choice), width, rows };
    return this.#words;
  }

  /** Gives the memory back. */
  release(): void {
    if (!this.#words) return;
    for (const words of [this.#words.path, this.#words.hit, this.#words.choice]) words.destroy();
    this.#words = null;
  }
}
