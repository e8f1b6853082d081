/** Textures and images: pixels as PNG in the file itself. */
import type { Scene } from '../../scene/scene.ts';
import type { OnExportProgress } from '../export-plan.ts';
import { pngOf } from '../png-of-image.ts';
import type { GltfFile } from './gltf-file.ts';

const WRAPS = { repeat: 10497, clamp: 33071, mirror: 33648 } as const;

export class TextureWriter {
  readonly #file: GltfFile;
  readonly #scene: Scene;
  readonly #textures = new Map<string, number>();
  readonly #images = new Map<string, number>();
  readonly #samplers = new Map<string, number>();
  readonly #onProgress: OnExportProgress | undefined;
  #pixels = 0;

  constructor(file: GltfFile, scene: Scene, onProgress?: OnExportProgress) {
    this.#file = file;
    this.#scene = scene;
    this.#onProgress = onProgress;
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
    const png = pngOf(data);
    const place = this.#file.add('images', { name, bufferView: this.#file.view(png), mimeType: 'image/png' });
    this.#images.set(name, place);
    this.#pixels += data.rgba.length;
    this.#onProgress?.(this.#pixels / this.#allPixels());
    return place;
  }

  /** Of all images of the scene, though a few may be used by nothing. */
  #allPixels(): number {
    return Object.values(this.#scene.images ?? {}).reduce((sum, { data }) => sum + (data?.rgba.length ?? 0), 0);
  }
}
