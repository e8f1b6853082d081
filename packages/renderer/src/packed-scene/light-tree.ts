/**
 * A tree over emitters, by which kernels choose one of many (shading/light/emitter/light_tree.wesl): Conty & Kulla, "Importance Sampling
 * of Many Lights with Adaptive Tree Splitting", HPG 2018. Four children a node and all leaves on the lowest level, so that nodes need
 * no references: the children of node k are 4 k + 1 … 4 k + 4, and the base-4 digits of a leaf's number lead to it. Lights are halved at
 * their median along the longest side of their places, twice a level; not all leaves are taken.
 */
import type { Vec3 } from '../scene/scene.ts';
import { add, cross, dot, length, negate, normalize, scale, subtract } from '../scene/vec3.ts';
import { treeDepth, treeNodes, WIDTH } from './light-tree-size.ts';
import type { StructValues } from './write-struct.ts';

/** Which way light goes: pbrt-v4's cone of normals, section 12.6.3. */
export interface LitCone {
  /** Unit. */
  readonly axis: Vec3;
  /** Cosine of the angle from the axis that no normal exceeds. */
  readonly cosWidth: number;
  /** Cosine of the angle from a normal that no light exceeds. */
  readonly cosEdge: number;
  /** Whether there is light against the normals as well. */
  readonly bothSides: boolean;
  /** power / distance² estimates the irradiance, along the axis. */
  readonly power: number;
}
export interface LightOfTree extends LitCone {
  readonly center: Vec3;
  /** Radius of a sphere about all of it. */
  readonly reach: number;
}
export type NodeValues = Required<StructValues<'LightNode'>>;

export interface LightTree {
  /** Levels of nodes. */
  readonly depth: number;
  /** In the order of their numbers. */
  readonly nodes: readonly NodeValues[];
  /** Number of the leaf that each light is. */
  readonly leaves: Uint32Array;
}

interface Bounded extends LightOfTree {
  readonly min: Vec3;
  readonly max: Vec3;
  /** Number of the light, where it is one. */
  readonly light: number;
}

/** At least one light. Nodes name lights by their numbers, from `first` on. */
export function buildLightTree(lights: readonly LightOfTree[], first = 0): LightTree {
  const depth = treeDepth(lights.length);
  const nodes = new Array<NodeValues>(treeNodes(lights.length));
  const leaves = new Uint32Array(lights.length);
  const bounded = lights.map((light, k): Bounded => {
    const around: Vec3 = [light.reach, light.reach, light.reach];
    return { ...light, min: subtract(light.center, around), max: add(light.center, around), light: first + k };
  });
  const order = Uint32Array.from(lights.keys());

  const build = (node: number, level: number, from: number, to: number, leaf: number): Bounded | null => {
    if (from === to) return null;
    if (level === depth) {
      leaves[order[from]!] = leaf;
      return bounded[order[from]!]!;
    }
    const ends = [from, ...quarters(bounded, order, from, to), to];
    const children = [0, 1, 2, 3].map((k) =>
      build(WIDTH * node + 1 + k, level + 1, ends[k]!, ends[k + 1]!, WIDTH * leaf + k),
    );
    nodes[node] = nodeOf(children);
    return children.reduce((all, one) => (all && one ? union(all, one) : (all ?? one)), null);
  };
  build(0, 0, 0, lights.length, 0);
  const empty = nodeOf([null, null, null, null]);
  for (let k = 0; k < nodes.length; k++) nodes[k] ??= empty;
  return { depth, nodes, leaves };
}

/** Orders the range so that its quarters lie together, and gives where the second, third and last begin. */
function quarters(lights: readonly Bounded[], order: Uint32Array, from: number, to: number): number[] {
  const half = halve(lights, order, from, to);
  return [halve(lights, order, from, half), half, halve(lights, order, half, to)];
}

