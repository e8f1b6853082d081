import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { determinant, invertAffine, multiplyAffine, toQuaternion, transformPoint } from './affine.ts';
import { sceneAt } from './animation.ts';
import { nodeTransforms, worldOf } from './node-transforms.ts';
import { inOrder, type SampledTrack, type SceneNode } from './nodes.ts';
import type { Scene, Vec3 } from './scene.ts';

const sceneOf = (nodes: Record<string, SceneNode>, rest: Partial<Scene> = {}): Scene =>
  testScene({}, {}, { nodes, ...rest });
const pointAt = (scene: Scene, time: number, node: string, point: Vec3): Vec3 => {
  const transforms = nodeTransforms(scene);
  return transformPoint(worldOf(transforms, transforms.at(time), node), 0, point);
};
const close = (found: ArrayLike<number>, wanted: readonly number[]): void =>
  wanted.forEach((value, i) => {
    expect(found[i]).toBeCloseTo(value, 10);
  });
/** A quarter turn about an axis. */
const quarter = (axis: Vec3) => toQuaternion(axis[0], axis[1], axis[2], 1);

describe('world matrices', () => {
  test('scale comes first, then the turn, then the translation; parents after that', () => {
    const scene = sceneOf({
      arm: { parent: 'base', translation: [1, 0, 0], rotation: quarter([0, 0, 1]), scale: [2, 3, 4] },
      base: { translation: [0, 10, 0], scale: [2, 2, 2] },
    });
    // (1, 1, 1) scaled is (2, 3, 4), turned about Z it is (−3, 2, 4), moved (−2, 2, 4), by the base doubled and lifted.
    close(pointAt(scene, 0, 'arm', [1, 1, 1]), [-4, 14, 8]);
  });

  test('a matrix stands for itself, shear and all', () => {
    const scene = sceneOf({
      sheared: { matrix: [1, 2, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7] },
      on: { parent: 'sheared', translation: [0, 1, 0] },
    });
    close(pointAt(scene, 0, 'on', [1, 1, 1]), [1 + 4 + 5, 2 + 6, 8]);
  });

  test('negative scales mirror: two of them in a line of nodes take that back', () => {
    const scene = sceneOf({ a: { scale: [-1, 1, 1] }, b: { parent: 'a', scale: [1, 1, -2] } });
    const transforms = nodeTransforms(scene);
    const world = transforms.at(0);
    expect(determinant(worldOf(transforms, world, 'a'))).toBe(-1);
    expect(determinant(worldOf(transforms, world, 'b'))).toBe(2);
    close(pointAt(scene, 0, 'b', [1, 1, 1]), [-1, 1, -2]);
  });

  test('equals matrices multiplied along the line of parents, seed 11', () => {
    const random = seededRandom(11);
    const r = (): number => random() * 4 - 2;
    const names = Array.from({ length: 60 }, (_, i) => `n${i}`);
    const nodes = Object.fromEntries(
      names.map((name, i): [string, SceneNode] => {
        const parent = i > 0 && random() < 0.9 ? names[Math.floor(random() * i)] : undefined;
        return [
          name,
          { parent, translation: [r(), r(), r()], rotation: toQuaternion(r(), r(), r(), r()), scale: [r(), r(), r()] },
        ];
      }),
    );
    // The order in which nodes stand in the scene does not matter.
    const shuffled = Object.fromEntries(Object.entries(nodes).reverse());
    const rotated = ([x, y, z, w]: readonly number[], v: Vec3): Vec3 => {
      const u = [x!, y!, z!] as const;
      const cross = (a: readonly number[], b: readonly number[]) => [a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!]; // biome-ignore format: one formula
      const t = cross(u, v).map((c) => 2 * c);
      return v.map((c, i) => c + w! * t[i]! + cross(u, t)[i]!) as unknown as Vec3;
    };
    const place = (name: string | undefined, p: Vec3): Vec3 => {
      if (name === undefined) return p;
      const { parent, translation, rotation, scale } = nodes[name]!;
      const turned = rotated(rotation!, p.map((c, i) => c * scale![i]!) as unknown as Vec3);
      return place(parent, turned.map((c, i) => c + translation![i]!) as unknown as Vec3);
    };
    for (const name of names) {
      const wanted = place(name, [0.3, -0.7, 1.1]);
      const found = pointAt(sceneOf(shuffled), 0, name, [0.3, -0.7, 1.1]);
      for (let i = 0; i < 3; i++) expect(found[i]).toBeCloseTo(wanted[i]!, 6);
    }
  });

  test('an inverse takes back; a flat map has none', () => {
    const m = [1, 2, 0, 5, 0, -3, 1, 6, 2, 0, 1, 7];
    const product = new Float64Array(12);
    multiplyAffine(product, 0, m, 0, invertAffine(m)!, 0);
    close(product, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);
    expect(invertAffine([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0])).toBeNull();
  });
});

