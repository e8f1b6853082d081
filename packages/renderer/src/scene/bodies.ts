/**
 * The meshes of a scene where they are at a time, in arrays that are written again and again: a thousand of them that move cost no object
 * a frame. `posedSceneAt` gives the same as plain data that stays.
 */
import { AFFINE_LENGTH, IDENTITY, multiplyAffine, multiplyMatrices } from './affine.ts';
import { type CompiledAnimation, compileAnimation } from './animation.ts';
import { type Deformed, deform, isDeformable, jointMatrices, makeDeformed, type Pose } from './deform.ts';
import { compileTrack, evaluateTrack } from './keyframes.ts';
import type { Mesh } from './mesh.ts';
import { type NodeTransforms, nodeTransforms, playingClip } from './node-transforms.ts';
import type { Skin } from './nodes.ts';
import { meshShapes, placementOf } from './placed.ts';
import { isOfWeights, type PlacementTarget, placementTarget, withTracks } from './placement-target.ts';
import { clipTime, evaluateSampled, widthOf } from './sampled-track.ts';
import type { MeshShape, Scene } from './scene.ts';
import { SMALLEST_SCALE } from './well-formed.ts';

/** One shape that is a mesh. */
export interface Body {
  readonly name: string;
  readonly shape: MeshShape;
  /** In the form that the scene gives it. */
  readonly mesh: Mesh;
  /** Its first instance among all, and how many it has. */
  readonly first: number;
  readonly count: number;
  /** How joints and weights bend the mesh now; null: it keeps its form. Arrays are written again. */
  readonly pose: Pose | null;
  /** Grows when `pose` is another one. */
  readonly poseRevision: number;
  /** What the pose makes of the mesh, worked out when it is asked for; null: it keeps its form. */
  readonly form: Deformed | null;
}

/** Translation, turn about X, Y and Z in degrees, scale: the shape's own, where tracks move them. */
const PARTS = { translation: 0, rotation: 3, scale: 6 } as const;

class MovingBody implements Body {
  readonly pose: {
    weights: readonly number[] | undefined;
    readonly joints: Float32Array<ArrayBuffer> | undefined;
  } | null;
  poseRevision = 0;
  #form: Deformed | null = null;
  /** The pose that it was made of. */
  #formRevision = -1;
  /** Place of the node among all; −1: none. */
  readonly node: number;
  readonly own: Float64Array;
  /** Null unless tracks move the shape itself. */
  parts: Float64Array | null = null;
  readonly skin: Skin | null;
  readonly #lastJoints: Float32Array | undefined;
  readonly #local = new Float64Array(AFFINE_LENGTH);

  constructor(
    readonly name: string,
    readonly shape: MeshShape,
    readonly mesh: Mesh,
    readonly first: number,
    scene: Scene,
    transforms: NodeTransforms,
  ) {
    this.node = shape.node === undefined ? -1 : placeOf(transforms, shape.node);
    this.own = placementOf(shape);
    const skin = shape.skin === undefined ? undefined : scene.skins?.[shape.skin];
    this.skin = skin && mesh.skin ? skin : null;
    const bends = isDeformable(mesh) && (this.skin !== null || shape.node !== undefined);
    const joints = this.skin ? new Float32Array(this.skin.joints.length * AFFINE_LENGTH) : undefined;
    this.pose = bends ? { weights: undefined, joints } : null;
    this.#lastJoints = joints?.slice().fill(Number.NaN);
  }

