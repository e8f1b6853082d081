/** Meshes that the device bends, word by word beside those that this thread bends. */
import { Bender } from '../../../packages/renderer/src/bender.ts';
import { FrameController } from '../../../packages/renderer/src/frame-controller.ts';
import { GeometryBuffer } from '../../../packages/renderer/src/geometry-buffer.ts';
import type { Device } from '../../../packages/renderer/src/gpu/device.ts';
import { DEFAULT_SETTINGS, openWebGpu } from '../../../packages/renderer/src/headless/index.ts';
import { loadGeometryPacker } from '../../../packages/renderer/src/packed-scene/geometry-packer.ts';
import { fieldOffset, GEOMETRY_ROW } from '../../../packages/renderer/src/packed-scene/layout.ts';
import type { PackedGeometry } from '../../../packages/renderer/src/packed-scene/pack-geometry.ts';
import { type PackedMesh, wordsOf } from '../../../packages/renderer/src/packed-scene/packed-mesh.ts';
import { treeCost } from '../../../packages/renderer/src/packed-scene/tree-cost.ts';
import { type Moment, Motion, stillMoment } from '../../../packages/renderer/src/scene/motion.ts';
import { posedSceneAt } from '../../../packages/renderer/src/scene/posed.ts';
import type { Scene } from '../../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../../packages/renderer/src/stages.ts';
import { bendingScenes } from '../../fixtures/bending.ts';
import { arm } from '../../fixtures/motion.ts';

type Words = Uint32Array<ArrayBuffer>;

/** How a mesh that the device has bent differs from one that this thread has bent. */
export interface BentDifference {
  /** Of places, as a share of the greatest coordinate of the mesh. */
  places: number;
  /** Between unit vectors at vertices, radians. */
  directions: number;
  /** How far a triangle lies outside of a box about it, and what boxes are too large, likewise. */
  outside: number;
  slack: number;
  /** Words that should be the same. */
  others: number;
  /** Of the tree, relative, by the device and by what it should be. */
  cost: number;
}

const WORDS = { node: 28, triangle: 12 };
const [LEAST, GREATEST, CHILDREN] = [fieldOffset('WideNode', 'minX') / 4, fieldOffset('WideNode', 'maxX') / 4, fieldOffset('WideNode', 'children') / 4]; // biome-ignore format: one thought

/** As octahedral.wesl has it. */
function fromOctahedral(code: number): number[] {
  const [x, y] = [(code & 0xffff) / 32767 - 1, (code >>> 16) / 32767 - 1];
  const z = 1 - Math.abs(x) - Math.abs(y);
  const v = z >= 0 ? [x, y, z] : [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1), z];
  return v.map((c) => c / Math.hypot(...v));
}

const angle = (a: number, b: number): number => {
  const [u, v] = [fromOctahedral(a), fromOctahedral(b)];
  return 2 * Math.asin(Math.min(Math.hypot(...u.map((x, i) => x - v[i]!)) / 2, 1));
};

const floats = (words: Words) => new Float32Array(words.buffer, words.byteOffset, words.length);

function compareTriangles(found: Words, wanted: Words, difference: BentDifference): number {
  const [f, w] = [floats(found), floats(wanted)];
  const isPlace = (i: number) => i % 4 !== 3;
  const most = w.reduce((m, x, i) => (isPlace(i) ? Math.max(m, Math.abs(x)) : m), 0);
  found.forEach((word, i) => {
    if (isPlace(i)) difference.places = Math.max(difference.places, Math.abs(f[i]! - w[i]!) / most);
    else if (word !== wanted[i]) difference.others++;
  });
  return most;
}

