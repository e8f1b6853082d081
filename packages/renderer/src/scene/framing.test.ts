import { describe, expect, test } from 'vitest';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { cameraAxes } from './camera.ts';
import { environmentFault } from './environment.ts';
import { cameraAround, frameScene } from './framing.ts';
import type { Mesh } from './mesh.ts';
import type { SceneNode } from './nodes.ts';
import type { MeshShape, Scene, Shape, Vec3 } from './scene.ts';
import { boundsAt } from './scene-bounds.ts';
import { studioEnvironment } from './studio-environment.ts';
import { dot, subtract } from './vec3.ts';

const TRIANGLE: Mesh = {
  // The last vertex belongs to no triangle.
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 100, 100, 100),
  indices: Uint32Array.of(0, 1, 2),
};
const mesh = (part: Partial<MeshShape> = {}): Shape => ({ type: 'mesh', mesh: 'm', material: 'white', translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1], ...part }) as unknown as Shape; // biome-ignore format: short
const sceneOf = (shapes: Record<string, Shape>, data: Mesh = TRIANGLE, rest: Partial<Scene> = {}): Scene =>
  testScene(shapes, {}, { meshes: { m: { data } }, ...rest });
const close = (found: readonly number[], wanted: readonly number[]): void =>
  wanted.forEach((value, i) => {
    expect(found[i]).toBeCloseTo(value, 5);
  });

describe('bounds', () => {
  test('of vertices that triangles use, where nodes and placements put them', () => {
    const nodes: Record<string, SceneNode> = { n: { translation: [0, 0, 5], scale: [2, 2, 2] } };
    const bounds = boundsAt(sceneOf({ a: mesh({ node: 'n', translation: [1, 0, 0] }) }, TRIANGLE, { nodes }), 0)!;
    close(bounds.min, [2, 0, 5]);
    close(bounds.max, [4, 2, 5]);
  });

  test('of analytic shapes; planes have none, and an empty scene neither', () => {
    const plane: Shape = { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'white' };
    expect(boundsAt(testScene({ plane }, {}), 0)).toBeNull();
    const bounds = boundsAt(
      testScene(
        {
          plane,
          ball: { type: 'sphere', center: [0, 1, 0], radius: 1, material: 'white' },
          box: { type: 'box', center: [3, 0, 0], size: [2, 2, 2], rotation: [0, 0, 45], material: 'white' },
        },
        {},
      ),
      0,
    )!;
    close(bounds.min, [-1, -Math.SQRT2, -1]);
    close(bounds.max, [3 + Math.SQRT2, 2, 1]);
  });

  test('of instances, few and many', () => {
    const at = (i: number) => [1, 0, 0, i, 0, 1, 0, 0, 0, 0, 1, 0];
    for (const count of [2, 100]) {
      const instances = Float32Array.from(Array.from({ length: count }, (_, i) => at(i)).flat());
      const bounds = boundsAt(sceneOf({ a: mesh({ instances }) }), 0)!;
      close(bounds.max, [count, 1, 0]);
    }
  });

  test('of skins and morphs at the time', () => {
    const data: Mesh = {
      ...TRIANGLE,
      skin: {
        joints: new Uint16Array(16),
        weights: Float32Array.from({ length: 16 }, (_, i) => (i % 4 === 0 ? 1 : 0)),
      },
      morphTargets: [{ positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0) }],
    };
    const scene = sceneOf({ a: mesh({ skin: 's', node: 'body' }) }, data, {
      nodes: { body: { translation: [9, 9, 9], weights: [0] }, joint: { translation: [0, 0, 0] } },
      skins: { s: { joints: ['joint'] } },
      clips: {
        c: {
          duration: 2,
          tracks: [
            {
              target: '/nodes/joint/translation',
              interpolation: 'linear',
              times: Float32Array.of(0, 2),
              values: Float32Array.of(0, 0, 0, 0, 10, 0),
            },
            {
              target: '/nodes/body/weights',
              interpolation: 'linear',
              times: Float32Array.of(0, 2),
              values: Float32Array.of(0, 1),
            },
          ],
        },
      },
      clip: 'c',
    });
    close(boundsAt(scene, 0)!.max, [1, 1, 0]);
    const later = boundsAt(scene, 1)!;
    close(later.min, [0, 5, 0]);
    close(later.max, [1.5, 6, 0]);
  });
});

describe('framing', () => {
  test.each([1, 1e-3, 1e4])('everything lies in the picture, and nearly fills it, size %d', (size) => {
    const center: Vec3 = [3 * size, -size, 7 * size];
    const scene = testScene({ ball: { type: 'sphere', center, radius: size, material: 'white' } }, {});
    const camera = frameScene(scene)!;
    expect(camera.target).toEqual(center);
    const { forward, up } = cameraAxes(camera);
    // The corners of the ball's box lie on a ball of √3 radii.
    const distance = dot(subtract(center, camera.eye), forward);
    const halfAngle = Math.asin((Math.sqrt(3) * size) / distance);
    expect((2 * halfAngle * 180) / Math.PI / camera.verticalFov).toBeCloseTo(1 / 1.05, 2);
    expect(up[1]).toBeCloseTo(Math.cos((15 * Math.PI) / 180), 6);
    expect(forward[2]).toBeLessThan(0);
  });

  test('nothing to see has no camera; a point has one', () => {
    expect(frameScene(testScene({}, {}))).toBeNull();
    const dot1: Mesh = { positions: Float32Array.of(5, 5, 5, 5, 5, 5, 5, 5, 5), indices: Uint32Array.of(0, 1, 2) };
    const camera = frameScene(sceneOf({ a: mesh() }, dot1))!;
    expect(subtract(camera.target, camera.eye).some((c) => c !== 0)).toBe(true);
  });
});

test('the studio is an environment that can be used, the same each time', () => {
  const map = studioEnvironment();
  expect(environmentFault(map)).toBeNull();
  expect(studioEnvironment().data).toEqual(map.data);
});

test.each([0, 1e8, 9.99e8, 1e9, -1e9])('a ball about %d stays in sight of an eye that a scene may have', (place) => {
  for (const radius of [1e-4, 1, 1e6, 1e9]) {
    const target = [place, place, place] as const;
    const { eye } = cameraAround(target, radius);
    for (const x of eye) expect(Math.abs(x)).toBeLessThanOrEqual(1e9);
    const distance = Math.hypot(...eye.map((x, k) => x - target[k]!));
    expect(distance).toBeGreaterThan(Math.min(0.1 * radius, 1e7));
  }
});
