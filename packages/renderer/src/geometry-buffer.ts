/** The geometry of one scene on a device: all of it is uploaded when other meshes are to be seen, else what has changed. */
import type { DataBuffer, Device } from './gpu/device.ts';
import { GEOMETRY_ROW } from './packed-scene/layout.ts';
import type { PackedGeometry } from './packed-scene/pack-geometry.ts';
import type { LampTable } from './packed-scene/pack-lamps.ts';
import { type PackedMesh, wordsOf } from './packed-scene/packed-mesh.ts';

/** A mesh that the buffer holds, as it was when it was uploaded. */
interface HeldMesh {
  readonly mesh: PackedMesh;
  revision: number;
}

/** So many rows are written at once sooner than in two pieces. */
const FEW_ROWS = 1024;

const equal = <T>(a: readonly T[], b: readonly T[]): boolean => a.length === b.length && a.every((x, i) => x === b[i]);

export class GeometryBuffer {
  readonly #device: Device;
  #buffer: DataBuffer | null = null;
  #meshes: readonly HeldMesh[] = [];
  #tables: readonly LampTable[] = [];
  #movingRows = -1;
  /** What the rows that move were made of. */
  #moving: { readonly geometry: PackedGeometry; readonly revision: number } | null = null;

  constructor(device: Device) {
    this.#device = device;
  }

  /**
   * Throws a `DeviceError`, and keeps what it holds, when the device has no room. Returns whether all meshes have been written anew, also
   * those that keep their forms here.
   */
  hold(geometry: PackedGeometry): boolean {
    const { movingRows, meshes, tables, rows } = geometry;
    const held = this.#meshes.map(({ mesh }) => mesh);
    const others = movingRows !== this.#movingRows || !equal(meshes, held) || !equal(tables, this.#tables);
    if (others) {
      if (this.#buffer?.rows !== rows) {
        const buffer = this.#device.createData(rows, 'meshes');
        this.#buffer?.destroy();
        this.#buffer = buffer;
      }
      this.#meshes = meshes.map((mesh) => ({ mesh, revision: -1 }));
      this.#movingRows = movingRows;
      this.#moving = null;
      this.#tables = tables;
      this.#writeTables(geometry.lampTables);
    }
    this.#writeMeshes();
    this.#writeMoving(geometry);
    return others;
  }

  #writeTables(first: number): void {
    let row = first;
    for (const { words } of this.#tables) {
      this.#buffer!.write(row, words);
      row += words.length / GEOMETRY_ROW;
    }
  }

  #writeMeshes(): void {
    let row = this.#movingRows;
    for (const held of this.#meshes) {
      const { revision } = held.mesh;
      for (const words of wordsOf(held.mesh)) {
        if (held.revision !== revision) this.#buffer!.write(row, words);
        row += words.length / GEOMETRY_ROW;
      }
      held.revision = revision;
    }
  }

  #writeMoving(geometry: PackedGeometry): void {
    const { moving, revision, treeRows, instances, instanceCount, movingRows, changedInstances } = geometry;
    const held = this.#moving?.geometry === geometry ? this.#moving.revision : -1;
    if (held === revision) return;
    const write = (begin: number, end: number) => {
      if (end > begin) this.#buffer!.write(begin, moving.u32.subarray(begin * GEOMETRY_ROW, end * GEOMETRY_ROW));
    };
    if (movingRows <= FEW_ROWS) write(0, movingRows);
    else {
      write(0, treeRows);
      if (held === revision - 1) write(...changedInstances);
      else if (instanceCount > 0) write(instances, movingRows);
    }
    this.#moving = { geometry, revision };
  }

  /** Gives the memory back, and forgets the meshes. */
  release(): void {
    this.#buffer?.destroy();
    this.#buffer = null;
    this.#meshes = [];
    this.#movingRows = -1;
    this.#moving = null;
  }

  /** Throws when it holds nothing yet. */
  get buffer(): DataBuffer {
    if (!this.#buffer) throw new Error('No geometry has been given.');
    return this.#buffer;
  }
}