  get form(): Deformed | null {
    if (!this.pose) return null;
    this.#form ??= makeDeformed(this.mesh);
    if (this.#formRevision !== this.poseRevision) deform(this.mesh, this.pose, this.#form);
    this.#formRevision = this.poseRevision;
    return this.#form;
  }

  get count(): number {
    return this.shape.instances ? this.shape.instances.length / AFFINE_LENGTH : 1;
  }

  /** Writes its matrices; `meshMatrices` without arrays of its own. */
  place(world: Float64Array, matrices: Float64Array): void {
    const { instances, skin } = this.shape;
    if (this.parts) composeParts(this.parts, this.shape.matrix, this.own, this.#local);
    for (let k = 0; k < this.count; k++) {
      const at = (this.first + k) * AFFINE_LENGTH;
      if (skin !== undefined) matrices.set(IDENTITY, at);
      else if (instances) {
        for (let i = 0; i < AFFINE_LENGTH; i++) this.#local[i] = instances[k * AFFINE_LENGTH + i]!;
        multiplyMatrices(matrices, at, this.#local, 0, this.own, 0);
      } else matrices.set(this.own, at);
      if (skin === undefined && this.node >= 0)
        multiplyMatrices(matrices, at, world, this.node * AFFINE_LENGTH, matrices, at);
    }
  }

  /** Writes its pose. */
  bend(world: Float64Array, transforms: NodeTransforms, weights: readonly number[] | undefined): void {
    const pose = this.pose!;
    const { joints } = pose;
    if (joints) jointMatrices(this.skin!, transforms, world, joints);
    if (this.poseRevision > 0 && equal(weights, pose.weights) && equal(joints, this.#lastJoints)) return;
    this.#lastJoints?.set(joints!);
    pose.weights = weights;
    this.poseRevision++;
  }
}

/** All meshes of one scene. */
export class Bodies {
  readonly all: readonly Body[];
  /** World matrices of all instances, 12 numbers each (`Affine`). */
  readonly matrices: Float64Array;
  readonly #transforms: NodeTransforms;
  readonly #world: Float64Array;
  readonly #movers: readonly MovingBody[];
  readonly #bent: readonly MovingBody[];
  readonly #channels: readonly ((time: number) => void)[];
  readonly #weights: CompiledAnimation;

  /** Throws a TypeError when a mesh has not been loaded. They are nowhere yet: see `goTo`. */
  constructor(scene: Scene) {
    const transforms = nodeTransforms(scene);
    let instances = 0;
    const all = meshShapes(scene).map(([name, shape]) => {
      const mesh = scene.meshes?.[shape.mesh]?.data;
      if (!mesh) throw new TypeError(`The mesh "${shape.mesh}" has not been loaded.`);
      const body = new MovingBody(name, shape, mesh, instances, scene, transforms);
      instances += body.count;
      return body;
    });
    this.all = all;
    this.matrices = new Float64Array(instances * AFFINE_LENGTH);
    this.#transforms = transforms;
    this.#world = transforms.at(0);
    this.#channels = channelsOf(scene, new Map(all.map((body) => [body.name, body])));
    this.#weights = compileAnimation(withTracks(scene, isOfWeights));
    const moving = new Set(transforms.moving);
    this.#movers = all.filter(({ node, parts, skin }) => skin === null && (parts !== null || moving.has(node)));
    this.#bent = all.filter(({ pose }) => pose !== null);
    for (const body of all) body.place(this.#world, this.matrices);
  }

  /** Writes where all are, and in which pose, at a time: seconds, finite. */
  goTo(time: number): void {
    const world = this.#transforms.at(time, this.#world);
    for (const channel of this.#channels) channel(time);
    for (const body of this.#movers) body.place(world, this.matrices);
    if (this.#bent.length === 0) return;
    const { nodes } = this.#weights(time);
    for (const body of this.#bent) {
      const { node } = body.shape;
      body.bend(world, this.#transforms, node === undefined ? undefined : nodes?.[node]?.weights);
    }
  }
}

function channelsOf(scene: Scene, bodies: ReadonlyMap<string, MovingBody>): ((time: number) => void)[] {
  const channels: ((time: number) => void)[] = [];
  const partsOf = (target: string): { target: PlacementTarget; parts: Float64Array } | null => {
    const found = placementTarget(scene, target);
    if (found?.section !== 'shapes') return null;
    const body = bodies.get(found.name)!;
    const { translation, rotation, scale } = body.shape;
    body.parts ??= Float64Array.of(...translation, ...rotation, ...scale);
    return { target: found, parts: body.parts };
  };
  for (const track of scene.animation) {
    const found = partsOf(track.target);
    if (!found) continue;
    const { parts } = found;
    const [at, width] = [PARTS[found.target.part] + (found.target.component ?? 0), found.target.component === null ? 3 : 1]; // biome-ignore format: a pair
    const compiled = compileTrack(track);
    const value = [0, 0, 0];
    channels.push((time) => {
      evaluateTrack(compiled, time, value);
      for (let i = 0; i < width; i++) parts[at + i] = value[i]!;
    });
  }
  const clip = playingClip(scene);
  for (const track of clip?.tracks ?? []) {
    const found = partsOf(track.target);
    if (!found) continue;
    const { parts } = found;
    const at = PARTS[found.target.part] + (found.target.component ?? 0);
    const width = widthOf(track);
    channels.push((time) => evaluateSampled(track, width, false, clipTime(clip!, time), parts, at));
  }
  return channels;
}

function placeOf({ indexOf }: NodeTransforms, name: string): number {
  const index = indexOf.get(name);
  if (index === undefined) throw new Error(`The scene has no node "${name}".`);
  return index;
}

function equal(a: ArrayLike<number> | undefined, b: ArrayLike<number> | undefined): boolean {
  if (a === b) return true;
  if (!a || !b || a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

const RADIANS = Math.PI / 180;
/** The scale itself, or at the instant when it goes through 0 the least that is none (`mendScale`). */
const mended = (s: number): number => (Math.abs(s) >= SMALLEST_SCALE ? s : s < 0 ? -SMALLEST_SCALE : SMALLEST_SCALE);

/** What `placementOf` gives for these parts. `local` is written over. */
function composeParts(
  parts: Float64Array,
  matrix: readonly number[] | undefined,
  out: Float64Array,
  local: Float64Array,
): void {
  const to = matrix ? local : out;
  const [cx, cy, cz] = [Math.cos(parts[3]! * RADIANS), Math.cos(parts[4]! * RADIANS), Math.cos(parts[5]! * RADIANS)];
  const [sx, sy, sz] = [Math.sin(parts[3]! * RADIANS), Math.sin(parts[4]! * RADIANS), Math.sin(parts[5]! * RADIANS)];
  const [x, y, z] = [mended(parts[6]!), mended(parts[7]!), mended(parts[8]!)];
  to[0] = cz * cy * x;
  to[1] = (cz * sy * sx - sz * cx) * y;
  to[2] = (cz * sy * cx + sz * sx) * z;
  to[3] = parts[0]!;
  to[4] = sz * cy * x;
  to[5] = (sz * sy * sx + cz * cx) * y;
  to[6] = (sz * sy * cx - cz * sx) * z;
  to[7] = parts[1]!;
  to[8] = -sy * x;
  to[9] = cy * sx * y;
  to[10] = cy * cx * z;
  to[11] = parts[2]!;
  if (matrix) multiplyAffine(out, 0, local, 0, matrix, 0);
}
