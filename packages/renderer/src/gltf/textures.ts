/** Textures and images of a file. */
import type { ImagePixels, ImageSource, NormalTextureUse, Texture, TextureUse, Wrap } from '../scene/textures.ts';
import { quote } from '../scene-file/problem.ts';
import { readUri, type Sources } from './buffers.ts';
import type { ImageDecoder } from './images/decoder.ts';
import { type ImageHead, readImageHead, strangeImage } from './images/image-head.ts';
import { extensionOf } from './json.ts';
import { GLTF_LIMITS } from './limits.ts';
import { addProblem, type Path } from './problems.ts';
import { NamedThings, type Reading } from './reading.ts';

export interface TextureInfo {
  readonly index: number;
  readonly texCoord?: number;
  readonly scale?: number;
  readonly extensions?: unknown;
}
interface TransformJson {
  readonly offset?: [number, number];
  readonly rotation?: number;
  readonly scale?: [number, number];
  readonly texCoord?: number;
}

/** An image made of one or two others, texel by texel, once they are decoded. `key`: what else it depends on. */
export interface Making {
  /** What it shows, for its name. */
  readonly word: string;
  readonly key: readonly number[];
  readonly make: (first: ImagePixels, second?: ImagePixels) => ImagePixels;
}

interface ImageFile {
  readonly bytes: Uint8Array;
  readonly head: ImageHead;
}

const WRAPS: Readonly<Record<number, Wrap>> = { 10497: 'repeat', 33071: 'clamp', 33648: 'mirror' };
/** Beside what every reader knows: the newer format first, as who writes both wants it taken. */
const NEWER_SOURCES = ['EXT_texture_avif', 'EXT_texture_webp'] as const;
/** Blocks for GPUs, which lose more and need a large transcoder: when there is nothing else. */
const LAST_SOURCE = 'KHR_texture_basisu';
/** So many images are decoded at a time. */
const AT_ONCE = 4;

export class TextureReader {
  readonly #reading: Reading;
  readonly #decoder: ImageDecoder;
  readonly #sources: Sources;
  readonly #files = new Map<number, Promise<ImageFile | null>>();
  /** By place in the file's list of images: pixels, or why there are none. */
  readonly #decoded = new Map<number, Promise<ImagePixels | { readonly reason: string }>>();
  /** By place in the file's list of textures: the image taken, or null when none can be. */
  readonly #chosen = new Map<number, number | null>();
  readonly #heads = new Map<number, ImageHead>();
  /** By image and how it is looked up. */
  readonly #names = new Map<string, string>();
  /** Images that are made of others, whose places in the file these are; by what they are made of. */
  readonly #made = new Map<
    string,
    { readonly name: string; readonly of: readonly number[]; readonly make: Making['make'] }
  >();
  readonly textures = new NamedThings<Texture>();
  readonly images = new NamedThings<ImageSource>();

  constructor(reading: Reading, decoder: ImageDecoder, sources: Sources) {
    this.#reading = reading;
    this.#decoder = decoder;
    this.#sources = sources;
  }

