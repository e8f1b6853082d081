import { describe, expect, test } from 'vitest';
import { goodScene } from '../scene-file/broken/good-scene.ts';
import { parseScene } from '../scene-file/parse-scene.ts';
import { compileAnimation, sceneAt } from './animation.ts';
import type { DirectionalLight, MeshShape, Plane, Quad, QuadLight, Scene, Sphere, Vec3 } from './scene.ts';
import { cameraFault } from './well-formed.ts';

function sceneWith(...animation: unknown[]): Scene {
  const parsed = parseScene({ ...goodScene(), animation });
  if (!parsed.ok) throw new Error(parsed.problems.map(({ message }) => message).join('\n'));
  return parsed.scene;
}
const between = (target: string, from: unknown, to: unknown) => ({
  target,
  keys: [
    { time: 0, value: from },
    { time: 2, value: to },
  ],
});

describe('sceneAt', () => {
  test('a scene without tracks is itself', () => {
    const scene = sceneWith();
    expect(sceneAt(scene, 12)).toBe(scene);
  });

  test('moves a triple, a number, one number of a triple, the sky, a light, a material', () => {
    const scene = sceneWith(
      between('/shapes/ball/center', [0, 1, 0], [4, 1, 0]),
      between('/shapes/ball/radius', 1, 2),
      between('/camera/eye/1', 1, 3),
      between('/sky/zenith', [0, 0, 0], [1, 1, 1]),
      between('/lights/lamp/radiance', 0, 10),
      between('/materials/clay/roughness', 0, 1),
    );
    const moved = sceneAt(scene, 1);
    expect(moved.shapes.ball).toEqual({ type: 'sphere', center: [2, 1, 0], radius: 1.5, material: 'clay' });
    expect(moved.camera.eye).toEqual([0, 2, 5]);
    expect(moved.sky.zenith).toEqual([0.5, 0.5, 0.5]);
    expect(moved.lights.lamp).toMatchObject({ radiance: 5 });
    expect(moved.materials.clay?.roughness).toBe(0.5);
  });

  test('two numbers of one triple move on their own', () => {
    const scene = sceneWith(between('/shapes/ball/center/0', 0, 4), between('/shapes/ball/center/2', 0, -4));
    expect((sceneAt(scene, 1).shapes.ball as Sphere).center).toEqual([2, 1, -2]);
  });

  test('shares what does not move, keeps the order of names, and leaves the scene alone', () => {
    const scene = sceneWith(between('/shapes/block/center', [0, 0, 0], [1, 1, 1]));
    const before = JSON.stringify(scene);
    const moved = sceneAt(scene, 1);
    expect(moved.shapes.ball).toBe(scene.shapes.ball);
    expect(moved.materials).toBe(scene.materials);
    expect(moved.camera).toBe(scene.camera);
    expect(Object.keys(moved.shapes)).toEqual(Object.keys(scene.shapes));
    expect(JSON.stringify(scene)).toBe(before);
  });

  test('gives the same for the same time, whatever was asked before', () => {
    const scene = sceneWith(between('/shapes/ball/center', [0, 1, 0], [4, 1, 0]));
    const first = sceneAt(scene, 0.7);
    sceneAt(scene, -3e7);
    expect(sceneAt(scene, 0.7)).toEqual(first);
    expect(compileAnimation(scene)(0.7)).toEqual(first);
  });

  test('refuses a time that is no time, and a track that moves nothing', () => {
    const scene = sceneWith(between('/shapes/ball/radius', 1, 2));
    expect(() => sceneAt(scene, Number.NaN)).toThrow(RangeError);
    expect(() => sceneAt(scene, Number.POSITIVE_INFINITY)).toThrow(RangeError);
    const lost = { ...scene, animation: [{ ...scene.animation[0]!, target: '/shapes/none/radius' }] };
    expect(() => sceneAt(lost, 0)).toThrow('/shapes/none/radius');
  });
});

describe('a moment between good keys that would be impossible is mended', () => {
  test('an eye that goes through its target', () => {
    const scene = sceneWith(between('/camera/eye', [0, 1, 5], [0, 1, -5]));
    const { camera } = sceneAt(scene, 1);
    expect(camera.eye).toEqual([0, 1, 0]);
    expect(camera.target).toEqual([0, 1, -1]);
  });
  test('a view that swings through up', () => {
    const scene = sceneWith(between('/camera/target', [1, 4, 5], [-1, 4, 5]));
    expect(cameraFault(sceneAt(scene, 1).camera)).toBeNull();
  });
  test('an up that turns over', () => {
    const scene = sceneWith(between('/camera/up', [0, 1, 0], [0, -1, 0]));
    expect(sceneAt(scene, 1).camera.up).toEqual([0, 1, 0]);
  });
  test('a normal that goes through zero, and a quad that closes', () => {
    const scene = sceneWith(
      between('/shapes/floor/normal', [0, 1, 0], [0, -1, 0]),
      between('/shapes/panel/v', [0, 1, 0], [0, -1, 0]),
    );
    const { floor, panel } = sceneAt(scene, 1).shapes;
    expect((floor as Plane).normal).toEqual([0, 1, 0] satisfies Vec3);
    expect((panel as Quad).v).toEqual([0, 1, 0] satisfies Vec3);
  });
  test('a mesh that is turned inside out', () => {
    const scene = sceneWith(between('/shapes/stone/scale', [1, 1, 1], [-1, 1, 1]));
    expect((sceneAt(scene, 1).shapes.stone as MeshShape).scale).toEqual([1e-6, 1, 1] satisfies Vec3);
    expect((sceneAt(scene, 1 + 1e-9).shapes.stone as MeshShape).scale).toEqual([-1e-6, 1, 1] satisfies Vec3);
    expect((sceneAt(scene, 1.5).shapes.stone as MeshShape).scale).toEqual([-0.5, 1, 1] satisfies Vec3);
  });
  test('a sun that turns over, and a quad light that closes', () => {
    const lights = {
      sun: { type: 'directional', direction: [0, -1, 0], irradiance: 1 },
      panel: { type: 'quad', corner: [0, 3, 0], u: [1, 0, 0], v: [0, 0, 1], radiance: 1 },
    };
    const animation = [
      between('/lights/sun/direction', [0, -1, 0], [0, 1, 0]),
      between('/lights/panel/u', [1, 0, 0], [-1, 0, 0]),
    ];
    const parsed = parseScene({ ...goodScene(), lights, animation });
    if (!parsed.ok) throw new Error(parsed.problems[0]?.message);
    const { sun, panel } = sceneAt(parsed.scene, 1).lights;
    expect((sun as DirectionalLight).direction).toEqual([0, -1, 0] satisfies Vec3);
    expect((panel as QuadLight).u).toEqual([1, 0, 0] satisfies Vec3);
  });
});
