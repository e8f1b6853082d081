/** The geometry of one scene on a device: meshes are uploaded when others are to be seen, instances whenever they move. */
import type { DataBuffer, Device } from './gpu/device.ts';
import { GEOMETRY_ROW } from './packed-scene/layout.ts';
import type { PackedGeometry } from './packed-scene/pack-geometry.ts';
import { type PackedMesh, wordsOf } from './packed-scene/packed-mesh.ts';

export class GeometryBuffer {
  readonly #device: Device;
  #buffer: DataBuffer | null = null;
  #meshes: readonly PackedMesh[] = [];
  #movingRows = -1;

  constructor(device: Device) {
    this.#device = device;
  }

  /** Throws a `DeviceError`, and keeps what it holds, when the device has no room. */
  hold({ moving, movingRows, meshes, rows }: PackedGeometry): void {
    const same = movingRows === this.#movingRows && meshes.length === this.#meshes.length;
    if (!same || meshes.some((mesh, i) => mesh !== this.#meshes[i])) {
      const buffer = this.#device.createData(rows, 'meshes');
      this.#buffer?.destroy();
      this.#buffer = buffer;
      this.#upload(buffer, movingRows, meshes);
    }
    this.#buffer!.write(0, moving.u32);
  }

  #upload(buffer: DataBuffer, movingRows: number, meshes: readonly PackedMesh[]): void {
    let row = movingRows;
    for (const mesh of meshes)
      for (const words of wordsOf(mesh)) {
        buffer.write(row, words);
        row += words.length / GEOMETRY_ROW;
      }
    this.#movingRows = movingRows;
    this.#meshes = meshes;
  }

  /** Throws when it holds nothing yet. */
  get buffer(): DataBuffer {
    if (!this.#buffer) throw new Error('No geometry has been given.');
    return this.#buffer;
  }
}