function compareVertices(found: Words, wanted: Words, rows: number, flags: number, difference: BentDifference): void {
  const hand = 0x10000;
  found.forEach((word, i) => {
    const field = i % (rows * GEOMETRY_ROW);
    const isTangent = field === 1 && (flags & 2) !== 0;
    if ((field === 0 && (flags & 1) !== 0) || isTangent) {
      const mask = isTangent ? ~hand : ~0;
      difference.directions = Math.max(difference.directions, angle(word & mask, wanted[i]! & mask));
      if (isTangent && (word & hand) !== (wanted[i]! & hand)) difference.others++;
    } else if (word !== wanted[i]) difference.others++;
  });
}

/** Each box against the triangles below it, as the device has them. Gives the box of what is below a node. */
function checkBoxes(nodes: Words, triangles: Words, node: number, most: number, difference: BentDifference): number[] {
  const [n, t] = [floats(nodes), floats(triangles)];
  const all = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
  const grow = (box: number[], p: ArrayLike<number>, q: ArrayLike<number>) => {
    for (let a = 0; a < 3; a++) {
      box[a] = Math.min(box[a]!, p[a]!);
      box[a + 3] = Math.max(box[a + 3]!, q[a]!);
    }
  };
  for (let child = 0; child < 4; child++) {
    const reference = nodes[node * WORDS.node + CHILDREN + child]!;
    if (reference === 0) continue;
    let below = [Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity];
    if (reference >>> 31 === 0) below = checkBoxes(nodes, triangles, reference, most, difference);
    else
      for (let k = 0; k < 3 * ((reference >>> 28) & 7); k++) {
        const at = (reference & 0xfffffff) * WORDS.triangle + 4 * k;
        grow(below, t.subarray(at), t.subarray(at));
      }
    for (let a = 0; a < 3; a++) {
      const [least, greatest] = [n[node * WORDS.node + LEAST + 4 * a + child]!, n[node * WORDS.node + GREATEST + 4 * a + child]!]; // biome-ignore format: one thought
      difference.outside = Math.max(difference.outside, (least - below[a]!) / most, (below[a + 3]! - greatest) / most);
      difference.slack = Math.max(difference.slack, (below[a]! - least) / most, (greatest - below[a + 3]!) / most);
    }
    grow(all, below, below.slice(3));
  }
  return all;
}

function compareMesh(all: Words, first: number, wanted: PackedMesh, difference: BentDifference): number {
  let at = first * GEOMETRY_ROW;
  const [nodes, triangles, vertices] = [wanted.nodes, wanted.triangles, wanted.vertices.words].map((words) => {
    const part = all.slice(at, at + words.length);
    at += words.length;
    return part;
  }) as [Words, Words, Words];
  const most = compareTriangles(triangles, wanted.triangles, difference);
  compareVertices(vertices, wanted.vertices.words, wanted.vertices.rows, wanted.vertices.flags, difference);
  for (let i = CHILDREN; i < nodes.length; i += i % WORDS.node === WORDS.node - 1 ? CHILDREN + 1 : 1)
    if (nodes[i] !== wanted.nodes[i]) difference.others++;
  checkBoxes(nodes, triangles, 0, most, difference);
  return treeCost(nodes);
}

const nothing = (): BentDifference => ({ places: 0, directions: 0, outside: -Infinity, slack: 0, others: 0, cost: 0 });

/** What the device says that the trees cost, beside what they do. */
async function compareCosts(bender: Bender, costs: readonly number[], into: BentDifference): Promise<void> {
  const found = await bender.weigh();
  costs.forEach((cost, i) => {
    into.cost = Math.max(into.cost, Math.abs(found![i]! - cost) / cost);
  });
}

