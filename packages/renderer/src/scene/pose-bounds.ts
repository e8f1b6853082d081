/**
 * A box around a bent mesh that does not look at its vertices: a tree over instances needs one in each frame, and who bends meshes
 * elsewhere does not want to read them back. Morph targets add Σ w · delta, which lies in the sum of the boxes of their deltas, each times
 * its weight. A vertex that hangs on joints lies in the hull of the places where each of them alone would take it, as weights are not
 * negative, times their sum, which is nearly 1. So each joint carries the box of the vertices that hang on it.
 */
import { AFFINE_LENGTH } from './affine.ts';
import type { Pose } from './deform.ts';
import type { Mesh, SkinWeights } from './mesh.ts';

/** Half a unit in the last place of a float of 32 bits, relative: what each operation may be off by. */
const ROUNDING = 2 ** -24;
/**
 * Operations that a place goes through, each on no more than the sum of all magnitudes: the mix of eight matrices (a product and a sum
 * each), four products and their sum, and three for each target. This many are twice as many.
 */
const OPERATIONS = 48;
const OF_TARGET = 6;
/** Six numbers: least x, y, z, greatest x, y, z. */
const BOX = 6;

/** Of one mesh; `write` gives the box of any pose. */
export class PoseBounds {
  /** Around the vertices of each joint, one after the other; of a mesh without joints there is one around all. */
  readonly #boxes: Float64Array;
  /** The joint of each box. */
  readonly #joints: Uint16Array | null = null;
  /** Least and greatest sum of a vertex's weights. */
  readonly #sums: readonly [least: number, greatest: number] = [1, 1];
  /** Around the deltas of each target. */
  readonly #deltas: Float64Array;
  /** Of this pose: the box of what targets add, and behind it the sum of its magnitudes along each axis. */
  readonly #change = new Float64Array(BOX + 3);

