/**
 * Meshes that change their form: morph targets are added, then joints move what hangs on them (glTF 2.0, 3.7.2.2 and 3.7.3.3). Plain
 * loops over typed arrays; who has a GPU may do the same there.
 */
import { AFFINE_LENGTH, cofactors, determinant, type Numbers } from './affine.ts';
import type { Mesh, MorphTarget, SkinWeights } from './mesh.ts';
import type { NodeTransforms } from './node-transforms.ts';
import type { Skin } from './nodes.ts';
import type { Scene } from './scene.ts';

/** What of a mesh changes; the rest stays as it is. Arrays are there where the mesh has them. */
export interface Deformed {
  readonly positions: Float32Array;
  readonly normals?: Float32Array;
  readonly tangents?: Float32Array;
}

/** How a mesh is bent. */
export interface Pose {
  /** Of its morph targets; missing ones are 0. */
  readonly weights?: readonly number[] | undefined;
  /** 12 numbers a joint, as `jointMatrices` gives them; for a mesh with skin weights. */
  readonly joints?: Float32Array | undefined;
}

export const isDeformable = ({ skin, morphTargets }: Mesh): boolean =>
  skin !== undefined || (morphTargets?.length ?? 0) > 0;

/** Whether the scene has meshes that joints or weights may bend. */
export const hasDeformables = ({ meshes = {} }: Pick<Scene, 'meshes'>): boolean =>
  Object.values(meshes).some(({ data }) => data !== undefined && isDeformable(data));

/** Arrays to write a mesh's form into, again and again. */
export const makeDeformed = ({ positions, normals, tangents }: Mesh): Deformed => ({
  positions: new Float32Array(positions.length),
  ...(normals && { normals: new Float32Array(normals.length) }),
  ...(tangents && { tangents: new Float32Array(tangents.length) }),
});

/** Of skins: the numbers of their joints among some nodes. */
const known = new WeakMap<Skin, { readonly transforms: NodeTransforms; readonly nodes: Uint32Array }>();

function nodesOfJoints(skin: Skin, transforms: NodeTransforms): Uint32Array {
  const before = known.get(skin);
  if (before?.transforms === transforms) return before.nodes;
  const nodes = Uint32Array.from(skin.joints, (name) => {
    const node = transforms.indexOf.get(name);
    if (node === undefined) throw new Error(`The scene has no node "${name}", which a skin names.`);
    return node;
  });
  known.set(skin, { transforms, nodes });
  return nodes;
}

/**
 * What each joint does to a vertex, 12 numbers a joint: from the mesh's space to the world's, into `out` or a new array. `world` has the
 * matrices of all nodes, `transforms.at(time)`.
 */
export function jointMatrices(
  skin: Skin,
  transforms: NodeTransforms,
  world: Float64Array,
  out = new Float32Array(skin.joints.length * AFFINE_LENGTH),
): Float32Array {
  const { inverseBindMatrices } = skin;
  const nodes = nodesOfJoints(skin, transforms);
  for (let joint = 0; joint < nodes.length; joint++) {
    const at = joint * AFFINE_LENGTH;
    const from = nodes[joint]! * AFFINE_LENGTH;
    if (inverseBindMatrices) multiplyInto(out, at, world, from, inverseBindMatrices, at);
    else for (let i = 0; i < AFFINE_LENGTH; i++) out[at + i] = world[from + i]!;
  }
  return out;
}

/** `multiplyAffine` of these kinds of arrays alone, for what frames call. */
function multiplyInto(out: Float32Array, at: number, a: Float64Array, ai: number, b: Float32Array, bi: number): void {
  for (let column = 0; column < 4; column++) {
    const x = b[bi + column]!;
    const y = b[bi + 4 + column]!;
    const z = b[bi + 8 + column]!;
    const w = column === 3 ? 1 : 0;
    out[at + column] = a[ai]! * x + a[ai + 1]! * y + a[ai + 2]! * z + a[ai + 3]! * w;
    out[at + 4 + column] = a[ai + 4]! * x + a[ai + 5]! * y + a[ai + 6]! * z + a[ai + 7]! * w;
    out[at + 8 + column] = a[ai + 8]! * x + a[ai + 9]! * y + a[ai + 10]! * z + a[ai + 11]! * w;
  }
}

