import { describe, expect, test } from 'vitest';
import {
  awkwardMeshes,
  bumpySphere,
  joined,
  landscape,
  meshOf,
  shuffled,
  soup,
} from '../../../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { checkTree } from '../../../../tests/fixtures/tree-check.ts';
import { buildBvh, buildInSteps } from './build-bvh.ts';
import { type Bvh, leafCount, sahCost, type TriangleMesh } from './bvh.ts';
import { triangleBoxes } from './primitive-boxes.ts';

const random = seededRandom(71);
const meshes = {
  ...awkwardMeshes(random),
  soup: soup(random, 5000),
  landscape: landscape(random, 40),
  sphere: bumpySphere(random, 30),
  'shuffled landscape': shuffled(random, landscape(random, 50)),
};
const rules = [
  {},
  { leafSize: 10, maxLeafSize: 10 },
  { maxLeafSize: 1 },
  { leafSize: 2, maxLeafSize: 3 },
  { maxLeafSize: 16 },
];

describe.each(Object.entries(meshes))('%s (seed 71)', (_, mesh) => {
  test.each(rules)('is a tree of all its triangles, with exact bounds: %o', (options) => {
    const bvh = buildBvh(mesh, options);
    const largest = checkTree(bvh, triangleBoxes(mesh));
    expect(largest).toBeLessThanOrEqual(options.maxLeafSize ?? 4);
    expect(bvh.depth).toBeLessThanOrEqual(64);
  });

  test('is the same each time, in steps or at once', () => {
    const again = buildInSteps(mesh);
    let last = 0;
    for (;;) {
      const step = again.next();
      if (step.done) {
        expect(step.value).toEqual(buildBvh(mesh));
        break;
      }
      expect(step.value).toBeGreaterThanOrEqual(last);
      expect(step.value).toBeLessThan(1);
      last = step.value;
    }
  });
});

test('depth keeps to its bound, at the cost of quality', () => {
  const mesh = awkwardMeshes(seededRandom(71))['each half as far as the one before']!;
  const deep = buildBvh(mesh, { maxLeafSize: 1 });
  expect(deep.depth).toBeGreaterThan(16);
  for (const maxDepth of [8, 10, 16]) {
    const bvh = buildBvh(mesh, { maxLeafSize: 1, maxDepth });
    checkTree(bvh, triangleBoxes(mesh));
    expect(bvh.depth).toBeLessThanOrEqual(maxDepth);
    expect(sahCost(bvh)).toBeGreaterThanOrEqual(sahCost(deep));
  }
});

/** The exact heuristic over all places between centres on all axes, by doubles: what bins, samples and 15 bits approximate. */
function fullSweepCost(mesh: TriangleMesh, leafSize: number): number {
  const boxes = triangleBoxes(mesh);
  const box = (p: number) => [...boxes.subarray(6 * p, 6 * p + 6)];
  const area = (b: readonly number[]) => {
    const [dx, dy, dz] = [b[3]! - b[0]!, b[4]! - b[1]!, b[5]! - b[2]!];
    return dx * (dy + dz) + dy * dz;
  };
  const unite = (a: readonly number[], b: readonly number[]) =>
    a.map((x, k) => (k < 3 ? Math.min(x, b[k]!) : Math.max(x, b[k]!)));
  const cost = (items: number[]): number => {
    const whole = area(items.map(box).reduce(unite));
    if (items.length <= leafSize) return 1.25 * items.length * whole;
    let best = { cost: Infinity, left: [] as number[], right: [] as number[] };
    for (let axis = 0; axis < 3; axis++) {
      const sorted = items.toSorted((p, q) => {
        const centre = (r: number) => boxes[6 * r + axis]! + boxes[6 * r + 3 + axis]!;
        return centre(p) - centre(q);
      });
      const right: number[] = [];
      sorted.reduceRight<readonly number[] | null>((union, p, i) => {
        const next = union ? unite(union, box(p)) : box(p);
        right[i] = area(next) * (sorted.length - i);
        return next;
      }, null);
      let union = box(sorted[0]!);
      for (let i = 1; i < sorted.length; i++) {
        const total = area(union) * i + right[i]!;
        if (total < best.cost) best = { cost: total, left: sorted.slice(0, i), right: sorted.slice(i) };
        union = unite(union, box(sorted[i]!));
      }
    }
    return whole + cost(best.left) + cost(best.right);
  };
  const all = Array.from({ length: boxes.length / 6 }, (_, p) => p);
  return cost(all) / area(all.map(box).reduce(unite));
}

test.each([
  ['landscape', landscape(seededRandom(72), 45)],
  ['sphere', bumpySphere(seededRandom(73), 32)],
  ['shuffled', shuffled(seededRandom(74), bumpySphere(seededRandom(74), 30))],
  ['soup', soup(seededRandom(75), 4000)],
])('costs about what a full sweep costs: %s', (_, mesh) => {
  for (const leafSize of [4, 8]) {
    const bvh = buildBvh(mesh, { leafSize, maxLeafSize: leafSize });
    expect(sahCost(bvh) / fullSweepCost(mesh, leafSize)).toBeLessThan(1.03);
  }
});

test('a few large triangles or far ones do not spoil the rest, though big nodes are only sampled', () => {
  const detail = landscape(seededRandom(76), 60);
  const alone = sahCost(buildBvh(detail));
  const areaOf = ({ bounds: b }: Bvh) => {
    const [dx, dy, dz] = [b[3]! - b[0]!, b[4]! - b[1]!, b[5]! - b[2]!];
    return dx * dy + dy * dz + dz * dx;
  };
  const large = [-500, -1, -500, 500, -1, -500, 0, -1, 500];
  const far = [300, 200, 300, 300.01, 200, 300, 300, 200.01, 300];
  for (const mesh of [
    joined(detail, meshOf(large)),
    joined(detail, meshOf(far)),
    joined(meshOf([...large, ...far]), detail),
  ]) {
    const bvh = buildBvh(mesh);
    // A ray that meets the scene seldom meets the landscape; then it costs as much as that alone. Else, a few large nodes.
    const share = areaOf(buildBvh(detail)) / areaOf(bvh);
    expect(sahCost(bvh)).toBeLessThan(5 + 1.05 * share * alone);
  }
});

describe('what is no mesh is refused', () => {
  const { positions } = meshOf([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  test.each([
    ['an index that leads nowhere', positions, [0, 1, 3], /Triangle 0 has index 3, but there are 3 positions/],
    ['two indices', positions, [0, 1], /2 indices are not three for each triangle/],
    ['NaN', [0, 0, 0, 1, NaN, 0, 0, 1, 0], [0, 1, 2], /Triangle 0 has a vertex at 1, NaN, 0/],
    ['infinity', [0, 0, 0, 1, 0, 0, 0, 1, -Infinity], [0, 1, 2], /Triangle 0 has a vertex at 0, 1, -Infinity/],
  ])('%s', (_, places, indices, problem) => {
    const mesh = { positions: Float32Array.from(places), indices: Uint32Array.from(indices) };
    expect(() => buildBvh(mesh)).toThrow(problem);
  });

  test('but a position that no triangle uses may be anything', () => {
    const mesh = { positions: Float32Array.of(...positions, NaN, Infinity, 0), indices: Uint32Array.of(0, 1, 2) };
    expect(leafCount(buildBvh(mesh), 0)).toBe(1);
  });
});
