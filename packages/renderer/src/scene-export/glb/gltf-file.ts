/** A glTF file in the making: lists of JSON objects, and one buffer. */

// biome-ignore lint/suspicious/noExplicitAny: JSON of another format, whose reader checks it
export type Json = any;

type Numbers = Float32Array | Uint16Array | Uint32Array;
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 } as const;
const componentOf = (numbers: Numbers): number =>
  numbers instanceof Float32Array ? 5126 : numbers instanceof Uint16Array ? 5123 : 5125;

/** The file says its length in 32 bits. */
const MOST_BYTES = 2 ** 32 - 1;

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
    this.#append(bytes);
    return place;
  }

  /** Without a copy; the next begins at a multiple of four. */
  #append(bytes: Uint8Array): void {
    const missing = -bytes.length & 3;
    this.#chunks.push(bytes, ...(missing > 0 ? [new Uint8Array(missing)] : []));
    this.#length += bytes.length + missing;
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

  /** The whole file in pieces, of which some are arrays of the scene. `root`: what stands beside the lists. */
  glb(root: Json): readonly Uint8Array[] {
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
    const hasNumbers = this.#length > 0;
    const length = 12 + 8 + jsonLength + (hasNumbers ? 8 + this.#length : 0);
    if (length > MOST_BYTES)
      throw new Error(`The scene takes ${length} bytes, and a .glb file holds ${MOST_BYTES} at most.`);
    const head = new Uint8Array(20 + jsonLength + (hasNumbers ? 8 : 0));
    const words = new DataView(head.buffer);
    [0x46546c67, 2, length, jsonLength, 0x4e4f534a].forEach((word, i) => {
      words.setUint32(4 * i, word, true);
    });
    head.fill(32, 20, 20 + jsonLength);
    head.set(text, 20);
    if (!hasNumbers) return [head];
    words.setUint32(20 + jsonLength, this.#length, true);
    words.setUint32(24 + jsonLength, 0x004e4942, true);
    return [head, ...this.#chunks];
  }
}
