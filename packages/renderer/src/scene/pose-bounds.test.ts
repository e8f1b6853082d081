import { describe, expect, test } from 'vitest';
import { between, type Random, seededRandom } from '../../../../tests/fixtures/random.ts';
import { deform, makeDeformed, type Pose } from './deform.ts';
import type { Mesh } from './mesh.ts';
import { affineOf } from './placed.ts';
import { PoseBounds } from './pose-bounds.ts';

const VERTICES = 60;
const JOINTS = 7;
const TARGETS = 3;
const numbers = (random: Random, count: number, size: number) =>
  Float32Array.from({ length: count }, () => between(random, -size, size));

/** Of any size, far from the origin or not; `sum`: of the weights of each vertex. */
function randomMesh(random: Random, perVertex: number, sum = 1): Mesh {
  const size = 10 ** between(random, -3, 3);
  const home = [0, 1, 2].map(() => between(random, -5, 5) * size);
  const positions = numbers(random, 3 * VERTICES, size).map((x, i) => x + home[i % 3]!);
  const weights = Float32Array.from({ length: perVertex * VERTICES }, () => (random() < 0.5 ? 0 : random()));
  for (let k = 0; k < weights.length; k += perVertex) {
    weights[k] = weights[k]! + 0.01;
    const total = weights.subarray(k, k + perVertex).reduce((a, b) => a + b);
    for (let i = k; i < k + perVertex; i++) weights[i] = (sum * weights[i]!) / total;
  }
  const morphTargets = Array.from({ length: TARGETS }, (_, i) =>
    i === 1 ? {} : { positions: numbers(random, 3 * VERTICES, size * random()) },
  );
  const joints = Uint16Array.from(weights, () => Math.floor(random() * JOINTS));
  return { positions, indices: Uint32Array.of(0, 1, 2), skin: { joints, weights }, morphTargets };
}

function randomPose(random: Random): Pose {
  const one = () => between(random, -2, 2);
  const matrices = Array.from({ length: JOINTS }, () => affineOf([one(), one(), one()], [one(), one(), one(), one()], [one(), one(), one()])); // biome-ignore format: one thought
  return {
    weights: Array.from({ length: TARGETS }, () => (random() < 0.3 ? 0 : one())),
    joints: Float32Array.from(matrices.flat()),
  };
}

/** How far vertices lie outside of the box, and how much wider it is than they need, as a share of their greatest coordinate. */
function compare(mesh: Mesh, skinned: boolean, pose: Pose): { outside: number; slack: number } {
  const box = new Float64Array(6);
  const out = makeDeformed(mesh);
  deform(mesh, skinned ? pose : { weights: pose.weights }, out);
  new PoseBounds(mesh, skinned).write(pose, box);
  let outside = 0;
  let slack = 0;
  for (let axis = 0; axis < 3; axis++) {
    const places = out.positions.filter((_, i) => i % 3 === axis);
    const [least, most] = [Math.min(...places), Math.max(...places)];
    outside = Math.max(outside, box[axis]! - least, most - box[axis + 3]!);
    slack = Math.max(slack, (box[axis + 3]! - most + least - box[axis]!) / Math.max(-least, most));
  }
  return { outside, slack };
}

describe.each([4, 8])('%i joints a vertex', (perVertex) => {
  test.each([1, 0, 3])('whose weights add up to %d: all vertices are inside (seed 301)', (sum) => {
    const random = seededRandom(301);
    for (let i = 0; i < 100; i++) {
      const mesh = randomMesh(random, perVertex, sum);
      expect(compare(mesh, true, randomPose(random)).outside).toBeLessThanOrEqual(0);
    }
  });
});

test('morph targets alone: all vertices are inside (seed 302)', () => {
  const random = seededRandom(302);
  for (let i = 0; i < 200; i++)
    expect(compare(randomMesh(random, 4), false, randomPose(random)).outside).toBeLessThanOrEqual(0);
});

test('a mesh that hangs on one joint, and one that nothing bends, get boxes that fit (seed 303)', () => {
  const random = seededRandom(303);
  for (let i = 0; i < 50; i++) {
    const { positions, indices } = randomMesh(random, 4);
    const weights = Float32Array.from({ length: 4 * VERTICES }, (_, k) => (k % 4 === 0 ? 1 : 0));
    const mesh = { positions, indices, skin: { joints: new Uint16Array(4 * VERTICES).fill(2), weights } };
    const moved = [2 ** between(random, -9, 9), 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0];
    const joints = Float32Array.from(Array.from({ length: JOINTS }, () => moved).flat());
    for (const skinned of [true, false]) {
      const { outside, slack } = compare(mesh, skinned, { joints });
      expect(outside).toBeLessThanOrEqual(0);
      expect(slack).toBeLessThan(1e-5);
    }
  }
});
