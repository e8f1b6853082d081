import { describe, expect, test } from 'vitest';
import { arm, carousel, dough, swarm } from '../../../../tests/fixtures/motion.ts';
import { between, type Random, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight } from '../../../../tests/fixtures/scenes.ts';
import { Bodies } from './bodies.ts';
import { Motion } from './motion.ts';
import { meshMatrices, meshShapes } from './placed.ts';
import { posedSceneAt } from './posed.ts';
import type { MeshShape, Scene, Track } from './scene.ts';

/** What `posedSceneAt` says of the same meshes, which knows nothing of arrays that are kept. */
function checkBodies(scene: Scene, time: number, { all, matrices }: Bodies): void {
  const posed = posedSceneAt(scene, time);
  const shapes = meshShapes(posed);
  expect(all.map(({ name }) => name)).toEqual(shapes.map(([name]) => name));
  shapes.forEach(([, shape], i) => {
    const { first, count, form, mesh } = all[i]!;
    const wanted = meshMatrices(shape, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);
    expect(12 * count).toBe(wanted.length);
    // Lists of instances are rounded to 32 bits there.
    wanted.forEach((x, k) => {
      expect(Math.abs(matrices[12 * first + k]! - x)).toBeLessThan(1e-6 * (1 + Math.abs(x)));
    });
    const data = posed.meshes![shape.mesh]!.data!;
    expect((form ?? mesh).positions).toEqual(data.positions);
    expect((form ?? mesh).normals).toEqual(data.normals);
    expect((form ?? mesh).tangents).toEqual(data.tangents);
  });
}

const times = (random: Random) => [0, ...Array.from({ length: 6 }, () => between(random, -3, 9)), 0];
const scenes = {
  swarm: swarm(seededRandom(1), 30),
  carousel: carousel(seededRandom(2), 30),
  arm: arm(20, 8),
  dough: dough(20, 8),
};

test.each(Object.entries(scenes))(
  '%s: played in any order, it is at every time what the scene is then (seed 91)',
  (_, scene) => {
    const random = seededRandom(91);
    const motion = new Motion(scene);
    const bodies = new Bodies(scene);
    for (const time of times(random)) {
      bodies.goTo(time);
      const { scene: now } = motion.at(time);
      checkBodies(scene, time, bodies);
      const { camera, lights, materials } = posedSceneAt(scene, time);
      expect({ camera: now.camera, lights: now.lights, materials: now.materials }).toEqual({
        camera,
        lights,
        materials,
      });
    }
  },
);

const track = (target: string, a: Track['keys'][0]['value'], b: Track['keys'][0]['value']): Track => ({
  target,
  interpolation: 'linear',
  repeat: 'ping-pong',
  keys: [
    { time: 0, value: a },
    { time: 2, value: b },
  ],
});

describe('tracks of the scene itself', () => {
  const { shapes, ...rest } = scenes.swarm;
  const moving: Scene = {
    ...rest,
    shapes: {
      ...shapes,
      'thing 3': { ...(shapes['thing 3'] as MeshShape), matrix: [1, 2, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1] },
    } as Scene['shapes'],
    animation: [
      track('/shapes/thing 3/translation', [0, 0, 0], [1, 2, 3]),
      track('/shapes/thing 3/rotation/1', 0, 400),
      track('/shapes/thing 4/scale', [1, 1, 1], [-1, 2, 1]),
      track('/shapes/thing 5/rotation', [10, 20, 30], [-70, 200, 30]),
    ],
  };

  test('move meshes as posedSceneAt does, through a scale of 0 too', () => {
    const bodies = new Bodies(moving);
    for (const time of [0, 0.4, 1, 1.7, 3.1]) {
      bodies.goTo(time);
      checkBodies(moving, time, bodies);
    }
  });

  test('the scene stays the same object while only meshes move, and is another one when more does', () => {
    const motion = new Motion(moving);
    const { scene } = motion.at(0);
    expect(motion.at(1).scene).toBe(scene);
    const lit: Scene = { ...moving, animation: [...moving.animation, track('/lights/lamp/radius', 1, 2)] };
    const play = new Motion(lit);
    expect([0, 1, 2].map((time) => (play.at(time).scene.lights.lamp as { radius: number }).radius)).toEqual([
      1, 1.5, 2,
    ]);
    const carried: Scene = { ...moving, lights: { lamp: testLight({ node: 'node 1' }) } };
    const carries = new Motion(carried);
    for (const time of [0, 1]) expect(carries.at(time).scene.lights).toEqual(posedSceneAt(carried, time).lights);
  });
});

test('a form is written when joints or weights have changed, and only then', () => {
  for (const scene of [scenes.arm, scenes.dough]) {
    const bodies = new Bodies(scene);
    const revisions = [0, 0, 1, 1, 2.5, 0].map((time) => {
      bodies.goTo(time);
      return bodies.all[0]!.poseRevision;
    });
    expect(revisions).toEqual([1, 1, 2, 2, 3, 4]);
  }
});

test('tracks that point at nothing, and meshes that have not been loaded, are refused', () => {
  const { swarm: scene } = scenes;
  expect(() => new Motion({ ...scene, animation: [track('/shapes/nobody/translation', 0, 1)] })).toThrow(
    'moves nothing',
  );
  expect(() => new Bodies({ ...scene, meshes: { thing: { file: 'a.ply' } } })).toThrow('has not been loaded');
});