describe('motion of nodes', () => {
  const track = (
    target: string,
    interpolation: SampledTrack['interpolation'],
    times: number[],
    values: number[],
  ): SampledTrack => ({
    target,
    interpolation,
    times: Float32Array.from(times),
    values: Float32Array.from(values),
  });
  const moving = (...tracks: SampledTrack[]): Scene =>
    sceneOf(
      {
        a: { translation: [0, 0, 0], rotation: [0, 0, 0, 1], scale: [1, 1, 1] },
        b: { parent: 'a', translation: [1, 0, 0] },
        still: {},
      },
      { clips: { walk: { duration: 2, tracks } }, clip: 'walk' },
    );

  test('turns go along the shorter arc at an even speed', () => {
    const s = Math.SQRT1_2;
    const scene = moving(track('/nodes/a/rotation', 'linear', [0, 2], [0, 0, 0, 1, 0, 0, -s, -s]));
    // The second key is a quarter turn, written with the other sign.
    for (const [time, degrees] of [
      [0, 0],
      [0.5, 22.5],
      [1, 45],
      [1.5, 67.5],
    ] as const) {
      // biome-ignore format: pairs
      const angle = (degrees * Math.PI) / 180;
      const found = pointAt(scene, time, 'b', [0, 0, 0]);
      expect(found[0]).toBeCloseTo(Math.cos(angle), 6);
      expect(found[1]).toBeCloseTo(Math.sin(angle), 6);
    }
  });

  test('step holds, cubic follows its slopes, and before and after the keys the value stays', () => {
    const step = moving(track('/nodes/a/translation', 'step', [0.5, 1], [1, 0, 0, 5, 0, 0]));
    expect([0, 0.7, 0.99, 1, 1.7].map((time) => pointAt(step, time, 'a', [0, 0, 0])[0])).toEqual([1, 1, 1, 5, 5]);
    // Hermite's curve through x = t² at 0 and 1 with its own slopes is that parabola.
    const cubic = moving(
      track('/nodes/a/translation', 'cubic', [0, 1], [0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 0]),
    );
    for (const time of [0, 0.25, 0.5, 0.75, 1])
      expect(pointAt(cubic, time, 'a', [0, 0, 0])[0]).toBeCloseTo(time ** 2, 6);
  });

  test('a clip repeats after its duration, whatever the last key', () => {
    const scene = moving(track('/nodes/a/translation', 'linear', [0, 1], [0, 0, 0, 1, 0, 0]));
    expect([0.5, 1.5, 2.5, -1.5].map((time) => pointAt(scene, time, 'a', [0, 0, 0])[0])).toEqual([0.5, 1, 0.5, 0.5]);
  });

  test('sceneAt has the same places, what does not move is shared, and only what is carried moves', () => {
    const scene = moving(
      track('/nodes/a/translation', 'linear', [0, 2], [0, 0, 0, 4, 2, 0]),
      track('/nodes/a/rotation', 'linear', [0, 2], [0, 0, 0, 1, 0, 1, 0, 0]),
      track('/nodes/a/scale', 'linear', [0, 2], [1, 1, 1, 3, 3, 3]),
    );
    const now = sceneAt(scene, 1);
    expect(now.nodes!.a!.translation).toEqual([2, 1, 0]);
    expect(now.nodes!.still).toBe(scene.nodes!.still);
    const { clip: _, clips: __, ...frozen } = now;
    close(pointAt(frozen, 0, 'b', [1, 2, 3]), [...pointAt(scene, 1, 'b', [1, 2, 3])]);
    const transforms = nodeTransforms(scene);
    expect([...transforms.moving].map((i) => transforms.names[i])).toEqual(['a', 'b']);
  });

  test('writes into the array that it is given, and the same for the same time', () => {
    const scene = moving(track('/nodes/a/translation', 'linear', [0, 2], [0, 0, 0, 4, 2, 0]));
    const transforms = nodeTransforms(scene);
    const out = new Float64Array(36);
    expect(transforms.at(1.3, out)).toBe(out);
    transforms.at(0.2);
    expect(transforms.at(1.3)).toEqual(out);
  });

  test('tracks of the scene move nodes too; a clip that is not there is a mistake', () => {
    const keys = [{ time: 0, value: 0 }, { time: 1, value: 2 }] as const; // biome-ignore format: short
    const scene = sceneOf(
      { a: { translation: [0, 0, 0] } },
      { animation: [{ target: '/nodes/a/translation/1', interpolation: 'linear', repeat: 'once', keys }] },
    );
    close(pointAt(scene, 0.5, 'a', [0, 0, 0]), [0, 1, 0]);
    expect(sceneAt(scene, 0.5).nodes!.a!.translation).toEqual([0, 1, 0]);
    expect(() => nodeTransforms(sceneOf({}, { clip: 'run' }))).toThrow('no clip "run"');
  });

  test('groups of materials and lists of weights move', () => {
    const scene = moving(
      track('/nodes/a/weights', 'linear', [0, 2], [0, 1, 1, 0]),
      track('/materials/m/clearcoat/weight', 'linear', [0, 2], [0, 1]),
    );
    const whole = {
      ...scene,
      nodes: { ...scene.nodes, a: { weights: [0, 0] } },
      materials: { m: { ...scene.materials.white!, clearcoat: { weight: 0, roughness: 0.3 } } },
    };
    const now = sceneAt(whole, 0.5);
    expect(now.nodes!.a!.weights).toEqual([0.25, 0.75]);
    expect(now.materials.m!.clearcoat).toEqual({ weight: 0.25, roughness: 0.3 });
    expect(() => sceneAt(moving(track('/nodes/nobody/weights', 'step', [0], [1])), 0)).toThrow('moves nothing');
  });
});

