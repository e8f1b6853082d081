import { describe, expect, test } from 'vitest';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import { cameraAxes } from './camera.ts';
import { frameOf, frameScene } from './framing.ts';
import type { Mesh } from './mesh.ts';
import { roomLights } from './model-view.ts';
import type { Light, Material, MeshShape, Scene, SphereLight, Vec3 } from './scene.ts';
import { boundsAt } from './scene-bounds.ts';
import { dot, length, subtract } from './vec3.ts';

/** The twelve triangles of a box, in two kinds: turned outwards, as a body has them, or inwards, as painted on the walls of a room. */
function box(inwards: boolean, without: readonly number[] = []): Mesh {
  const positions = Float32Array.from({ length: 24 }, (_, i) => ((Math.floor(i / 3) >> (i % 3)) & 1) - 0.5);
  const sides = [0, 1, 2].flatMap((axis) => [0, 1].map((side) => ({ axis, side })));
  const indices = sides
    .filter((_, i) => !without.includes(i))
    .flatMap(({ axis, side }) => {
      const [u, v] = [1 << ((axis + 1) % 3), 1 << ((axis + 2) % 3)];
      const a = side << axis;
      const corners = [a, a + u, a + u + v, a, a + u + v, a + v];
      return (side === 1) === inwards ? corners.reverse() : corners;
    });
  return { positions, indices: Uint32Array.from(indices) };
}

/** A ball, turned outwards; inwards it is a dome. */
function ball(inwards = false, rows = 12): Mesh {
  const place = (i: number, j: number): number[] => {
    const [phi, theta] = [(Math.PI * i) / rows, (Math.PI * j) / rows];
    return [Math.sin(theta) * Math.sin(phi), Math.cos(theta), Math.sin(theta) * Math.cos(phi)].map((x) => x / 2);
  };
  const columns = 2 * rows;
  const positions = Float32Array.from(Array.from({ length: (columns + 1) * (rows + 1) }, (_, k) => place(k % (columns + 1), Math.floor(k / (columns + 1)))).flat()); // biome-ignore format: one list
  const indices: number[] = [];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const a = j * (columns + 1) + i;
      const [b, c, d] = [a + 1, a + columns + 1, a + columns + 2];
      indices.push(...(inwards ? [a, b, c, b, d, c] : [a, c, b, b, c, d]));
    }
  return { positions, indices: Uint32Array.from(indices) };
}

const shape = (mesh: string, scale: Vec3, translation: Vec3 = [0, 0, 0], material = 'white'): MeshShape => ({ type: 'mesh', mesh, material, translation, rotation: [0, 0, 0], scale }); // biome-ignore format: one line
const MESHES: Record<string, Mesh> = {
  in: box(true),
  out: box(false),
  court: box(true, [3]),
  stage: box(true, [5]),
  ball: ball(),
  dome: ball(true),
};
const single = testMaterial({ doubleSided: false });
const glass = testMaterial({ transmission: { weight: 1 } } as Partial<Material>);
const sceneOf = (shapes: Record<string, MeshShape>, lights: Record<string, Light> = {}): Scene =>
  testScene(shapes as unknown as Scene['shapes'] as never, lights, {
    materials: { white: testMaterial(), single, glass },
    meshes: Object.fromEntries(Object.entries(MESHES).map(([name, data]) => [name, { data }])),
  });

const SIZE: Vec3 = [6, 3, 8];
const things = {
  chair: shape('out', [0.6, 1, 0.6], [1, -1, -1]),
  vase: shape('ball', [0.5, 0.5, 0.5], [-1.5, -1.2, 0.5]),
};
/** Walls of a tenth of a metre, each a body of its own. */
const slabs = Object.fromEntries(
  [0, 1, 2].flatMap((axis) =>
    [-1, 1].map((side) => {
      const size = SIZE.map((x, k) => (k === axis ? 0.1 : x)) as unknown as Vec3;
      const place = SIZE.map((x, k) => (k === axis ? (side * (x - 0.1)) / 2 : 0)) as unknown as Vec3;
      return [`wall ${axis} ${side}`, shape('out', size, place, 'single')] as const;
    }),
  ),
);
const lamp = testLight({ center: [0, 1.2, 0] });

