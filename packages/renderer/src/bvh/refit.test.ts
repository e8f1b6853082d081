import { describe, expect, test } from 'vitest';
import { awkwardMeshes, landscape, shuffled, soup } from '../../../../tests/fixtures/meshes.ts';
import { between, seededRandom } from '../../../../tests/fixtures/random.ts';
import { checkTree } from '../../../../tests/fixtures/tree-check.ts';
import { buildBvh } from './build-bvh.ts';
import { firstPlace, leafCount, sahCost } from './bvh.ts';
import { triangleBoxes } from './primitive-boxes.ts';
import { planRefit, refit } from './refit.ts';

const random = seededRandom(61);
const meshes = { ...awkwardMeshes(random), soup: soup(random, 900), landscape: landscape(random, 20) };

describe.each(Object.entries(meshes))('%s (seed 61)', (_, mesh) => {
  test('fits what moved', () => {
    const bvh = buildBvh(mesh);
    const plan = planRefit(bvh, mesh);
    const before = bvh.bounds.slice();
    refit(bvh, mesh.positions, plan);
    expect(
      bvh.bounds.every((x, k) => x === before[k]),
      'nothing moved, nothing changes',
    ).toBe(true);
    const moved = { ...mesh, positions: mesh.positions.map((x) => x * between(random, -2, 2) + 1) };
    refit(bvh, moved.positions, plan);
    checkTree(bvh, triangleBoxes(moved));
  });
});

test('a little movement keeps the tree good, much does not', () => {
  const mesh = soup(seededRandom(62), 2000);
  const bvh = buildBvh(mesh);
  const plan = planRefit(bvh, mesh);
  const elsewhere = soup(seededRandom(64), 2000);
  const shaken = { ...mesh, positions: mesh.positions.map((x) => x + between(random, -0.01, 0.01)) };
  refit(bvh, shaken.positions, plan);
  expect(sahCost(bvh)).toBeLessThan(1.05 * sahCost(buildBvh(shaken)));
  refit(bvh, elsewhere.positions, plan);
  expect(sahCost(bvh)).toBeGreaterThan(10 * sahCost(buildBvh(elsewhere)));
});

test('refuses what is no place, and too few indices', () => {
  const mesh = landscape(seededRandom(63), 3);
  const bvh = buildBvh(mesh);
  const plan = planRefit(bvh, mesh);
  expect(() => refit(bvh, mesh.positions.slice(0, -1), plan)).toThrow(/leads nowhere/);
  for (const bad of [NaN, Infinity]) {
    for (let at = 0; at < mesh.positions.length; at++) {
      const positions = mesh.positions.slice();
      positions[at] = bad;
      expect(() => refit(bvh, positions, plan)).toThrow(/not finite/);
    }
  }
  const other = { indices: mesh.indices.subarray(3) };
  expect(() => planRefit(bvh, other)).toThrow('The tree has 18 triangles, the mesh 17');
});

test('a plan has every leaf, in the order of the mesh’s vertices, and every vertex of a leaf once', () => {
  const mesh = shuffled(seededRandom(66), landscape(seededRandom(65), 20));
  const bvh = buildBvh(mesh);
  const { leaves, vertices, begins } = planRefit(bvh, mesh);
  let last = 0;
  leaves.forEach((i, k) => {
    const leaf = bvh.order.subarray(firstPlace(bvh, i), firstPlace(bvh, i) + leafCount(bvh, i));
    const corners = [...leaf].flatMap((t) => [...mesh.indices.subarray(3 * t, 3 * t + 3)]);
    expect([...vertices.subarray(begins[k], begins[k + 1])].sort()).toEqual([...new Set(corners)].sort());
    expect(Math.min(...corners)).toBeGreaterThanOrEqual(last);
    last = Math.min(...corners);
  });
  const all = Array.from({ length: bvh.nodeCount }, (_, i) => i).filter((i) => leafCount(bvh, i) > 0);
  expect([...leaves].sort((a, b) => a - b)).toEqual(all);
  expect(vertices.length).toBeLessThan(0.7 * mesh.indices.length);
});