  /** `skinned`: whether joints move it. */
  constructor({ positions, skin, morphTargets = [] }: Mesh, skinned: boolean) {
    this.#deltas = new Float64Array(BOX * morphTargets.length);
    morphTargets.forEach((target, i) => {
      if (!target.positions) return;
      startBox(this.#deltas, BOX * i);
      for (let p = 0; p < target.positions.length; p += 3) addPoint(this.#deltas, BOX * i, target.positions, p);
    });
    if (skin && skinned) {
      const { boxes, joints } = boxesOfJoints(positions, skin);
      this.#boxes = boxes;
      this.#joints = joints;
      this.#sums = sumsOfWeights(skin, positions.length / 3);
      return;
    }
    this.#boxes = new Float64Array(BOX);
    startBox(this.#boxes, 0);
    for (let p = 0; p < positions.length; p += 3) addPoint(this.#boxes, 0, positions, p);
  }

  /** Around all places that vertices may have in this pose, also if they were worked out in 32 bits. */
  write({ weights = [], joints }: Pose, out: Float64Array): void {
    const change = this.#change.fill(0);
    const targets = this.#deltas.length / BOX;
    for (let i = 0; i < targets; i++) addScaled(change, this.#deltas, BOX * i, weights[i] ?? 0);
    const rounding = ROUNDING * (OPERATIONS + OF_TARGET * targets);
    startBox(out, 0);
    if (this.#joints === null || !joints) place(this.#boxes, 0, change, null, 0, rounding, out);
    else
      for (let k = 0; k < this.#joints.length; k++)
        place(this.#boxes, BOX * k, change, joints, AFFINE_LENGTH * this.#joints[k]!, rounding, out);
    this.#scale(out);
  }

  /** By the sums of weights; a mesh that hangs on nothing is at the origin. */
  #scale(out: Float64Array): void {
    const [least, greatest] = this.#sums;
    for (let axis = 0; axis < 3; axis++) {
      const low = out[axis]! <= out[axis + 3]! ? out[axis]! : 0;
      const high = out[axis]! <= out[axis + 3]! ? out[axis + 3]! : 0;
      out[axis] = Math.min(low * least, low * greatest);
      out[axis + 3] = Math.max(high * least, high * greatest);
    }
  }
}

function startBox(boxes: Float64Array, at: number): void {
  boxes.fill(Number.POSITIVE_INFINITY, at, at + 3);
  boxes.fill(Number.NEGATIVE_INFINITY, at + 3, at + BOX);
}

function addPoint(boxes: Float64Array, at: number, points: Float32Array, p: number): void {
  for (let axis = 0; axis < 3; axis++) {
    const x = points[p + axis]!;
    if (x < boxes[at + axis]!) boxes[at + axis] = x;
    if (x > boxes[at + axis + 3]!) boxes[at + axis + 3] = x;
  }
}

/** Boxes around the vertices that hang on a joint, of those that any hangs on. */
function boxesOfJoints(positions: Float32Array, { joints, weights }: SkinWeights) {
  const count = joints.reduce((most, joint) => Math.max(most, joint + 1), 0);
  const all = new Float64Array(BOX * count);
  for (let joint = 0; joint < count; joint++) startBox(all, BOX * joint);
  const perVertex = (3 * joints.length) / positions.length;
  for (let k = 0; k < joints.length; k++)
    if (weights[k]! > 0) addPoint(all, BOX * joints[k]!, positions, 3 * Math.floor(k / perVertex));
  const used = Uint16Array.from({ length: count }, (_, joint) => joint).filter((joint) => all[BOX * joint]! <= all[BOX * joint + 3]!); // biome-ignore format: one thought
  const boxes = new Float64Array(BOX * used.length);
  used.forEach((joint, k) => {
    boxes.set(all.subarray(BOX * joint, BOX * joint + BOX), BOX * k);
  });
  return { boxes, joints: used };
}

function sumsOfWeights({ weights }: SkinWeights, vertices: number): [number, number] {
  const perVertex = weights.length / vertices;
  let [least, greatest] = [1, 1];
  for (let k = 0; k < weights.length; k += perVertex) {
    let sum = 0;
    for (let i = k; i < k + perVertex; i++) sum += weights[i]!;
    least = Math.min(least, sum);
    greatest = Math.max(greatest, sum);
  }
  return [least, greatest];
}

/** sum += weight · box, where a negative weight turns it round; and the magnitudes. */
function addScaled(sum: Float64Array, boxes: Float64Array, at: number, weight: number): void {
  if (weight === 0) return;
  for (let axis = 0; axis < 3; axis++) {
    const a = weight * boxes[at + axis]!;
    const b = weight * boxes[at + axis + 3]!;
    sum[axis] = sum[axis]! + (a < b ? a : b);
    sum[axis + 3] = sum[axis + 3]! + (a < b ? b : a);
    sum[axis + BOX] = sum[axis + BOX]! + Math.max(Math.abs(a), Math.abs(b));
  }
}

/**
 * Grows `out` by a box plus `change`, carried by a matrix, and by what rounding may add: a share of the sum of all magnitudes. The box of the
 * placed box: J. Arvo, "Transforming Axis-Aligned Bounding Boxes", Graphics Gems (1990).
 */
function place(
  boxes: Float64Array,
  at: number,
  change: Float64Array,
  matrices: Float32Array | null,
  m: number,
  rounding: number,
  out: Float64Array,
): void {
  for (let row = 0; row < 3; row++) {
    let middle = matrices ? matrices[m + 4 * row + 3]! : 0;
    let size = Math.abs(middle);
    let half = 0;
    for (let axis = 0; axis < 3; axis++) {
      const factor = matrices ? matrices[m + 4 * row + axis]! : axis === row ? 1 : 0;
      const low = boxes[at + axis]!;
      const high = boxes[at + axis + 3]!;
      middle += (factor * (low + high + change[axis]! + change[axis + 3]!)) / 2;
      half += (Math.abs(factor) * (high - low + change[axis + 3]! - change[axis]!)) / 2;
      size += Math.abs(factor) * (Math.max(-low, high) + change[axis + BOX]!);
    }
    half += rounding * size;
    if (middle - half < out[row]!) out[row] = middle - half;
    if (middle + half > out[row + 3]!) out[row + 3] = middle + half;
  }
}