/** Writes the mesh's form in this pose into `out`, which `makeDeformed` has made. Normals and tangents keep length 1. */
export function deform(mesh: Mesh, { weights = [], joints }: Pose, out: Deformed): void {
  morph(mesh, weights, out);
  if (mesh.skin && joints) {
    const uniform = keepsAngles(joints);
    if (uniform || !out.normals) bend(mesh.skin, joints, out);
    else bendUnevenly(mesh.skin, joints, out);
  } else normalizeAll(mesh, weights, out);
}

function morph(
  { positions, normals, tangents, morphTargets = [] }: Mesh,
  weights: readonly number[],
  out: Deformed,
): void {
  out.positions.set(positions);
  if (normals) out.normals?.set(normals);
  if (tangents) out.tangents?.set(tangents);
  morphTargets.forEach((target, i) => {
    const weight = weights[i] ?? 0;
    if (weight === 0) return;
    addTo(out.positions, target.positions, weight);
    if (out.normals) addTo(out.normals, target.normals, weight);
    if (out.tangents) addToTangents(out.tangents, target, weight);
  });
}

function addTo(sum: Float32Array, deltas: Float32Array | undefined, weight: number): void {
  if (!deltas) return;
  for (let i = 0; i < deltas.length; i++) sum[i] = sum[i]! + weight * deltas[i]!;
}

/** Tangents have four numbers a vertex, their deltas three: the handedness stays. */
function addToTangents(sum: Float32Array, { tangents }: MorphTarget, weight: number): void {
  if (!tangents) return;
  for (let from = 0, at = 0; from < tangents.length; from += 3, at += 4) {
    sum[at] = sum[at]! + weight * tangents[from]!;
    sum[at + 1] = sum[at + 1]! + weight * tangents[from + 1]!;
    sum[at + 2] = sum[at + 2]! + weight * tangents[from + 2]!;
  }
}

/** After morphing alone. */
function normalizeAll({ morphTargets = [] }: Mesh, weights: readonly number[], { normals, tangents }: Deformed): void {
  const changed = (key: 'normals' | 'tangents') =>
    morphTargets.some((target, i) => target[key] && (weights[i] ?? 0) !== 0);
  if (normals && changed('normals')) normalizeEach(normals, 3);
  if (tangents && changed('tangents')) normalizeEach(tangents, 4);
}

function normalizeEach(vectors: Float32Array, stride: number): void {
  for (let at = 0; at < vectors.length; at += stride) {
    const x = vectors[at]!;
    const y = vectors[at + 1]!;
    const z = vectors[at + 2]!;
    const square = x * x + y * y + z * z;
    if (!(square > 0)) continue;
    const f = 1 / Math.sqrt(square);
    vectors[at] = x * f;
    vectors[at + 1] = y * f;
    vectors[at + 2] = z * f;
  }
}

/** Whether all joints turn and scale evenly, without mirror images, so that normals go the way of directions. */
export function keepsAngles(joints: Float32Array): boolean {
  for (let at = 0; at < joints.length; at += AFFINE_LENGTH) if (!isEven(joints, at)) return false;
  return true;
}

/** For a turn times s the cofactors are the matrix times s. */
function isEven(m: Float32Array, at: number): boolean {
  const a = m[at]!;
  const b = m[at + 1]!;
  const c = m[at + 2]!;
  const d = m[at + 4]!;
  const e = m[at + 5]!;
  const f = m[at + 6]!;
  const g = m[at + 8]!;
  const h = m[at + 9]!;
  const i = m[at + 10]!;
  const s = Math.sqrt(a * a + d * d + g * g);
  const most = 1e-3 * s * s;
  return (
    Math.abs(e * i - f * h - s * a) <= most &&
    Math.abs(f * g - d * i - s * b) <= most &&
    Math.abs(d * h - e * g - s * c) <= most &&
    Math.abs(c * h - b * i - s * d) <= most &&
    Math.abs(a * i - c * g - s * e) <= most &&
    Math.abs(b * g - a * h - s * f) <= most &&
    Math.abs(b * f - c * e - s * g) <= most &&
    Math.abs(c * d - a * f - s * h) <= most &&
    Math.abs(a * e - b * d - s * i) <= most
  );
}

