/** Textures and images: pixels as PNG in the file itself. */
import { encode } from 'fast-png';
import type { Scene } from '../../scene/scene.ts';
import type { GltfFile } from './gltf-file.ts';

const WRAPS = { repeat: 10497, clamp: 33071, mirror: 33648 } as const;

export class TextureWriter {
  readonly #file: GltfFile;
  readonly #scene: Scene;
  readonly #textures = new Map<string, number>();
  readonly #images = new Map<string, number>();
  readonly #samplers = new Map<string, number>();

  constructor(file: GltfFile, scene: Scene) {
    this.#file = file;
    this.#scene = scene;
  }

  place(name: string): number {
    const known = this.#textures.get(name);
    if (known !== undefined) return known;
    const {
      image,
      wrapU = 'repeat',
      wrapV = 'repeat',
      filter = 'linear',
      mipmaps = true,
    } = this.#scene.textures![name]!;
    const nearest = filter === 'nearest';
    const sampler = {
      wrapS: WRAPS[wrapU],
      wrapT: WRAPS[wrapV],
      magFilter: nearest ? 9728 : 9729,
      minFilter: mipmaps ? (nearest ? 9984 : 9987) : nearest ? 9728 : 9729,
    };
    const place = this.#file.add('textures', { name, source: this.#image(image), sampler: this.#sampler(sampler) });
    this.#textures.set(name, place);
    return place;
  }

  #sampler(sampler: object): number {
    const key = JSON.stringify(sampler);
    const known = this.#samplers.get(key) ?? this.#file.add('samplers', sampler);
    this.#samplers.set(key, known);
    return known;
  }

  #image(name: string): number {
    const known = this.#images.get(name);
    if (known !== undefined) return known;
    const data = this.#scene.images![name]?.data;
    if (data === undefined) throw new TypeError(`The image "${name}" has not been loaded.`);
    const { width, height, rgba } = data;
    const png = encode({ width, height, channels: 4, depth: 8, data: rgba });
    const place = this.#file.add('images', { name, bufferView: this.#file.view(png), mimeType: 'image/png' });
    this.#images.set(name, place);
    return place;
  }
}
