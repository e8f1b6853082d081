import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { arm, dough } from '../../../../tests/fixtures/motion.ts';
import { PoseWorker } from '../../../../tests/fixtures/pose-worker.ts';
import type { Mesh } from '../scene/mesh.ts';
import { type Moment, Motion } from '../scene/motion.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { type PackedGeometry, packGeometry } from './pack-geometry.ts';
import { packMesh } from './pack-mesh.ts';
import { wordsOf } from './packed-mesh.ts';
import { type WorkerPoses, workerPoses } from './worker-poses.ts';

const EYE: Vec3 = [0, 0, 9];
const ROWS = { first: 0, covers: [0, 0], glows: [] };
const bone = arm(64, 36);
const meshOf = (scene: Scene): Mesh => Object.values(scene.meshes!)[0]!.data!;
/** Two meshes, one of them with joints. */
const both: Scene = {
  ...bone,
  meshes: { ...bone.meshes, ...dough(20, 10).meshes },
  nodes: { ...bone.nodes, dough: { weights: [1, 0] } },
  shapes: { ...bone.shapes, dough: { ...dough(20, 10).shapes.dough!, node: 'dough' } as Scene['shapes'][string] },
};

beforeEach(() => {
  PoseWorker.all.length = 0;
  vi.stubGlobal('Worker', PoseWorker);
});
afterEach(() => {
  vi.unstubAllGlobals();
});

/** Words of all meshes, one behind the other. */
const words = ({ meshes }: PackedGeometry): Buffer => Buffer.concat(meshes.flatMap((mesh) => wordsOf(mesh).map((w) => Buffer.from(w.slice().buffer)))); // biome-ignore format: one thought

/** Draws as a page does, whenever there is another moment to draw. */
class Player {
  readonly motion: Motion;
  readonly poses: WorkerPoses;
  geometry: PackedGeometry | null = null;
  drawn: Moment | null = null;

  constructor(readonly scene: Scene) {
    this.motion = new Motion(scene);
    this.poses = workerPoses(scene, 0, null)!;
  }
  /** Of the moment that is drawn when this time is wanted. */
  draw(time: number): Buffer {
    const moment = this.poses.at(this.motion.at(time));
    if (moment !== this.drawn) this.geometry = packGeometry(moment, ROWS, EYE, this.geometry, 0, this.poses);
    this.drawn = moment;
    return words(this.geometry!);
  }
  /** As this thread has them. */
  wanted(time: number): Buffer {
    return words(packGeometry(this.motion.at(time), ROWS, EYE));
  }
}

describe.each(Object.entries({ arm: bone, both }))('%s', (_, scene) => {
  test('what is drawn is always as it was at one time, and in the end at the one that is wanted', () => {
    const player = new Player(scene);
    const [worker] = PoseWorker.all as [PoseWorker];
    expect(player.draw(0.1).equals(player.wanted(0.1))).toBe(true);
    for (const time of [0.2, 0.3, 0.4, 0.5, 0.6]) {
      const before = player.drawn!.time;
      worker.work();
      const found = player.draw(time);
      expect(player.drawn!.time).toBeGreaterThanOrEqual(before);
      expect(player.drawn!.time).toBeLessThan(time);
      expect(found.equals(player.wanted(player.drawn!.time))).toBe(true);
      // Nothing new has come yet.
      const { geometry } = player;
      const { revision } = geometry!.meshes[0]!;
      player.draw(time + 0.01);
      expect(player.geometry!.meshes[0]!.revision).toBe(revision);
    }
    for (let i = 0; i < 3; i++) {
      worker.work();
      player.draw(0.7);
    }
    expect(player.drawn!.time).toBe(0.7);
    expect(player.draw(0.7).equals(player.wanted(0.7))).toBe(true);
  });

  test('a time of its own is drawn exactly, whatever the worker is at', () => {
    const player = new Player(scene);
    player.draw(0.1);
    PoseWorker.all[0]!.work();
    player.draw(0.2);
    player.draw(0.3);
    const exact = packGeometry(player.motion.at(1.7), ROWS, EYE, player.geometry, 0, player.poses);
    expect(words(exact).equals(player.wanted(1.7))).toBe(true);
    PoseWorker.all[0]!.work();
    expect(player.draw(0.3).equals(player.wanted(player.drawn!.time))).toBe(true);
  });
});

