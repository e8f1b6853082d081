import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { toQuaternion } from './affine.ts';
import { type Deformed, deform, isDeformable, jointMatrices, makeDeformed } from './deform.ts';
import type { Mesh } from './mesh.ts';
import { nodeTransforms } from './node-transforms.ts';
import { affineOf } from './placed.ts';

const f32 = (...values: number[]): Float32Array => Float32Array.from(values);
const bent = (mesh: Mesh, pose: Parameters<typeof deform>[1]): Deformed => {
  const out = makeDeformed(mesh);
  deform(mesh, pose, out);
  return out;
};
const close = (found: ArrayLike<number>, wanted: readonly number[], digits = 5): void =>
  wanted.forEach((value, i) => {
    expect(found[i]).toBeCloseTo(value, digits);
  });

const ONE: Mesh = {
  positions: f32(1, 0, 0, 0, 1, 0, 0, 0, 1),
  indices: Uint32Array.of(0, 1, 2),
  normals: f32(1, 0, 0, 0, 1, 0, 0, 0, 1),
  tangents: f32(0, 1, 0, 1, 0, 0, 1, -1, 1, 0, 0, 1),
};

describe('morph targets', () => {
  const mesh: Mesh = {
    ...ONE,
    morphTargets: [
      {
        positions: f32(1, 1, 1, 0, 0, 0, 0, 0, 0),
        normals: f32(0, 1, 0, 0, 0, 0, 0, 0, 0),
        tangents: f32(0, 0, 1, 0, 0, 0, 0, 0, 0),
      },
      { positions: f32(0, 0, 0, 2, 0, 0, 0, 0, 0) },
    ],
  };

  test('are added by their weights; normals and tangents keep length 1, and the handedness stays', () => {
    const s = Math.SQRT1_2;
    const out = bent(mesh, { weights: [1, 0.5] });
    close(out.positions, [2, 1, 1, 1, 1, 0, 0, 0, 1]);
    close(out.normals!, [s, s, 0, 0, 1, 0, 0, 0, 1]);
    close(out.tangents!, [0, s, s, 1, 0, 0, 1, -1, 1, 0, 0, 1]);
  });

  test('without weights nothing changes, and the mesh itself never does', () => {
    const before = mesh.positions.slice();
    expect(bent(mesh, {}).positions).toEqual(mesh.positions);
    bent(mesh, { weights: [3, 3] });
    expect(mesh.positions).toEqual(before);
  });
});

describe('skins', () => {
  const skinned = (joints: number[], weights: number[], mesh: Mesh = ONE): Mesh => ({ ...mesh, skin: { joints: Uint16Array.from(joints), weights: f32(...weights) } }); // biome-ignore format: short
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];

  test('a vertex goes with the mix of its joints', () => {
    const mesh = skinned([0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0], [0.5, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
    const lifted = [1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1, 0];
    close(bent(mesh, { joints: f32(...identity, ...lifted) }).positions, [1, 1, 0, 0, 3, 0, 0, 0, 1]);
  });

  test('eight joints a vertex', () => {
    const mesh = skinned(
      Array.from({ length: 24 }, (_, i) => i % 8),
      new Array(24).fill(1 / 8),
    );
    const joints = Array.from({ length: 8 }, (_, i) => [1, 0, 0, i, 0, 1, 0, 0, 0, 0, 1, 0]).flat();
    close(bent(mesh, { joints: f32(...joints) }).positions, [4.5, 0, 0, 3.5, 1, 0, 3.5, 0, 1]);
  });

  test('turned, moved and evenly scaled: normals and tangents turn along', () => {
    const mesh = skinned([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
    const out = bent(mesh, { joints: f32(...affineOf([5, 0, 0], toQuaternion(0, 0, 1, 1), [3, 3, 3])) });
    close(out.positions, [5, 3, 0, 2, 0, 0, 5, 0, 3]);
    close(out.normals!, [0, 1, 0, -1, 0, 0, 0, 0, 1]);
    close(out.tangents!, [-1, 0, 0, 1, 0, 0, 1, -1, 0, 1, 0, 1]);
  });

  test('stretched and mirrored: normals stay at right angles to the surface and outside, seed 12', () => {
    const random = seededRandom(12);
    const r = (): number => random() * 2 - 1;
    for (let round = 0; round < 20; round++) {
      const joint = affineOf([r(), r(), r()], toQuaternion(r(), r(), r(), r()), [r() * 3, r() + 1.5, r() + 1.5]);
      const normal = [r(), r(), r()];
      const length = Math.hypot(...normal);
      const unit = normal.map((c) => c / length);
      const mesh = skinned([0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0], [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0], {
        ...ONE,
        normals: f32(...unit, ...unit, ...unit),
      });
      const out = bent(mesh, { joints: f32(...joint) });
      const n = [...out.normals!.slice(0, 3)];
      expect(Math.hypot(...n)).toBeCloseTo(1, 5);
      // What lies in the surface before lies in it afterwards: v · n = 0 for v = M t, with t across the normal.
      const across = [unit[1]!, -unit[0]!, 0];
      const moved = [0, 4, 8].map((row) => joint[row]! * across[0]! + joint[row + 1]! * across[1]!);
      expect(Math.abs(moved[0]! * n[0]! + moved[1]! * n[1]! + moved[2]! * n[2]!)).toBeLessThan(1e-4);
      const out1 = [0, 4, 8].map(
        (row) => joint[row]! * unit[0]! + joint[row + 1]! * unit[1]! + joint[row + 2]! * unit[2]!,
      );
      expect(out1[0]! * n[0]! + out1[1]! * n[1]! + out1[2]! * n[2]!).toBeGreaterThan(0);
    }
  });

  test('joint matrices are world · inverse bind; in the pose of binding nothing changes', () => {
    const scene = testScene(
      {},
      {},
      {
        nodes: {
          hip: { translation: [0, 1, 0] },
          knee: { parent: 'hip', translation: [0, -1, 0], rotation: toQuaternion(0, 0, 1, 1) },
        },
      },
    );
    const transforms = nodeTransforms(scene);
    const world = transforms.at(0);
    const bind = f32(1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0);
    const skin = { joints: ['hip', 'knee'], inverseBindMatrices: bind };
    close(jointMatrices(skin, transforms, world), [...identity, ...identity]);
    close(jointMatrices({ joints: ['knee'] }, transforms, world), [0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0]);
    expect(() => jointMatrices({ joints: ['toe'] }, transforms, world)).toThrow('"toe"');
  });

  test('what can change its form', () => {
    expect([ONE, skinned([], []), { ...ONE, morphTargets: [{}] }].map(isDeformable)).toEqual([false, true, true]);
  });
});
