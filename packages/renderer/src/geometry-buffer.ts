/** The geometry of one scene on a device: meshes are uploaded when others are to be seen, instances whenever they move. */
import type { DataBuffer, Device } from './gpu/device.ts';
import { GEOMETRY_ROW } from './packed-scene/layout.ts';
import type { PackedGeometry } from './packed-scene/pack-geometry.ts';
import { wordsOf } from './packed-scene/packed-mesh.ts';

export class GeometryBuffer {
  readonly #device: Device;
  #buffer: DataBuffer | null = null;
  #parts: readonly Uint32Array<ArrayBuffer>[] = [];
  #movingRows = -1;

  constructor(device: Device) {
    this.#device = device;
  }

  /** Throws a `DeviceError`, and keeps what it holds, when the device has no room. */
  hold({ moving, movingRows, meshes, tables, rows }: PackedGeometry): void {
    const parts = [...meshes.flatMap(wordsOf), ...tables.map(({ words }) => words)];
    const same = movingRows === this.#movingRows && parts.length === this.#parts.length;
    if (!same || parts.some((part, i) => part !== this.#parts[i])) {
      const buffer = this.#device.createData(rows, 'meshes');
      this.#buffer?.destroy();
      this.#buffer = buffer;
      this.#upload(buffer, movingRows, parts);
    }
    this.#buffer!.write(0, moving.u32);
  }

  #upload(buffer: DataBuffer, movingRows: number, parts: readonly Uint32Array<ArrayBuffer>[]): void {
    let row = movingRows;
    for (const words of parts) {
      buffer.write(row, words);
      row += words.length / GEOMETRY_ROW;
    }
    this.#movingRows = movingRows;
    this.#parts = parts;
  }

  /** Throws when it holds nothing yet. */
  get buffer(): DataBuffer {
    if (!this.#buffer) throw new Error('No geometry has been given.');
    return this.#buffer;
  }
}