test('memory goes to and fro: three pieces, however long it plays', () => {
  const player = new Player(bone);
  const [worker] = PoseWorker.all as [PoseWorker];
  for (let i = 0; i < 20; i++) {
    player.draw(i / 60);
    // Sometimes it needs longer.
    if (i % 3 !== 1) worker.work();
  }
  expect(worker.made).toBeLessThanOrEqual(3);
});

test('what does not move is not sent again, and a scene that stands still needs nothing more', () => {
  const player = new Player(both);
  const [worker] = PoseWorker.all as [PoseWorker];
  player.draw(0.1);
  worker.work();
  player.draw(0.2);
  player.draw(0.3);
  expect(worker.orders).toEqual([[0, 1], [0]]);
  worker.work();
  player.draw(0.3);
  worker.work();
  const { sent } = worker;
  for (let i = 0; i < 3; i++) player.draw(0.3);
  expect(worker.sent).toBe(sent);
});

test('a tree that has become a bad one is replaced in the worker', () => {
  const base = dough(64, 36);
  const data = meshOf(base);
  // All triangles begin at one place, where no tree is better than another.
  const morphTargets = [{ positions: data.positions }, { positions: data.positions.map((x, i) => (i % 3 === 1 ? x : 0)) }]; // biome-ignore format: one thought
  const folded = { ...data, positions: new Float32Array(data.positions.length), morphTargets };
  const player = new Player({ ...base, meshes: { dough: { data: folded } } });
  const meshes = new Set<unknown>();
  for (let i = 0; i < 60; i++) {
    player.draw(0.5 + i / 60);
    PoseWorker.all[0]!.work();
    meshes.add(player.geometry!.meshes[0]);
  }
  expect(meshes.size).toBe(2);
  const [mesh] = player.geometry!.meshes;
  expect(mesh!.order).not.toEqual(packMesh(folded).order);
  expect([...mesh!.order].sort((a, b) => a - b)).toEqual(Array.from({ length: data.indices.length / 3 }, (_, i) => i));
  expect(mesh!.whole!.length).toBe(mesh!.nodes.length + mesh!.triangles.length + mesh!.vertices.words.length);
  // This thread has the tree that it came with.
  const time = player.drawn!.time + 1;
  const exact = packGeometry(player.motion.at(time), ROWS, EYE, player.geometry, 0, player.poses);
  expect(words(exact).equals(player.wanted(time))).toBe(true);
});

test('where the worker fails this thread goes on, and tells what is wrong', () => {
  const base = dough(64, 36);
  const data = meshOf(base);
  // Too far for numbers of 32 bits.
  const morphTargets = data.morphTargets!.map(({ positions }) => ({ positions: positions!.map((x) => 1e38 * x) }));
  const tracks = base.clips!.play!.tracks.map((track) => ({ ...track, values: track.values.map((x) => 1e38 * x) }));
  const bad = { ...base, meshes: { dough: { data: { ...data, morphTargets } } }, clips: { play: { duration: 4, tracks } } }; // biome-ignore format: one thought
  for (const fail of [(worker: PoseWorker) => worker.fail('refused'), (worker: PoseWorker) => worker.work()]) {
    const player = new Player(bad);
    const worker = PoseWorker.all.at(-1)!;
    player.poses.at(player.motion.at(0.1));
    fail(worker);
    expect(worker.ended).toBe(true);
    expect(() => player.draw(0.2)).toThrow(/not finite/);
  }
});

test('little is bent on this thread, what the device bends there; other scenes of the same meshes go on with the worker', () => {
  expect(workerPoses(arm(20, 10), 0, null)).toBeNull();
  expect(workerPoses(bone, 1e9, null)).toBeNull();
  expect(PoseWorker.all.length).toBe(0);
  const player = new Player(bone);
  player.draw(0.1);
  PoseWorker.all[0]!.work();
  const other = { ...bone, camera: { ...bone.camera, verticalFov: 20 } };
  expect(workerPoses(other, 0, player.poses)).toBe(player.poses);
  const moment = new Motion(other).at(0.1);
  expect(player.poses.at(moment)).toBe(moment);
  const meshes = { arm: { data: { ...meshOf(bone) } } };
  expect(workerPoses({ ...bone, meshes }, 0, player.poses)).not.toBe(player.poses);
  expect(PoseWorker.all.map(({ ended }) => ended)).toEqual([true, false]);
});
