/** A glTF file in the making: lists of JSON objects, and one buffer. */

// biome-ignore lint/suspicious/noExplicitAny: JSON of another format, whose reader checks it
export type Json = any;

type Numbers = Float32Array | Uint16Array | Uint32Array;
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 } as const;
const componentOf = (numbers: Numbers): number =>
  numbers instanceof Float32Array ? 5126 : numbers instanceof Uint16Array ? 5123 : 5125;

export class GltfFile {
  readonly #lists: Record<string, Json[]> = {};
  readonly #chunks: Uint8Array[] = [];
  #length = 0;
  readonly #extensions = new Set<string>();
  readonly #accessors = new Map<Numbers, number>();

  /** Adds to one of the lists; gives the place. */
  add(list: string, thing: Json): number {
    this.#lists[list] ??= [];
    return this.#lists[list].push(thing) - 1;
  }

  /** What has been added; may be changed. */
  at(list: string, place: number): Json {
    return this.#lists[list]![place];
  }

  /** An extension of a thing, which the file then says that it uses. */
  extend(thing: Json, name: string): Json {
    this.#extensions.add(name);
    thing.extensions ??= {};
    thing.extensions[name] ??= {};
    return thing.extensions[name];
  }

  view(bytes: Uint8Array, more: object = {}): number {
    const place = this.add('bufferViews', { buffer: 0, byteOffset: this.#length, byteLength: bytes.length, ...more });
    const padded = new Uint8Array((bytes.length + 3) & ~3);
    padded.set(bytes);
    this.#chunks.push(padded);
    this.#length += padded.length;
    return place;
  }

  /** The same array is in the file once. */
  accessor(numbers: Numbers, type: keyof typeof WIDTHS, more: object = {}): number {
    const known = this.#accessors.get(numbers);
    if (known !== undefined) return known;
    const bufferView = this.view(new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength));
    const count = numbers.length / WIDTHS[type];
    const place = this.add('accessors', { bufferView, componentType: componentOf(numbers), count, type, ...more });
    this.#accessors.set(numbers, place);
    return place;
  }

  /** The whole file. `root`: what stands beside the lists. */
  glb(root: Json): Uint8Array<ArrayBuffer> {
    const used = [...this.#extensions].sort();
    const json = {
      asset: { version: '2.0', generator: 'Mirrorball' },
      ...root,
      ...(used.length > 0 && { extensionsUsed: used }),
      ...this.#lists,
      ...(this.#length > 0 && { buffers: [{ byteLength: this.#length }] }),
    };
    const text = new TextEncoder().encode(JSON.stringify(json));
    const jsonLength = (text.length + 3) & ~3;
    const length = 12 + 8 + jsonLength + (this.#length > 0 ? 8 + this.#length : 0);
    const file = new Uint8Array(length);
    const words = new DataView(file.buffer);
    [0x46546c67, 2, length, jsonLength, 0x4e4f534a].forEach((word, i) => {
      words.setUint32(4 * i, word, true);
    });
    file.fill(32, 20, 20 + jsonLength);
    file.set(text, 20);
    if (this.#length === 0) return file;
    words.setUint32(20 + jsonLength, this.#length, true);
    words.setUint32(24 + jsonLength, 0x004e4942, true);
    let at = 28 + jsonLength;
    for (const chunk of this.#chunks) {
      file.set(chunk, at);
      at += chunk.length;
    }
    return file;
  }
}
