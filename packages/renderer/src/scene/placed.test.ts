import { describe, expect, test } from 'vitest';
import { testLight, testScene } from '../../../../tests/fixtures/scenes.ts';
import { toQuaternion, transformPoint } from './affine.ts';
import type { SceneNode } from './nodes.ts';
import { anglesOf, meshMatrices, placedSceneAt, placementOf } from './placed.ts';
import type { Box, Camera, MeshShape, Plane, Quad, Scene, Shape, SphereLight, Vec3 } from './scene.ts';
import { rotate } from './vec3.ts';

const NODE: SceneNode = { translation: [1, 2, 3], rotation: toQuaternion(0, 1, 0, 1), scale: [2, 2, 2] };
/** What the node does: doubled, turned a quarter about Y, moved. */
const there = ([x, y, z]: Vec3): Vec3 => [1 + 2 * z, 2 + 2 * y, 3 - 2 * x];
const mesh = (part: Partial<MeshShape> = {}): MeshShape => ({ type: 'mesh', mesh: 'm', material: 'white', translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1], ...part }); // biome-ignore format: short
const placed = (shapes: Record<string, Shape | MeshShape>, rest: Partial<Scene> = {}): Scene =>
  placedSceneAt({ ...testScene(shapes as Record<string, Shape>, {}), nodes: { n: NODE }, ...rest }, 0);
const close = (found: ArrayLike<number>, wanted: readonly number[]): void =>
  wanted.forEach((value, i) => {
    expect(found[i]).toBeCloseTo(value, 9);
  });

describe('things that a node carries', () => {
  test('the camera and its up', () => {
    const camera: Camera = { eye: [0, 0, 0], target: [0, 0, -1], up: [0, 1, 0], verticalFov: 40, node: 'n' };
    const now = placed({}, { camera, cameras: { other: camera } }).camera;
    close(now.eye, there([0, 0, 0]));
    close(now.target, there([0, 0, -1]));
    close(now.up, [0, 2, 0]);
    expect(now.node).toBeUndefined();
  });

  test('lights: places, directions and sizes', () => {
    const lights = {
      ball: testLight({ center: [1, 0, 0], radius: 0.5, node: 'n' }),
      free: testLight(),
      spot: {
        type: 'spot',
        position: [0, 0, 0],
        direction: [0, 0, -1],
        intensity: 1,
        color: [1, 1, 1],
        innerAngle: 0,
        outerAngle: 45,
        node: 'n',
      },
    } as const;
    const now = placed({}, { lights }).lights;
    close((now.ball as SphereLight).center, there([1, 0, 0]));
    expect((now.ball as SphereLight).radius).toBeCloseTo(1, 12);
    expect(now.free).toBe(lights.free);
    close((now.spot as typeof lights.spot).direction, [-2, 0, 0]);
  });

  test('spheres, boxes, quads and planes', () => {
    const now = placed({
      ball: { type: 'sphere', center: [0, 1, 0], radius: 1, material: 'white', node: 'n' },
      box: { type: 'box', center: [1, 0, 0], size: [1, 2, 3], rotation: [10, 20, 30], material: 'white', node: 'n' },
      quad: { type: 'quad', corner: [0, 0, 0], u: [1, 0, 0], v: [0, 1, 0], material: 'white', node: 'n' },
      plane: { type: 'plane', point: [1, 0, 0], normal: [1, 0, 0], material: 'white', node: 'n' },
    }).shapes;
    expect(now.ball).toMatchObject({ radius: 2 });
    const box = now.box as Box;
    close(box.size, [2, 4, 6]);
    for (const corner of [
      [0.5, 1, 1.5],
      [-0.5, 1, 0],
    ] as const) {
      // biome-ignore format: short
      const before = rotate(corner, [10, 20, 30]);
      const after = rotate([2 * corner[0], 2 * corner[1], 2 * corner[2]], box.rotation);
      close(
        after.map((c, i) => c + box.center[i]!),
        there([before[0] + 1, before[1], before[2]]),
      );
    }
    close((now.quad as Quad).u, [0, 0, -2]);
    close((now.plane as Plane).normal, [0, 0, -1]);
  });

  test('a sphere is not stretched and a box not sheared: that is an error with its name', () => {
    const ball: Shape = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white', node: 'n' };
    expect(() => placed({ ball }, { nodes: { n: { scale: [1, 2, 1] } } })).toThrow('"ball" would stretch');
    const box: Shape = {
      type: 'box',
      center: [0, 0, 0],
      size: [1, 1, 1],
      rotation: [0, 0, 45],
      material: 'white',
      node: 'n',
    };
    expect(() => placed({ box }, { nodes: { n: { scale: [1, 2, 1] } } })).toThrow('"box" would shear');
    const straight: Shape = { ...box, rotation: [0, 90, 0] };
    close((placed({ box: straight }, { nodes: { n: { scale: [1, -2, 3] } } }).shapes.box as Box).size, [3, 2, 1]);
  });

  test('a scene without nodes is as sceneAt gives it', () => {
    const scene = testScene({}, {});
    expect(placedSceneAt(scene, 3)).toBe(scene);
  });
});

describe('meshes', () => {
  test('matrix, then scale, turn and translation, then the node', () => {
    const shape = mesh({
      matrix: [1, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1],
      scale: [2, 1, 1],
      rotation: [0, 0, 90],
      translation: [0, 0, 7],
      node: 'n',
    });
    close(transformPoint(placementOf(shape), 0, [1, 0, 0]), [0, 12, 7]);
    const now = placed({ shape }).shapes.shape as unknown as MeshShape;
    expect(now.node).toBeUndefined();
    close(transformPoint(now.matrix!, 0, [1, 0, 0]), there([0, 12, 7]));
  });

  test('instances stand between the node and the mesh', () => {
    const instances = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 10, 0, 2, 0, 0, 0, 0, 2, 0);
    const shape = mesh({ translation: [1, 0, 0], instances, node: 'n' });
    const now = placed({ shape }).shapes.shape as unknown as MeshShape;
    close(transformPoint(now.instances!, 0, [0, 0, 0]), there([1, 0, 0]));
    close(transformPoint(now.instances!, 12, [0, 0, 0]), there([12, 0, 0]));
    close(meshMatrices(now, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]), [...now.instances!]);
  });

  test('a skin leaves nothing to the node', () => {
    close(
      meshMatrices(mesh({ skin: 's', translation: [1, 1, 1] }), [2, 0, 0, 5, 0, 2, 0, 5, 0, 0, 2, 5]),
      [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0],
    );
  });
});

test('angles of a turn give the same turn, also where two axes meet', () => {
  for (const angles of [
    [10, 20, 30],
    [-170, 80, 5],
    [45, 90, 0],
    [30, -90, 0],
    [0, 0, 180],
  ] as const) {
    // biome-ignore format: short
    const [x, y, z] = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((axis) => rotate(axis, angles)) as [Vec3, Vec3, Vec3]; // biome-ignore format: short
    const found = anglesOf(x, y, z);
    for (const [axis, wanted] of [[[1, 0, 0], x], [[0, 1, 0], y], [[0, 0, 1], z]] as const) close(rotate(axis, found), [...wanted]); // biome-ignore format: short
  }
});