/** Moves everything with the mix of the joints' matrices. */
function bend({ joints, weights }: SkinWeights, from: Float32Array, out: Deformed): void {
  const matrices = new Float64Array(from); // once, or each of their many uses would convert
  const { positions, normals, tangents } = out;
  const vertices = positions.length / 3;
  const perVertex = joints.length / vertices;
  for (let vertex = 0, p = 0, k = 0; vertex < vertices; vertex++, p += 3, k += perVertex) {
    const w0 = weights[k]!;
    let j = joints[k]! * 12;
    let m0 = w0 * matrices[j]!;
    let m1 = w0 * matrices[j + 1]!;
    let m2 = w0 * matrices[j + 2]!;
    let m3 = w0 * matrices[j + 3]!;
    let m4 = w0 * matrices[j + 4]!;
    let m5 = w0 * matrices[j + 5]!;
    let m6 = w0 * matrices[j + 6]!;
    let m7 = w0 * matrices[j + 7]!;
    let m8 = w0 * matrices[j + 8]!;
    let m9 = w0 * matrices[j + 9]!;
    let m10 = w0 * matrices[j + 10]!;
    let m11 = w0 * matrices[j + 11]!;
    for (let i = k + 1; i < k + perVertex; i++) {
      const w = weights[i]!;
      if (w === 0) continue;
      j = joints[i]! * 12;
      m0 += w * matrices[j]!;
      m1 += w * matrices[j + 1]!;
      m2 += w * matrices[j + 2]!;
      m3 += w * matrices[j + 3]!;
      m4 += w * matrices[j + 4]!;
      m5 += w * matrices[j + 5]!;
      m6 += w * matrices[j + 6]!;
      m7 += w * matrices[j + 7]!;
      m8 += w * matrices[j + 8]!;
      m9 += w * matrices[j + 9]!;
      m10 += w * matrices[j + 10]!;
      m11 += w * matrices[j + 11]!;
    }
    const x = positions[p]!;
    const y = positions[p + 1]!;
    const z = positions[p + 2]!;
    positions[p] = m0 * x + m1 * y + m2 * z + m3;
    positions[p + 1] = m4 * x + m5 * y + m6 * z + m7;
    positions[p + 2] = m8 * x + m9 * y + m10 * z + m11;
    if (normals !== undefined) {
      const nx = normals[p]!;
      const ny = normals[p + 1]!;
      const nz = normals[p + 2]!;
      const a = m0 * nx + m1 * ny + m2 * nz;
      const b = m4 * nx + m5 * ny + m6 * nz;
      const c = m8 * nx + m9 * ny + m10 * nz;
      const f = 1 / Math.sqrt(a * a + b * b + c * c || 1);
      normals[p] = a * f;
      normals[p + 1] = b * f;
      normals[p + 2] = c * f;
    }
    if (tangents !== undefined) {
      const t = p + vertex;
      const tx = tangents[t]!;
      const ty = tangents[t + 1]!;
      const tz = tangents[t + 2]!;
      const a = m0 * tx + m1 * ty + m2 * tz;
      const b = m4 * tx + m5 * ty + m6 * tz;
      const c = m8 * tx + m9 * ty + m10 * tz;
      const f = 1 / Math.sqrt(a * a + b * b + c * c || 1);
      tangents[t] = a * f;
      tangents[t + 1] = b * f;
      tangents[t + 2] = c * f;
    }
  }
}

/** The same where a joint stretches or mirrors: normals go by the cofactors of the mix. Rare, so it is written for clarity. */
function bendUnevenly(skin: SkinWeights, matrices: Float32Array, out: Deformed): void {
  const normals = out.normals!;
  const before = normals.slice();
  const vertices = out.positions.length / 3;
  const perVertex = skin.joints.length / vertices;
  const mix = new Float64Array(AFFINE_LENGTH);
  for (let vertex = 0; vertex < vertices; vertex++) {
    mix.fill(0);
    for (let k = vertex * perVertex; k < (vertex + 1) * perVertex; k++)
      for (let i = 0; i < AFFINE_LENGTH; i++)
        mix[i] = mix[i]! + skin.weights[k]! * matrices[skin.joints[k]! * AFFINE_LENGTH + i]!;
    // An outward normal stays outward, mirrored or not.
    transformNormal(cofactors(mix, 0), determinant(mix) < 0 ? -1 : 1, before, normals, 3 * vertex);
  }
  const bent = normals.slice();
  bend(skin, matrices, out);
  normals.set(bent);
}

function transformNormal(c: Numbers, sign: number, from: Float32Array, to: Float32Array, at: number): void {
  const [x, y, z] = [from[at]!, from[at + 1]!, from[at + 2]!];
  const n = [0, 3, 6].map((row) => c[row]! * x + c[row + 1]! * y + c[row + 2]! * z);
  const length = Math.hypot(...n) || 1;
  for (let i = 0; i < 3; i++) to[at + i] = (sign * n[i]!) / length;
}
