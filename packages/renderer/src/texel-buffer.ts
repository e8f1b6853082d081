/** The textures of one scene on a device: images are uploaded when others are to be seen, what they are used for whenever a scene is packed. */
import type { DataBuffer, Device } from './gpu/device.ts';
import { GEOMETRY_ROW } from './packed-scene/layout.ts';
import type { PackedTextures } from './packed-scene/pack-textures.ts';
import type { ImagePixels } from './scene/textures.ts';

/** Bytes of an image that are copied at once, where they do not lie as a device wants them. */
const PIECE = 2 ** 20;
const ROW_BYTES = GEOMETRY_ROW * 4;

export class TexelBuffer {
  readonly #device: Device;
  #buffer: DataBuffer | null = null;
  #images: PackedTextures['images'] = [];

  constructor(device: Device) {
    this.#device = device;
  }

  /** Throws a `DeviceError`, and keeps what it holds, when the device has no room. */
  hold({ uses, images, rows }: PackedTextures): void {
    const same = (one: PackedTextures['images'][number], i: number) =>
      one.pixels === this.#images[i]?.pixels && one.row === this.#images[i].row;
    if (this.#buffer?.rows !== rows || images.length !== this.#images.length || !images.every(same)) {
      const buffer = this.#device.createData(rows, 'textures');
      this.#buffer?.destroy();
      this.#buffer = buffer;
      for (const { pixels, row } of images) upload(buffer, row, pixels);
      this.#images = images;
    }
    this.#buffer.write(0, uses.u32);
  }

  /** Gives the memory back, and forgets the images. */
  release(): void {
    this.#buffer?.destroy();
    this.#buffer = null;
    this.#images = [];
  }

  /** Throws when it holds nothing yet. */
  get buffer(): DataBuffer {
    if (!this.#buffer) throw new Error('No textures have been given.');
    return this.#buffer;
  }
}

/** As they are in memory, if they begin at a word and fill whole rows; else through a copy, piece by piece. */
function upload(buffer: DataBuffer, row: number, { rgba }: ImagePixels): void {
  const whole =
    rgba.byteOffset % 4 === 0 && rgba.buffer instanceof ArrayBuffer
      ? rgba.byteLength - (rgba.byteLength % ROW_BYTES)
      : 0;
  if (whole > 0) buffer.write(row, new Uint32Array(rgba.buffer as ArrayBuffer, rgba.byteOffset, whole / 4));
  for (let at = whole; at < rgba.byteLength; at += PIECE) {
    const piece = rgba.subarray(at, at + PIECE);
    const copy = new Uint8Array(Math.ceil(piece.byteLength / ROW_BYTES) * ROW_BYTES);
    copy.set(piece);
    buffer.write(row + at / ROW_BYTES, new Uint32Array(copy.buffer));
  }
}
