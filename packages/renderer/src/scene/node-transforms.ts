/** Where the nodes of a scene are at any time. */
import { AFFINE_LENGTH, composeAffine, copyAffine, IDENTITY, multiplyMatrices } from './affine.ts';
import { compileTrack, evaluateTrack } from './keyframes.ts';
import { type Clip, inOrder, type NodeFault, type SceneNode } from './nodes.ts';
import { parsePointer } from './pointer.ts';
import { clipTime, evaluateSampled, isRotation, widthOf } from './sampled-track.ts';
import type { Scene } from './scene.ts';

/** The nodes of one scene made ready. */
export interface NodeTransforms {
  /** Each after the node that carries it. */
  readonly names: readonly string[];
  /** Places in `names`. */
  readonly indexOf: ReadonlyMap<string, number>;
  /** Numbers of the nodes that move, rising; the others stay where they are at every time. */
  readonly moving: Uint32Array;
  /** The world matrices at a time, seconds, 12 numbers a node (`Affine`) in the order of `names`, into `out` or a new array. */
  at(time: number, out?: Float64Array): Float64Array;
}

type SceneOfNodes = Pick<Scene, 'nodes' | 'clips' | 'clip' | 'animation'>;

const prepared = new WeakMap<SceneOfNodes, NodeTransforms>();

/** As pure as `sceneAt`: a scene never changes, so what is made ready is remembered. Throws an Error when nodes carry each other in a ring. */
export function nodeTransforms(scene: SceneOfNodes): NodeTransforms {
  let transforms = prepared.get(scene);
  if (transforms === undefined) prepared.set(scene, (transforms = prepare(scene)));
  return transforms;
}

/** The clip that plays, or null. */
export function playingClip({ clips = {}, clip }: Pick<Scene, 'clips' | 'clip'>): Clip | null {
  if (clip === undefined) return null;
  if (!Object.hasOwn(clips, clip)) throw new Error(`The scene has no clip "${clip}".`);
  return clips[clip]!;
}

const PARTS = { translation: { at: 0, width: 3 }, rotation: { at: 3, width: 4 }, scale: { at: 7, width: 3 } } as const;
/** Translation, rotation and scale of one node, one after the other. */
const LOCAL_LENGTH = 10;

/** Sets numbers of `locals`. `time`: the scene's, or that within the clip. */
type Channel = (time: number, locals: Float64Array) => void;

function prepare(scene: SceneOfNodes): NodeTransforms {
  const { order: names, faults } = inOrder(scene.nodes ?? {});
  if (faults.length > 0) throw new Error(wordsOf(faults[0]!));
  const nodes = names.map((name) => scene.nodes![name]!);
  const indexOf = new Map(names.map((name, index) => [name, index]));
  const parents = Int32Array.from(nodes, ({ parent }) => (parent === undefined ? -1 : indexOf.get(parent)!));
  const locals = localsOf(nodes);
  const place = placer(nodes, parents, locals);
  const still = new Float64Array(names.length * AFFINE_LENGTH);
  for (let node = 0; node < names.length; node++) place(still, node);
  const { channels, ofClip, driven } = channelsOf(scene, indexOf);
  const clip = playingClip(scene);
  const moving = movingNodes(parents, driven);
  const at = (time: number, out = new Float64Array(still.length)): Float64Array => {
    if (!Number.isFinite(time))
      throw new RangeError(`The scene's time must be a finite number of seconds, not ${time}.`);
    out.set(still);
    for (const channel of channels) channel(time, locals);
    const within = clip ? clipTime(clip, time) : 0;
    for (const channel of ofClip) channel(within, locals);
    for (let k = 0; k < moving.length; k++) place(out, moving[k]!);
    return out;
  };
  return { names, indexOf, moving, at };
}

function localsOf(nodes: readonly SceneNode[]): Float64Array {
  const locals = new Float64Array(nodes.length * LOCAL_LENGTH);
  nodes.forEach(({ translation, rotation, scale }, i) => {
    locals.set(
      [...(translation ?? [0, 0, 0]), ...(rotation ?? [0, 0, 0, 1]), ...(scale ?? [1, 1, 1])],
      i * LOCAL_LENGTH,
    );
  });
  return locals;
}

/** Gives a function that writes the world matrix of one node, once that of its parent stands there. */
function placer(nodes: readonly SceneNode[], parents: Int32Array, locals: Float64Array) {
  const fixed = nodes.map(({ matrix }) => matrix ?? null);
  const local = new Float64Array(AFFINE_LENGTH);
  return (out: Float64Array, node: number): void => {
    const [at, from, parent] = [node * AFFINE_LENGTH, node * LOCAL_LENGTH, parents[node]!];
    const matrix = fixed[node];
    if (matrix) copyAffine(local, 0, matrix);
    else composeAffine(local, 0, locals, from, locals, from + 3, locals, from + 7);
    if (parent < 0) out.set(local, at);
    else multiplyMatrices(out, at, out, parent * AFFINE_LENGTH, local, 0);
  };
}

/** The nodes that are driven, and all that these carry. */
function movingNodes(parents: Int32Array, driven: ReadonlySet<number>): Uint32Array {
  const moves = new Uint8Array(parents.length);
  for (let i = 0; i < parents.length; i++) moves[i] = driven.has(i) || (parents[i]! >= 0 && moves[parents[i]!]) ? 1 : 0;
  return Uint32Array.from(parents.keys()).filter((i) => moves[i] === 1);
}

function channelsOf(scene: SceneOfNodes, indexOf: ReadonlyMap<string, number>) {
  const channels: Channel[] = [];
  const ofClip: Channel[] = [];
  const driven = new Set<number>();
  const placeOf = (target: string): { at: number; width: number } | null => {
    const [section, name = '', part = '', component, ...more] = parsePointer(target) ?? [];
    const index = section === 'nodes' ? indexOf.get(name) : undefined;
    if (index === undefined || !Object.hasOwn(PARTS, part) || more.length > 0) return null;
    driven.add(index);
    const { at, width } = PARTS[part as keyof typeof PARTS];
    return component === undefined
      ? { at: index * LOCAL_LENGTH + at, width }
      : { at: index * LOCAL_LENGTH + at + Number(component), width: 1 };
  };
  for (const track of scene.animation) {
    const place = placeOf(track.target);
    if (place === null) continue;
    const compiled = compileTrack(track);
    const value: number[] = [];
    channels.push((time, locals) => {
      evaluateTrack(compiled, time, value);
      for (let i = 0; i < place.width; i++) locals[place.at + i] = value[i]!;
    });
  }
  const clip = playingClip(scene);
  for (const track of clip?.tracks ?? []) {
    const place = placeOf(track.target);
    if (place === null || track.times.length === 0) continue;
    const [width, rotation] = [widthOf(track), isRotation(track)];
    ofClip.push((within, locals) => evaluateSampled(track, width, rotation, within, locals, place.at));
  }
  return { channels, ofClip, driven };
}

function wordsOf({ node, fault }: NodeFault): string {
  return fault === 'cycle'
    ? `The node "${node}" carries itself, by way of its parents.`
    : `The node "${node}" has a parent that the scene does not have.`;
}

/** The world matrix of the node of this name, or the identity for no name; throws when there is no such node. */
export function worldOf(transforms: NodeTransforms, world: Float64Array, node: string | undefined): ArrayLike<number> {
  if (node === undefined) return IDENTITY;
  const index = transforms.indexOf.get(node);
  if (index === undefined) throw new Error(`The scene has no node "${node}".`);
  return world.subarray(index * AFFINE_LENGTH, (index + 1) * AFFINE_LENGTH);
}