/** Goes to these times, one after the other, with meshes bent by the device, and compares them with those bent here at each of them. */
async function playBent(device: Device, bender: Bender, scene: Scene, times: readonly number[]) {
  const { packGeometry } = await loadGeometryPacker();
  const rows = { first: 0, covers: Object.keys(scene.shapes).map(() => 0), glows: [] };
  const [motion, eye] = [new Motion(scene), [0, 0, 0] as const];
  const buffer = new GeometryBuffer(device);
  const difference = nothing();
  let bent: PackedGeometry | null = null;
  let words = new Uint32Array(0);
  for (const time of times) {
    const moment = motion.at(time);
    bent = packGeometry(moment, rows, eye, bent, device.compute!.maxRows);
    const rewritten = buffer.hold(bent);
    bender.hold(bent.bending!, buffer.buffer, rewritten);
    words = await device.compute!.read(buffer.buffer, 0, bent.rows);
    const here = packGeometry(moment, rows, eye);
    let row = bent.movingRows;
    const costs = here.meshes.map((mesh) => {
      const cost = compareMesh(words, row, mesh, difference);
      row += wordsOf(mesh).reduce((sum, { length }) => sum + length, 0) / GEOMETRY_ROW;
      return cost;
    });
    await compareCosts(bender, costs, difference);
  }
  bender.release();
  buffer.release();
  return { difference, words: words.slice(bent!.movingRows * GEOMETRY_ROW) };
}

export interface BentScene extends BentDifference {
  /** Words that are others when the last time is gone to at once. */
  readonly unlikeDirect: number;
}

async function compareWords(device: Device, times: readonly number[]): Promise<Record<string, BentScene>> {
  const bender = await Bender.create(device, device.compute!);
  const found: Record<string, BentScene> = {};
  for (const [name, scene] of Object.entries(bendingScenes())) {
    const { difference, words } = await playBent(device, bender, scene, times);
    const direct = await playBent(device, bender, { ...scene }, times.slice(-1));
    found[name] = {
      ...difference,
      unlikeDirect: words.reduce((n, word, i) => n + (word === direct.words[i] ? 0 : 1), 0),
    };
  }
  return found;
}

const SIZE = 32;

/** Normals that the camera sees at these moments, one after the other. */
async function normalsAt(stages: Stages, moments: readonly Moment[]): Promise<Float32Array[]> {
  const films: Float32Array[] = [];
  for (const moment of moments) {
    const settings = { ...DEFAULT_SETTINGS, ...moment.scene.render, view: 'normal' } as const;
    const shot = { ...moment, camera: moment.scene.camera, settings, raysPerPixel: 1 };
    await stages.ready(shot);
    stages.film.reserve(SIZE, SIZE, 2);
    stages.begin(shot, SIZE, SIZE);
    await stages.addSamples(1, new FrameController(), () => {}, () => false); // biome-ignore format: one call
    films.push(await stages.device.read(stages.film.current.layers[1]!, SIZE, SIZE));
  }
  stages.leaveModel();
  return films;
}

/** Values of the last of some films that are off by more than this. */
const unlike = (films: readonly Float32Array[], other: readonly Float32Array[], most: number): number =>
  films.at(-1)!.reduce((n, x, i) => n + (Math.abs(x - other.at(-1)![i]!) <= most ? 0 : 1), 0);

/** Words of meshes, and films of a scene with some, bent by the device, by this thread, and after other times. */
export async function bentByDevice(times: readonly number[], gpu?: GPU) {
  const device = await openWebGpu(null, { gpu, computes: true });
  const scenes = await compareWords(device, times);
  const stages = await Stages.open(device);
  const motionOf = (scene: Scene) => (time: number) => new Motion(scene).at(time);
  const [scene, last] = [arm(30, 10), times.at(-1)!];
  const played = await normalsAt(stages, times.map(motionOf(scene)));
  const before = device.counts.buffers;
  const direct = await normalsAt(stages, [motionOf({ ...scene })(last)]);
  // Bent as plain data, which knows nothing of frames.
  const here = await normalsAt(stages, [stillMoment(posedSceneAt(scene, last))]);
  const films = {
    moves: unlike(played.slice(0, 1), played, 0),
    unlikeDirect: unlike(played, direct, 0),
    unlikeHere: unlike(played, here, 1e-3),
  };
  const left = device.counts.buffers - before;
  device.destroy();
  return { scenes, films, left };
}
