/** The sky's map on a device: uploaded when another one is to be seen, and not before. */
import { type Device, DeviceError, type TableTexture } from './gpu/device.ts';
import type { PackedEnvironment } from './packed-scene/pack-environment.ts';

export class EnvironmentTexture {
  readonly #device: Device;
  #texture: TableTexture | null = null;
  #held: PackedEnvironment | null = null;

  constructor(device: Device) {
    this.#device = device;
  }

  /** Throws a `DeviceError`, and keeps what it holds, when the device has no textures of that size. */
  hold(packed: PackedEnvironment): void {
    if (packed === this.#held) return;
    const { width, height, rows, texels } = packed;
    const { maxTextureSize } = this.#device;
    if (Math.max(width, rows) > maxTextureSize)
      throw new DeviceError(
        `The sky's map of ${width} × ${height} texels needs a texture of ${width} × ${rows}; this device has at most ${maxTextureSize} along a side.`,
        { limit: 'maxTextureSize', available: maxTextureSize, needed: Math.max(width, rows) },
      );
    this.#texture?.destroy();
    this.#texture = this.#device.createTable(width, rows);
    this.#texture.write(texels, rows);
    this.#held = packed;
  }

  /** Gives the memory back, and forgets the map. */
  release(): void {
    this.#texture?.destroy();
    this.#texture = null;
    this.#held = null;
  }

  /** Throws when it holds nothing yet. */
  get texture(): TableTexture {
    if (!this.#texture) throw new Error('No map of the sky has been given.');
    return this.#texture;
  }
}
