/** What moves together: nodes that carry shapes, lights and the camera, skins that bend meshes, and clips that move all of it. */
import type { Repeat, Vec3 } from './scene.ts';

/** A turn by the angle φ about the unit axis a: (a sin φ/2, cos φ/2). Length 1. */
export type Quaternion = readonly [x: number, y: number, z: number, w: number];
/** The first three rows of a 4 × 4 matrix for column vectors, row by row: 12 numbers. The fourth row is 0 0 0 1. */
export type Affine = readonly number[];

/**
 * A place that other things are placed in. Its world matrix is the parent's world matrix · translation · rotation · scale; with `matrix`,
 * the parent's · matrix. Scales may be negative (a mirror image) or 0.
 */
export interface SceneNode {
  /** Name of the node that carries this one. Left out: the world. No node may carry itself. */
  readonly parent?: string;
  /** Default: [0, 0, 0]. */
  readonly translation?: Vec3;
  /** Default: [0, 0, 0, 1], no turn. */
  readonly rotation?: Quaternion;
  /** Default: [1, 1, 1]. */
  readonly scale?: Vec3;
  /** Instead of the three; cannot move. */
  readonly matrix?: Affine;
  /** How much of each morph target the meshes have that this node carries. Left out: none of any. */
  readonly weights?: readonly number[];
}

/**
 * A skeleton: joint i moves a vertex by the world matrix of its node · `inverseBindMatrices` i. A mesh with a skin is placed by its joints
 * alone, wherever its node and its own placement are (glTF 2.0, 3.7.3.3).
 */
export interface Skin {
  /** Names of nodes; `SkinWeights.joints` of a mesh are positions in this list. */
  readonly joints: readonly string[];
  /** 12 numbers a joint, as `Affine`: from the mesh's space to the joint's. Left out: no change. */
  readonly inverseBindMatrices?: Float32Array;
}

/**
 * Moves one property through many keys that lie in plain arrays, as recorded motion does. What it does between keys is glTF's: `linear`
 * turns a node's `rotation` along the shorter arc (slerp); `cubic` is Hermite's curve. Before the first key and after the last the value stays.
 */
export interface SampledTrack {
  /** JSON Pointer to a number or a list of numbers, such as "/nodes/left arm/rotation". */
  readonly target: string;
  readonly interpolation: 'step' | 'linear' | 'cubic';
  /** Seconds, never falling. */
  readonly times: Float32Array;
  /** One value a key; for `cubic` three: the slope coming in, the value, the slope going out, slopes per second. */
  readonly values: Float32Array;
}

/** A motion with a name. */
export interface Clip {
  /** Seconds after which it repeats. */
  readonly duration: number;
  /** Default: `loop`. */
  readonly repeat?: Repeat;
  readonly tracks: readonly SampledTrack[];
}

/** Other materials for some of the shapes: material by shape (KHR_materials_variants). */
export type Variant = Readonly<Record<string, string>>;

/** Something that is wrong between nodes. */
export interface NodeFault {
  readonly node: string;
  /** `parent`: there is no such node. `cycle`: the node carries itself, by way of others perhaps. */
  readonly fault: 'parent' | 'cycle';
}

/** The nodes, each after the one that carries it; and what is wrong, with the nodes concerned left out. */
export function inOrder(nodes: Readonly<Record<string, SceneNode>>): { order: string[]; faults: NodeFault[] } {
  const order: string[] = [];
  const faults: NodeFault[] = [];
  /** 1: on the way up from the node that is looked at; 2: done; 3: at fault. */
  const state = new Map<string, 1 | 2 | 3>();
  for (const start of Object.keys(nodes)) {
    const path: string[] = [];
    let at: string | undefined = start;
    while (at !== undefined && !state.has(at) && Object.hasOwn(nodes, at)) {
      state.set(at, 1);
      path.push(at);
      at = nodes[at]!.parent;
    }
    const known = at === undefined ? 2 : state.get(at);
    if (at !== undefined && known === undefined) faults.push({ node: path.at(-1)!, fault: 'parent' });
    if (known === 1) faults.push({ node: at!, fault: 'cycle' });
    for (const name of path.reverse()) {
      state.set(name, known === 2 ? 2 : 3);
      if (known === 2) order.push(name);
    }
  }
  return { order, faults };
}