describe('seen from within', () => {
  test.each([
    ['walls of one side, turned inwards', sceneOf({ walls: shape('in', SIZE, [0, 0, 0], 'single'), ...things })],
    ['walls of two sides', sceneOf({ walls: shape('in', SIZE), ...things })],
    ['walls of two sides, wound outwards', sceneOf({ walls: shape('out', SIZE), ...things })],
    ['walls in a mirror image', sceneOf({ walls: shape('in', [-6, 3, 8], [0, 0, 0], 'single'), ...things })],
    ['walls with a thickness', sceneOf({ ...slabs, ...things })],
    ['an empty room with a lamp', sceneOf({ walls: shape('in', SIZE) }, { lamp })],
    [
      'a room in a dome far from the origin',
      sceneOf({ dome: shape('dome', [60, 60, 60], [1e6, 0, 0]), chair: shape('out', [3, 15, 3], [1e6 + 9, -18, 2]) }),
    ],
    ['a court that is open above', sceneOf({ walls: shape('court', [6, 12, 8]), ...things })],
  ])('%s', (_, scene) => {
    const camera = frameScene(scene)!;
    const { min, max } = boundsAt(scene, 0)!;
    for (const place of [camera.eye, camera.target])
      place.forEach((x, k) => {
        expect(x).toBeGreaterThan(min[k]! + 0.02 * (max[k]! - min[k]!));
        expect(x).toBeLessThan(max[k]! - 0.02 * (max[k]! - min[k]!));
      });
    expect(camera.verticalFov).toBe(60);
    // It stands back, and level.
    expect(length(subtract(camera.target, camera.eye))).toBeGreaterThan(0.2 * (max[0] - min[0]));
    expect(cameraAxes(camera).forward[1]).toBeCloseTo(0, 9);
    expect(frameScene(scene)).toEqual(camera);
  });

  test('nothing stands between the eye and the middle', () => {
    const scene = sceneOf({ walls: shape('in', SIZE), pillar: shape('out', [0.5, 3, 0.5], [0, 0, 1.5]), ...things });
    const { eye, target } = frameScene(scene)!;
    // The pillar is a column about (0, 1.5): its middle is farther from the line of sight than its half diagonal.
    const [dx, dz] = [target[0] - eye[0], target[2] - eye[2]];
    const share = Math.min(Math.max((-eye[0] * dx + (1.5 - eye[2]) * dz) / (dx * dx + dz * dz), 0), 1);
    expect(Math.hypot(eye[0] + share * dx, eye[2] + share * dz - 1.5)).toBeGreaterThan(0.25 * Math.SQRT2);
  });
});

describe('seen from outside', () => {
  test.each([
    ['a ball', sceneOf({ ball: shape('ball', [2, 2, 2]) })],
    ['a box', sceneOf({ box: shape('out', [2, 2, 2]) })],
    ['a box of one side', sceneOf({ box: shape('out', [2, 2, 2], [0, 0, 0], 'single') })],
    ['a box that its file has inside out', sceneOf({ box: shape('in', [2, 2, 2]) })],
    ['a ball that its file has inside out', sceneOf({ ball: shape('dome', [2, 2, 2]) })],
    ['a hollow ball with a thick wall', sceneOf({ a: shape('ball', [2, 2, 2]), b: shape('dome', [1.8, 1.8, 1.8]) })],
    [
      'a head with an eye in it',
      sceneOf({ head: shape('ball', [2, 2, 2]), eye: shape('ball', [0.4, 0.4, 0.4], [0.4, 0.3, 0.5]) }),
    ],
    ['a crate of one side with things in it', sceneOf({ crate: shape('out', SIZE, [0, 0, 0], 'single'), ...things })],
    ['a stage, open to the viewer', sceneOf({ walls: shape('stage', SIZE), ...things })],
    ['a show case of glass', sceneOf({ walls: shape('out', SIZE, [0, 0, 0], 'glass'), ...things })],
    ['two boxes', sceneOf(things)],
  ])('%s', (_, scene) => {
    const camera = frameScene(scene)!;
    const { min, max } = boundsAt(scene, 0)!;
    expect(camera.eye.some((x, k) => x < min[k]! || x > max[k]!)).toBe(true);
    const { forward, up } = cameraAxes(camera);
    expect(Math.hypot(dot(forward, [0, 0, 1]), dot(up, [0, 0, 1]))).toBeCloseTo(1, 9);
  });
});

test('a room without windows gets a lamp in it, of a radiance by its size; what has light from outside gets none', () => {
  const rooms = [0.01, 1, 100].map((size) => {
    const grown = (shapes: Record<string, MeshShape>) =>
      Object.fromEntries(Object.entries(shapes).map(([name, { scale, translation, ...rest }]) => [name, { ...rest, scale: scale.map((x) => x * size), translation: translation.map((x) => x * size) } as unknown as MeshShape])); // biome-ignore format: one line
    return frameOf(sceneOf(grown({ walls: shape('in', SIZE), ...things })))!.room!;
  });
  for (const [k, size] of [0.01, 1, 100].entries()) {
    const lamp = roomLights(rooms[k]!)['room lamp'] as SphereLight;
    // As white that faces it at the mean distance of the walls sends it back.
    expect((lamp.radiance * lamp.radius ** 2) / rooms[k]!.reach ** 2).toBeCloseTo(0.3, 9);
    expect(rooms[k]!.reach / size).toBeGreaterThan(1.5);
    expect(rooms[k]!.reach / size).toBeLessThan(5);
    lamp.center.forEach((x, axis) => {
      expect(Math.abs(x)).toBeLessThan(0.45 * size * SIZE[axis]!);
    });
  }
  const court = frameOf(sceneOf({ walls: shape('court', [6, 12, 8]), ...things }))!.room;
  expect(court).not.toBeNull();
  expect(roomLights(court)).toEqual({});
  expect(roomLights(null)).toEqual({});
});
