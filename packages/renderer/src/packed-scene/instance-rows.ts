/**
 * Where instances stand → their rows of the geometry and their boxes, both relative to the eye. What stands where it stood costs no more
 * than a look.
 */
import { AFFINE_LENGTH, isSolid } from '../scene/affine.ts';
import type { Vec3 } from '../scene/scene.ts';
import { fieldOffset, structSize } from './layout.ts';
import type { Block } from './write-struct.ts';

/** What instances of one mesh have in common. */
export interface InstancedMesh {
  /** Around the mesh in its own space: least x, y, z, greatest x, y, z. */
  readonly box: Float64Array;
  /** Whether that is another box than at the last call. */
  readonly boxChanged: boolean;
  /** Whether `shared` is other numbers. */
  readonly rowChanged: boolean;
  /** The other fields of its rows, in the order of `SHARED`. */
  readonly shared: Uint32Array;
}

const WORDS = structSize('Instance') / 4;
const ROWS = (['toMeshX', 'toMeshY', 'toMeshZ'] as const).map((field) => fieldOffset('Instance', field) / 4);
export const SHARED = ['nodes', 'triangles', 'row', 'cover', 'vertices', 'vertexRows', 'vertexFlags'] as const;
const SHARED_AT = SHARED.map((field) => fieldOffset('Instance', field) / 4);

export class InstanceRows {
  /** Instances that are there; those that have no thickness left, as a node scaled to nothing has, are not. */
  count = 0;
  /** Six floats an instance, eye-relative: least x, y, z, greatest x, y, z. */
  readonly boxes: Float32Array;
  /** The rows that are other ones since the last call, as instances: from the first on, up to but not including the other. */
  changedFrom = 0;
  changedTo = 0;
  readonly #moving: Block;
  readonly #firstWord: number;
  readonly #eye = new Float64Array(3).fill(Number.NaN);
  /** The matrix that each row was made of. */
  readonly #matrices: Float64Array;
  readonly #meshes: (InstancedMesh | null)[];

  /** Rows are written into `moving`, from a byte on. */
  constructor(moving: Block, firstByte: number, instances: number) {
    this.#moving = moving;
    this.#firstWord = firstByte / 4;
    this.boxes = new Float32Array(6 * instances);
    this.#matrices = new Float64Array(AFFINE_LENGTH * instances);
    this.#meshes = new Array<InstancedMesh | null>(instances).fill(null);
  }

  /**
   * One matrix after the other, 12 numbers each; `meshOf` has the mesh of each. Returns what is new: nothing, where the eye is, or where
   * instances are.
   */
  update(matrices: Float64Array, meshOf: readonly InstancedMesh[], eye: Vec3): 'nothing' | 'eye' | 'instances' {
    const eyeMoved = this.#moveEye(eye);
    const before = this.count;
    let moved = false;
    let slot = 0;
    this.changedFrom = meshOf.length;
    this.changedTo = 0;
    for (let i = 0; i < meshOf.length; i++) {
      const at = i * AFFINE_LENGTH;
      const mesh = meshOf[i]!;
      const stays = this.#meshes[slot] === mesh && equalAt(matrices, at, this.#matrices, slot * AFFINE_LENGTH);
      // What a slot has been made of is solid.
      if (!stays && !isSolid(matrices, at)) continue;
      if (!stays) {
        this.#meshes[slot] = mesh;
        for (let k = 0; k < AFFINE_LENGTH; k++) this.#matrices[slot * AFFINE_LENGTH + k] = matrices[at + k]!;
      }
      if (!stays || mesh.boxChanged) moved = true;
      if (!stays || eyeMoved || mesh.rowChanged) {
        if (slot < this.changedFrom) this.changedFrom = slot;
        this.changedTo = slot + 1;
        this.#write(slot, matrices, at, mesh);
      } else if (mesh.boxChanged) this.#write(slot, matrices, at, mesh);
      slot++;
    }
    this.count = slot;
    if (moved || slot !== before) return 'instances';
    return eyeMoved ? 'eye' : 'nothing';
  }

  #moveEye(eye: Vec3): boolean {
    const last = this.#eye;
    const moved = last[0] !== eye[0] || last[1] !== eye[1] || last[2] !== eye[2];
    last.set(eye);
    return moved;
  }

  /** The way from eye-relative places into the mesh, found in double precision; and the box around the placed box. */
  #write(slot: number, m: Float64Array, at: number, { box, shared }: InstancedMesh): void {
    const { f32, u32 } = this.#moving;
    const a = m[at]!;
    const b = m[at + 1]!;
    const c = m[at + 2]!;
    const d = m[at + 4]!;
    const e = m[at + 5]!;
    const f = m[at + 6]!;
    const g = m[at + 8]!;
    const h = m[at + 9]!;
    const i = m[at + 10]!;
    const x = m[at + 3]! - this.#eye[0]!;
    const y = m[at + 7]! - this.#eye[1]!;
    const z = m[at + 11]! - this.#eye[2]!;
    const reciprocal = 1 / (a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g));
    const to = this.#firstWord + slot * WORDS;
    writeRow(f32, to + ROWS[0]!, (e * i - f * h) * reciprocal, (c * h - b * i) * reciprocal, (b * f - c * e) * reciprocal, x, y, z); // biome-ignore format: a matrix
    writeRow(f32, to + ROWS[1]!, (f * g - d * i) * reciprocal, (a * i - c * g) * reciprocal, (c * d - a * f) * reciprocal, x, y, z); // biome-ignore format: a matrix
    writeRow(f32, to + ROWS[2]!, (d * h - e * g) * reciprocal, (b * g - a * h) * reciprocal, (a * e - b * d) * reciprocal, x, y, z); // biome-ignore format: a matrix
    for (let k = 0; k < SHARED_AT.length; k++) u32[to + SHARED_AT[k]!] = shared[k]!;
    writeExtent(this.boxes, 6 * slot, box, a, b, c, x);
    writeExtent(this.boxes, 6 * slot + 1, box, d, e, f, y);
    writeExtent(this.boxes, 6 * slot + 2, box, g, h, i, z);
  }
}

function writeRow(
  f32: Float32Array,
  at: number,
  a: number,
  b: number,
  c: number,
  x: number,
  y: number,
  z: number,
): void {
  f32[at] = a;
  f32[at + 1] = b;
  f32[at + 2] = c;
  f32[at + 3] = -(a * x + b * y + c * z);
}

/** Along one axis, the placed box's middle ± half its size: J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems (1990). */
function writeExtent(
  boxes: Float32Array,
  at: number,
  box: Float64Array,
  a: number,
  b: number,
  c: number,
  offset: number,
): void {
  const middle = (a * (box[0]! + box[3]!) + b * (box[1]! + box[4]!) + c * (box[2]! + box[5]!)) / 2 + offset;
  const half = (Math.abs(a) * (box[3]! - box[0]!) + Math.abs(b) * (box[4]! - box[1]!) + Math.abs(c) * (box[5]! - box[2]!)) / 2; // biome-ignore format: a sum
  boxes[at] = middle - half;
  boxes[at + 3] = middle + half;
}

function equalAt(a: Float64Array, i: number, b: Float64Array, k: number): boolean {
  for (let n = 0; n < AFFINE_LENGTH; n++) if (a[i + n] !== b[k + n]) return false;
  return true;
}