describe('what may not be', () => {
  test('rings and strangers are told by name, and leave the others in order', () => {
    const { order, faults } = inOrder({
      a: { parent: 'c' },
      b: { parent: 'a' },
      c: { parent: 'b' },
      d: { parent: 'c' },
      self: { parent: 'self' },
      lost: { parent: 'nobody' },
      child: { parent: 'good' },
      good: {},
    });
    expect(order).toEqual(['good', 'child']);
    expect(faults).toEqual([
      { node: 'a', fault: 'cycle' },
      { node: 'self', fault: 'cycle' },
      { node: 'lost', fault: 'parent' },
    ]);
    expect(() => nodeTransforms(sceneOf({ a: { parent: 'b' }, b: { parent: 'a' } }))).toThrow('carries itself');
    expect(() => nodeTransforms(sceneOf({ a: { parent: 'b' } }))).toThrow('does not have');
  });

  test('a line of a hundred thousand nodes takes no stack', () => {
    const nodes: Record<string, SceneNode> = {};
    for (let i = 99_999; i >= 0; i--)
      nodes[`n${i}`] = { ...(i > 0 && { parent: `n${i - 1}` }), translation: [1, 0, 0] };
    expect(pointAt(sceneOf(nodes), 0, 'n99999', [0, 0, 0])[0]).toBe(100_000);
  });

  test('a time that is no number', () => {
    expect(() => nodeTransforms(sceneOf({ a: {} })).at(Number.NaN)).toThrow(RangeError);
  });
});