  /**
   * Finds the file of each texture, and has the images decoded while other things are read. To be called with all textures in use, before
   * `use`.
   */
  async open(textures: Iterable<number>): Promise<void> {
    for (const index of new Set(textures)) this.#chosen.set(index, await this.#choose(index));
    const images = [...new Set(this.#chosen.values())].filter((image) => image !== null);
    const files = await Promise.all(images.map(async (index) => ({ index, file: await this.#files.get(index)! })));
    const whole = files.filter((entry): entry is { index: number; file: ImageFile } => entry.file !== null);
    if (this.#checkSizes(whole)) this.#decodeAll(whole);
  }

  /** The first of a texture's images that can be decoded. */
  async #choose(index: number): Promise<number | null> {
    const texture = this.#reading.json.textures![index]!;
    const path = ['textures', index];
    const other = (name: string) => ({ name, source: extensionOf<{ source?: number }>(texture, name)?.source });
    const all = [...NEWER_SOURCES.map(other), { name: 'source', source: texture.source }, other(LAST_SOURCE)];
    const candidates = all.filter(({ source }) => source !== undefined);
    for (const { name, source } of candidates) {
      const file = await this.#file(source!);
      if (file === null) return null; // a problem has been added
      if (this.#decoder.canDecode(file.head.type)) return source!;
      const { type } = file.head;
      const instead =
        source === candidates.at(-1)!.source ? 'the texture is left out' : 'another image of the texture stands for it';
      this.#reading.report.add(
        'unsupported',
        name === 'source' ? type : name,
        path,
        `Images of the kind ${type} cannot be decoded here; ${instead}.`,
      );
    }
    if (candidates.length === 0)
      this.#reading.report.add('unsupported', 'texture', path, 'A texture has no image; it is left out.');
    return null;
  }

  #file(index: number): Promise<ImageFile | null> {
    let file = this.#files.get(index);
    if (file === undefined) this.#files.set(index, (file = this.#open(index)));
    return file;
  }

  async #open(index: number): Promise<ImageFile | null> {
    const { json, buffers, problems } = this.#reading;
    const { bufferView, uri } = json.images![index]!;
    const path = ['images', index];
    let bytes: Uint8Array | null = null;
    if (bufferView !== undefined) {
      const { buffer, byteOffset = 0, byteLength } = json.bufferViews![bufferView]!;
      bytes = buffers[buffer]?.subarray(byteOffset, byteOffset + byteLength) ?? null;
    } else if (uri !== undefined) bytes = await readUri(uri, [...path, 'uri'], this.#sources);
    else addProblem(problems, path, 'no image', 'a "uri" or a "bufferView"');
    if (bytes === null) return null;
    const head = readImageHead(bytes);
    if (head === null)
      addProblem(problems, path, strangeImage(bytes), 'PNG or JPEG, or with an extension WebP, AVIF or KTX2');
    return head && { bytes, head };
  }

  /** How a material uses a texture, or undefined when it cannot. */
  use(info: TextureInfo | undefined, path: Path): TextureUse | undefined {
    const image = info && this.#chosen.get(info.index);
    if (info === undefined || image === undefined || image === null) return undefined;
    const transform = extensionOf<TransformJson>(info, 'KHR_texture_transform');
    const uvSet = transform?.texCoord ?? info.texCoord ?? 0;
    if (uvSet > 1) {
      this.#reading.report.add(
        'unsupported',
        `TEXCOORD_${uvSet}`,
        path,
        'Meshes have two sets of texture coordinates, 0 and 1; the texture is left out.',
      );
      return undefined;
    }
    const { offset, rotation, scale } = transform ?? {};
    return {
      texture: this.#nameOf(info.index, image),
      ...(uvSet === 1 && { uvSet }),
      ...(offset && { offset }),
      ...(rotation && { rotation: (rotation * 180) / Math.PI }),
      ...(scale && { scale }),
    };
  }

  /** As `use`, of what is made of the texture's image, and of the other's where there is one that can be used. */
  useMade(info: TextureInfo, path: Path, making: Making, other?: TextureInfo): TextureUse | undefined {
    const use = this.use(info, path);
    if (!use) return undefined;
    const of = [info, ...(other ? [other] : [])]
      .map(({ index }) => this.#chosen.get(index))
      .filter((image) => typeof image === 'number');
    const key = JSON.stringify([making.word, ...making.key, ...of]);
    let made = this.#made.get(key);
    if (!made) {
      const name = this.images.add({}, `${this.#imageName(of[0]!)} ${making.word}`, making.word);
      this.#made.set(key, (made = { name, of, make: making.make }));
    }
    const like = this.textures.things[use.texture]!;
    const texture = this.#textureOf({ ...like, image: made.name }, made.name, made.name);
    return { ...use, texture };
  }

  /** Whether two textures lie on a mesh in the same way. */
  lieAlike(a: TextureInfo, b: TextureInfo | undefined): boolean {
    if (!b) return true;
    const { json } = this.#reading;
    const how = ({ index, texCoord = 0, extensions }: TextureInfo) => JSON.stringify([json.textures![index]!.sampler, texCoord, extensions]); // biome-ignore format: one thought
    return how(a) === how(b);
  }

  useNormal(info: TextureInfo | undefined, path: Path): NormalTextureUse | undefined {
    const use = this.use(info, path);
    return use && { ...use, ...(info!.scale !== undefined && { normalScale: info!.scale }) };
  }

  #nameOf(texture: number, image: number): string {
    const { json } = this.#reading;
    const { sampler, name } = json.textures![texture]!;
    const {
      wrapS = 10497,
      wrapT = 10497,
      magFilter,
      minFilter,
    } = sampler === undefined ? {} : json.samplers![sampler]!;
    const nearest = magFilter === 9728;
    const mipmaps = minFilter !== 9728 && minFilter !== 9729;
    const made: Texture = {
      image: this.#imageName(image),
      ...(wrapS !== 10497 && { wrapU: WRAPS[wrapS]! }),
      ...(wrapT !== 10497 && { wrapV: WRAPS[wrapT]! }),
      ...(nearest && { filter: 'nearest' as const }),
      ...(!mipmaps && { mipmaps }),
    };
    return this.#textureOf(made, name, json.images![image]!.name ?? `texture ${texture}`);
  }

  /** Its name: each is there once. */
  #textureOf(texture: Texture, wanted: string | undefined, otherwise: string): string {
    const { image, wrapU, wrapV, filter, mipmaps } = texture;
    const key = JSON.stringify([image, wrapU, wrapV, filter, mipmaps]);
    let name = this.#names.get(key);
    if (name === undefined) this.#names.set(key, (name = this.textures.add(texture, wanted, otherwise)));
    return name;
  }

  #imageName(image: number): string {
    const { name, uri } = this.#reading.json.images![image]!;
    const file = uri === undefined || /^data:/i.test(uri) ? undefined : uri.split('/').at(-1);
    return this.images.nameOf(image) ?? this.images.add({}, name ?? file, `image ${image}`, image);
  }

  /** Decodes all images that uses have named. Adds problems for those that are damaged. */
  async load(onEach: (done: number, total: number) => void): Promise<void> {
    const made = [...this.#made.values()];
    const parts = new Set(made.flatMap(({ of }) => of));
    const wanted = [...this.#files.keys()].filter(
      (index) => this.images.nameOf(index) !== undefined || parts.has(index),
    );
    for (const [i, index] of wanted.entries()) {
      this.#take(index, (await this.#files.get(index))!, await this.#decoded.get(index)!);
      onEach(i + 1, wanted.length);
    }
    if (!this.#reading.problems.isEmpty || !this.#checkMade(made)) return;
    for (const { name, of, make } of made) {
      const [first, second] = await Promise.all(
        of.map(async (index) => (await this.#decoded.get(index)!) as ImagePixels),
      );
      this.images.things[name] = { data: make(first!, second) };
    }
  }

  /** Images are small enough that were decoded, and yet many more may be made of them. */
  #checkMade(made: readonly { readonly of: readonly number[] }[]): boolean {
    const sizes = made.map(({ of }) => of.map((index) => this.#heads.get(index)!));
    const bytes = sizes.reduce((sum, heads) => sum + 4 * Math.max(...heads.map(({ width }) => width)) * Math.max(...heads.map(({ height }) => height)), 0); // biome-ignore format: one sum
    const isRoom = bytes <= GLTF_LIMITS.imageBytes;
    if (!isRoom)
      addProblem(this.#reading.problems, ['materials'], `specular-glossiness images that make others of ${bytes} bytes`, `at most ${GLTF_LIMITS.imageBytes} bytes`); // biome-ignore format: one sentence
    return isRoom;
  }

  #decodeAll(files: readonly { index: number; file: ImageFile }[]): void {
    const lanes: Promise<unknown>[] = Array.from({ length: AT_ONCE }, () => Promise.resolve());
    for (const [i, { index, file }] of files.entries()) {
      const decoded = lanes[i % AT_ONCE]!.then(() => this.#decode(file));
      lanes[i % AT_ONCE] = decoded;
      this.#decoded.set(index, decoded);
    }
  }

  /** Before anything is decoded: files of a few bytes may stand for pixels without end. */
  #checkSizes(files: readonly { index: number; file: ImageFile }[]): boolean {
    const { problems } = this.#reading;
    let bytes = 0;
    for (const { index, file } of files) {
      const { width, height } = file.head;
      this.#heads.set(index, file.head);
      const isSide = (side: number): boolean => side >= 1 && side <= GLTF_LIMITS.imageSide;
      if (!isSide(width) || !isSide(height))
        addProblem(
          problems,
          ['images', index],
          `${width} × ${height} pixels`,
          `1 to ${GLTF_LIMITS.imageSide} pixels a side`,
        );
      bytes += width * height * 4;
    }
    if (bytes > GLTF_LIMITS.imageBytes)
      addProblem(
        problems,
        ['images'],
        `images of ${bytes} bytes once they are decoded`,
        `at most ${GLTF_LIMITS.imageBytes} bytes`,
      );
    return problems.isEmpty;
  }

  async #decode({ bytes, head }: ImageFile): Promise<ImagePixels | { readonly reason: string }> {
    try {
      return await this.#decoder.decode(bytes, head.type);
    } catch (error) {
      return { reason: (error instanceof Error ? error.message : String(error)).replace(/\.$/, '') };
    }
  }

  #take(index: number, { head }: ImageFile, decoded: ImagePixels | { readonly reason: string }): void {
    const { problems, report } = this.#reading;
    const path = ['images', index];
    // Without one, something else is made of it.
    const name = this.images.nameOf(index);
    if (head.depth > 8)
      report.add('changed', `${head.depth}-bit image`, path, `Channels of ${head.depth} bits are rounded to 8.`);
    if (!('reason' in decoded)) {
      if (name !== undefined) this.images.things[name] = { data: decoded };
    } else
      addProblem(
        problems,
        path,
        `the image ${quote(name ?? String(index))}, which cannot be decoded (${decoded.reason})`,
        `a whole ${head.type}`,
      );
  }
}
