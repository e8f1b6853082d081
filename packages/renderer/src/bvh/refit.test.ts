import { describe, expect, test } from 'vitest';
import { awkwardMeshes, landscape, soup } from '../../../../tests/fixtures/meshes.ts';
import { between, seededRandom } from '../../../../tests/fixtures/random.ts';
import { checkTree } from '../../../../tests/fixtures/tree-check.ts';
import { buildBvh } from './build-bvh.ts';
import { sahCost } from './bvh.ts';
import { buildFastBvh } from './fast-tree.ts';
import { triangleBoxes } from './primitive-boxes.ts';
import { indicesByPlace, refit } from './refit.ts';

const random = seededRandom(61);
const meshes = { ...awkwardMeshes(random), soup: soup(random, 900), landscape: landscape(random, 20) };

describe.each(Object.entries(meshes))('%s (seed 61)', (_, mesh) => {
  test.each([
    ['the good tree', buildBvh(mesh)],
    ['the fast tree', buildFastBvh(mesh)],
  ])('%s', (_, bvh) => {
    const placed = indicesByPlace(mesh.indices, bvh.order);
    const before = bvh.bounds.slice();
    refit(bvh, mesh.positions, placed);
    expect(
      bvh.bounds.every((x, k) => x === before[k]),
      'nothing moved, nothing changes',
    ).toBe(true);
    const moved = { ...mesh, positions: mesh.positions.map((x) => x * between(random, -2, 2) + 1) };
    refit(bvh, moved.positions, placed);
    checkTree(bvh, triangleBoxes(moved));
  });
});

test('a little movement keeps the tree good, much does not', () => {
  const mesh = soup(seededRandom(62), 2000);
  const bvh = buildBvh(mesh);
  const placed = indicesByPlace(mesh.indices, bvh.order);
  const elsewhere = soup(seededRandom(64), 2000);
  const shaken = { ...mesh, positions: mesh.positions.map((x) => x + between(random, -0.01, 0.01)) };
  refit(bvh, shaken.positions, placed);
  expect(sahCost(bvh)).toBeLessThan(1.05 * sahCost(buildBvh(shaken)));
  refit(bvh, elsewhere.positions, placed);
  expect(sahCost(bvh)).toBeGreaterThan(10 * sahCost(buildBvh(elsewhere)));
});

test('refuses what is no place, and too few indices', () => {
  const mesh = landscape(seededRandom(63), 3);
  const bvh = buildBvh(mesh);
  const placed = indicesByPlace(mesh.indices, bvh.order);
  expect(() => refit(bvh, mesh.positions.slice(0, -1), placed)).toThrow(/leads nowhere/);
  for (const bad of [NaN, Infinity]) {
    for (let at = 0; at < mesh.positions.length; at++) {
      const positions = mesh.positions.slice();
      positions[at] = bad;
      expect(() => refit(bvh, positions, placed)).toThrow(/not finite/);
    }
  }
  expect(() => refit(bvh, mesh.positions, placed.subarray(3))).toThrow(
    '51 indices are less than three for each of 18 triangles',
  );
});
