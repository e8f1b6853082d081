/**
 * The film: for each pixel, float32 sums of radiance and, in alpha, of samples; in a second layer, if asked for, the sums of the
 * samples' squares, from which the standard error follows. Two films take turns, since a pass cannot read what it draws. They are as large as the largest picture; smaller ones use their first columns and rows, so that a change
 * of resolution allocates nothing.
 */
import type { Device, FilmTexture } from '../gpu/device.ts';

/** A whole picture: the first width × height pixels of the film. */
export interface Picture {
  readonly film: FilmTexture;
  readonly width: number;
  readonly height: number;
}

export class Film {
  readonly #device: Device;
  #textures: [FilmTexture, FilmTexture] | null = null;
  #picture: Picture | null = null;
  #width = 0;
  #height = 0;
  #samples = 0;
  #firstSample = 0;

  constructor(device: Device) {
    this.#device = device;
  }

  get width(): number {
    return this.#width;
  }
  get height(): number {
    return this.#height;
  }
  /** Samples that every pixel holds. */
  get samples(): number {
    return this.#samples;
  }
  /** Index of the sample that comes next: what its random numbers are made of. */
  get nextSample(): number {
    return this.#firstSample + this.#samples;
  }
  /** The finished sums. */
  get current(): FilmTexture {
    return this.#textures![0];
  }
  /** Where the next sample is drawn. */
  get next(): FilmTexture {
    return this.#textures![1];
  }

  /** The newest whole picture, there until the next one is complete, whatever is begun meanwhile; null before the first. */
  get picture(): Picture | null {
    return this.#picture;
  }

  /** Makes room for pictures of up to this size. With another size or number of layers than before the film starts over. */
  reserve(width: number, height: number, layers = 1): void {
    const now = this.#textures?.[0];
    if (now && now.width === width && now.height === height && now.layers.length === layers) return;
    for (const texture of this.#textures ?? []) if (texture !== this.#picture?.film) texture.destroy();
    const create = () => this.#device.createFilm(width, height, layers);
    this.#textures = [create(), create()];
    this.#samples = 0;
  }

  /** Starts over with this size, at most what is reserved. */
  restart(width: number, height: number): void {
    this.#width = width;
    this.#height = height;
    this.#samples = 0;
    this.#firstSample = 0;
  }

  /** Goes on at sample `next`: from sums that were read before, of `samples` samples, or from none. */
  resume(next: number, samples: number, sums: Float32Array<ArrayBuffer> | null): void {
    const [width, height] = [this.#width, this.#height];
    const texels = 4 * width * height;
    this.#samples = samples;
    this.#firstSample = next - samples;
    if (!sums || sums.length < texels * this.current.layers.length) this.#device.clear(this.current);
    if (!sums) return;
    this.current.layers.forEach((layer, i) => {
      const own = sums.subarray(i * texels, (i + 1) * texels);
      if (own.length === texels) this.#device.write(layer, own, width, height);
    });
  }

  /** The first `count` layers' sums as they are, layer after layer, row 0 first: RGB + samples, then RGB of the squares and 0. */
  async readSums(count: number): Promise<Float32Array<ArrayBuffer>> {
    const [width, height] = [this.#width, this.#height];
    const texels = 4 * width * height;
    const layers = this.current.layers.slice(0, count);
    const sums = new Float32Array(texels * layers.length);
    // At once, since samples may be added meanwhile.
    const read = await Promise.all(layers.map((layer) => this.#device.read(layer, width, height)));
    for (const [i, values] of read.entries()) sums.set(values, i * texels);
    return sums;
  }

  /** `count` more samples in `next` are complete. */
  swap(count = 1): void {
    const before = this.#picture?.film;
    const textures = this.#textures!;
    textures.reverse();
    this.#samples += count;
    this.#picture = { film: textures[0], width: this.#width, height: this.#height };
    if (before && !textures.includes(before)) before.destroy();
  }

  /** Mean radiance, linear RGB + samples, row 0 first. */
  async read(): Promise<Float32Array<ArrayBuffer>> {
    const pixels = await this.#device.read(this.current.layers[0]!, this.#width, this.#height);
    for (let i = 0; i < pixels.length; i += 4) {
      const n = Math.max(pixels[i + 3]!, 1);
      for (let c = 0; c < 3; c++) pixels[i + c]! /= n;
    }
    return pixels;
  }

  destroy(): void {
    const textures = new Set<FilmTexture>(this.#textures ?? []);
    if (this.#picture) textures.add(this.#picture.film);
    for (const texture of textures) texture.destroy();
    this.#textures = null;
    this.#picture = null;
  }
}
