import { beforeAll, expect, test } from 'vitest';
import { swarm } from '../../../../tests/fixtures/motion.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testMaterial } from '../../../../tests/fixtures/scenes.ts';
import { Motion } from '../scene/motion.ts';
import type { Scene, Track, Vec3 } from '../scene/scene.ts';
import { loadGeometryPacker } from './geometry-packer.ts';
import { packPathScene } from './pack-path-scene.ts';
import { type PackedScene, packScene } from './pack-scene.ts';

beforeAll(loadGeometryPacker);

const base = swarm(seededRandom(1), 8);
const scene: Scene = {
  ...base,
  shapes: {
    ...base.shapes,
    // Which of the two planes may cast shadows depends on where the eye is.
    wall: { type: 'plane', point: [0, 0, -2], normal: [0, 0, 1], material: 'red' },
    floor: { type: 'plane', point: [0, -50, 0], normal: [0, 1, 0], material: 'white' },
    ball: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'red' },
  },
  materials: { ...base.materials, red: testMaterial({ baseColor: [1, 0, 0], emission: [1, 0, 0] }) },
  lights: { lamp: testLight({ center: [0, 5, 9], visible: true }) },
};

/** All that a kernel may read of it, but the geometry. */
const contentOf = ({ table, rows, geometry: _, source: __, textures, ...rest }: PackedScene) => ({
  ...rest,
  uses: textures?.uses,
  table: table.f32.slice(0, rows * (table.f32.length / rows)),
});

test('packed on top of an earlier moment it is what it is when packed at once', () => {
  const track: Track = {
    target: '/materials/red/baseColor',
    interpolation: 'linear',
    repeat: 'once',
    keys: [
      { time: 2, value: [1, 0, 0] },
      { time: 3, value: [0, 0, 1] },
    ],
  };
  const motion = new Motion({ ...scene, animation: [track] });
  let packed: PackedScene | undefined;
  const moments: [number, Vec3][] = [[0, [0, 0, 9]], [0, [0, 0, 9]], [1, [0, 0, 9]], [1, [0, 0, -9]], [2.5, [0, 0, -9]], [2.5, [3, 0, 1]], [0, [0, -60, 9]]]; // biome-ignore format: a list
  for (const [time, eye] of moments) {
    packed = packPathScene(motion.at(time), eye, { reuse: packed });
    expect(contentOf(packed)).toEqual(contentOf(packPathScene(new Motion(motion.at(time).played).at(time), eye)));
  }
});

test('the table is written only when something in it is another', () => {
  const motion = new Motion(scene);
  const first = packPathScene(motion.at(0), [0, 0, 9]);
  const next = packPathScene(motion.at(1), [0, 0, 9], { reuse: first });
  expect(next.source).toBe(first.source);
  expect(next.geometry!.revision).toBe(2);
  const moved = packPathScene(motion.at(1), [0, 0, 8], { reuse: next });
  expect(moved.source).not.toBe(first.source);
  const reach = { right: [1, 0, 0] as Vec3, up: [0, 1, 0] as Vec3 };
  expect(packPathScene(motion.at(1), [0, 0, 8], { reuse: moved, reach }).source).not.toBe(moved.source);
});

test('what the classic integrator has packed is not taken for good', () => {
  const { 'thing 0': _, ...others } = Object.fromEntries(
    Object.entries(scene.shapes).filter(([, { type }]) => type !== 'mesh'),
  );
  const moment = new Motion({ ...scene, shapes: others as Scene['shapes'] }).at(0);
  const classic = packScene(moment.scene, [0, 0, 9]);
  const path = packPathScene(moment, [0, 0, 9], { reuse: classic });
  expect(contentOf(path)).toEqual(contentOf(packPathScene(moment, [0, 0, 9])));
});