function halve(lights: readonly Bounded[], order: Uint32Array, from: number, to: number): number {
  const middle = (from + to + 1) >> 1;
  if (to - from < 2) return middle;
  const [min, max] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]]; // biome-ignore format: a box
  for (let k = from; k < to; k++) {
    const { center } = lights[order[k]!]!;
    for (let c = 0; c < 3; c++) {
      min[c] = Math.min(min[c]!, center[c]!);
      max[c] = Math.max(max[c]!, center[c]!);
    }
  }
  const sides = max.map((x, c) => x - min[c]!);
  const axis = sides.indexOf(Math.max(...sides));
  select(order, from, to, middle, (light) => lights[light]!.center[axis]!);
  return middle;
}

/** Hoare's quickselect: what belongs before `middle` in order of the keys comes before it. */
function select(order: Uint32Array, from: number, to: number, middle: number, keyOf: (light: number) => number): void {
  let [low, high] = [from, to - 1];
  while (low < high) {
    const pivot = keyOf(order[(low + high) >> 1]!);
    let [i, j] = [low, high];
    while (i <= j) {
      while (keyOf(order[i]!) < pivot) i++;
      while (keyOf(order[j]!) > pivot) j--;
      if (i > j) break;
      [order[i], order[j]] = [order[j]!, order[i]!];
      i++;
      j--;
    }
    if (middle <= j) high = j;
    else if (middle >= i) low = i;
    else return;
  }
}

/** What has no power is nowhere. */
function union(a: Bounded, b: Bounded): Bounded {
  if (a.power === 0 || b.power === 0) return a.power === 0 ? b : a;
  const min: Vec3 = [Math.min(a.min[0], b.min[0]), Math.min(a.min[1], b.min[1]), Math.min(a.min[2], b.min[2])];
  const max: Vec3 = [Math.max(a.max[0], b.max[0]), Math.max(a.max[1], b.max[1]), Math.max(a.max[2], b.max[2])];
  return {
    min,
    max,
    center: scale(add(min, max), 0.5),
    reach: length(subtract(max, min)) / 2,
    ...coneAbout(a, b),
    cosEdge: Math.min(a.cosEdge, b.cosEdge),
    bothSides: a.bothSides || b.bothSides,
    power: a.power + b.power,
    light: -1,
  };
}

/** The least cone about two; pbrt-v4, section 3.8.4. Where light goes both ways an axis may point either way. */
function coneAbout(a: LitCone, b: LitCone): Pick<LitCone, 'axis' | 'cosWidth'> {
  const turned = a.bothSides && b.bothSides && dot(a.axis, b.axis) < 0;
  const axis = turned ? negate(b.axis) : b.axis;
  const [widthA, widthB] = [angle(a.cosWidth), angle(b.cosWidth)];
  const between = angle(dot(a.axis, axis));
  if (Math.min(between + widthB, Math.PI) <= widthA) return { axis: a.axis, cosWidth: a.cosWidth };
  if (Math.min(between + widthA, Math.PI) <= widthB) return { axis, cosWidth: b.cosWidth };
  const width = (widthA + between + widthB) / 2;
  const across = cross(a.axis, axis);
  if (width >= Math.PI || length(across) === 0) return { axis: a.axis, cosWidth: -1 };
  // Rodrigues' formula, about a normal of both axes.
  const turn = width - widthA;
  const beside = cross(normalize(across), a.axis);
  return {
    axis: normalize(add(scale(a.axis, Math.cos(turn)), scale(beside, Math.sin(turn)))),
    cosWidth: Math.cos(width),
  };
}
const angle = (cosine: number): number => Math.acos(Math.min(Math.max(cosine, -1), 1));

function nodeOf(children: readonly (Bounded | null)[]): NodeValues {
  const each = (value: (child: Bounded) => number) => children.map((child) => (child ? value(child) : 0));
  return {
    x: each(({ center }) => center[0]),
    y: each(({ center }) => center[1]),
    z: each(({ center }) => center[2]),
    reach: each(({ reach }) => reach),
    axisX: each(({ axis }) => axis[0]),
    axisY: each(({ axis }) => axis[1]),
    axisZ: each(({ axis }) => axis[2]),
    cosWidth: each(({ cosWidth }) => cosWidth),
    cosEdge: each(({ cosEdge }) => cosEdge),
    bothSides: each(({ bothSides }) => (bothSides ? 1 : 0)),
    power: each(({ power }) => power),
    emitters: each(({ light }) => light),
  };
}
