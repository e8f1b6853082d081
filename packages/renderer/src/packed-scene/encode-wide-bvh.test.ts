import { describe, expect, test } from 'vitest';
import { awkwardMeshes, bumpySphere, landscape, soup } from '../../../../tests/fixtures/meshes.ts';
import { between, pick, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { checkTree } from '../../../../tests/fixtures/tree-check.ts';
import { wideSource } from '../../../../tests/fixtures/wide-source.ts';
import { buildBvh } from '../bvh/build-bvh.ts';
import { type Bvh, firstPlace, leafCount, sahCost, type TriangleMesh } from '../bvh/bvh.ts';
import { triangleBoxes } from '../bvh/primitive-boxes.ts';
import { planRefit, refit } from '../bvh/refit.ts';
import { type NodeSource, roomForChildren } from '../bvh/trace/node-source.ts';
import { closestByBruteForce, closestHit } from '../bvh/trace/trace.ts';
import { decodeWideBvh } from './decode-wide-bvh.ts';
import { encodeWideBvh, MOST_IN_LEAF, writeBoxes } from './encode-wide-bvh.ts';

function sourceOf(bvh: Bvh): NodeSource {
  const { words, stackNeed } = encodeWideBvh(bvh);
  return wideSource(words, bvh.order, stackNeed);
}

const random = seededRandom(87);
const meshes = Object.entries<TriangleMesh>({
  ...awkwardMeshes(random),
  soup: soup(random, 1000),
  landscape: landscape(random, 20),
  sphere: bumpySphere(random, 15),
});
const options = { maxLeafSize: 4 };

describe.each(meshes)('%s', (_, mesh) => {
  const bvh = buildBvh(mesh, options);
  const source = sourceOf(bvh);

  test('every triangle is in one leaf, and in all boxes above it', () => {
    const boxes = triangleBoxes(mesh);
    const below = (node: number): number[] => {
      const children = roomForChildren();
      source.readChildren(node, children);
      return Array.from({ length: children.count }, (_, i) => {
        const [count, index] = [children.primitives[i]!, children.index[i]!];
        const triangles = count > 0 ? [...source.order.subarray(index, index + count)] : below(index);
        for (const triangle of triangles)
          for (let k = 0; k < 6; k++) {
            const [outer, inner] = [children.bounds[6 * i + k]!, boxes[6 * triangle + k]!];
            if (k < 3 ? outer > inner : outer < inner) expect.fail(`${outer} leaves ${inner} of ${triangle} outside`);
          }
        return triangles;
      }).flat();
    };
    const all = below(0).sort((a, b) => a - b);
    expect(all).toEqual(Array.from({ length: mesh.indices.length / 3 }, (_, triangle) => triangle));
  });

  test('a ray finds what brute force finds, with no more on the stack than promised (seed 88)', () => {
    const rays = seededRandom(88);
    const size = mesh.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 1e-30);
    for (let k = 0; k < 100 && mesh.indices.length > 0; k++) {
      const vertex = 3 * pick(rays, [...mesh.indices.subarray(0, 300)]);
      const direction = [...randomDirection(rays)] as [number, number, number];
      const origin = direction.map(
        (d, axis) => mesh.positions[vertex + axis]! - d * size + between(rays, -0.01, 0.01) * size,
      ) as [number, number, number];
      const ray = { origin, direction, tMin: 0, tMax: Number.POSITIVE_INFINITY };
      expect(closestHit(source, mesh, ray)).toEqual(closestByBruteForce(mesh, ray));
    }
  });
});

describe.each(meshes)('%s, read back', (_, mesh) => {
  const tree = buildBvh(mesh, options);
  const { words } = encodeWideBvh(tree);
  const { bvh, sources } = decodeWideBvh(words, tree.order);

  test('is a binary tree with the same leaves, and as good as that which was written', () => {
    refit(bvh, mesh.positions, planRefit(bvh, mesh));
    checkTree(bvh, triangleBoxes(mesh));
    const leaves = (one: Bvh) =>
      Array.from({ length: one.nodeCount }, (_, i) => [firstPlace(one, i), leafCount(one, i)]).filter(
        ([, n]) => n! > 0,
      );
    expect(leaves(bvh)).toEqual(leaves(tree));
    expect(sahCost(bvh)).toBeLessThan(1.1 * sahCost(tree) + 1e-9);
  });

  test('boxes written anew are those that stood there', () => {
    const copy = words.slice();
    const floats = new Float32Array(copy.buffer);
    refit(
      bvh,
      mesh.positions.map((x) => 2 - x),
      planRefit(bvh, mesh),
    );
    writeBoxes(sources, sources.length / 4, bvh, floats);
    if (mesh.indices.length > 0) expect(copy).not.toEqual(words);
    refit(bvh, mesh.positions, planRefit(bvh, mesh));
    writeBoxes(sources, sources.length / 4, bvh, floats);
    expect(copy).toEqual(words);
  });
});

test('a leaf with more than its reference can count is refused', () => {
  const same = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0),
    indices: new Uint32Array(24).map((_, k) => k % 3),
  };
  const tree = buildBvh(same, { leafSize: MOST_IN_LEAF + 1, maxLeafSize: MOST_IN_LEAF + 1 });
  expect(() => encodeWideBvh(tree)).toThrow(RangeError);
});
