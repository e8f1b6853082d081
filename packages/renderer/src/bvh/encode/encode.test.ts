import { describe, expect, test } from 'vitest';
import { awkwardMeshes, bumpySphere, landscape, meshOf, soup } from '../../../../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { buildBvh } from '../build-bvh.ts';
import { type Bvh, firstChild, halfArea, leafCount, secondChild, type TriangleMesh } from '../bvh.ts';
import { triangleBoxes } from '../primitive-boxes.ts';
import { type NodeSource, roomForChildren } from '../trace/node-source.ts';
import { cheapestCollapse, WIDE_COSTS } from './cheapest-collapse.ts';
import { collapse } from './collapse.ts';
import { encodeFramed2, framed2Source } from './framed2.ts';
import { placedIndices } from './placed-indices.ts';
import { encodeQuantised2, quantised2Source } from './quantised2.ts';
import { placesBelow, wideCost } from './wide-tree.ts';
import { encodeWide2, wide2Source } from './wide2.ts';
import { encodeWide4, wide4Source } from './wide4.ts';
import { encodeWide8 } from './wide8.ts';
import { wide8Source } from './wide8-source.ts';

const random = seededRandom(81);
const meshes = {
  ...awkwardMeshes(random),
  soup: soup(random, 3000),
  landscape: landscape(random, 30),
  sphere: bumpySphere(random, 25),
};
const encodings: Readonly<
  Record<string, { bytes: number; width: number; source: (bvh: Bvh) => [NodeSource, number] }>
> = {
  wide2: {
    bytes: 64,
    width: 2,
    source: (bvh) => [wide2Source(encodeWide2(bvh), bvh.order), encodeWide2(bvh).words.length],
  },
  quantised2: {
    bytes: 32,
    width: 2,
    source: (bvh) => [quantised2Source(encodeQuantised2(bvh), bvh.order), encodeQuantised2(bvh).words.length],
  },
  framed2: {
    bytes: 32,
    width: 2,
    source: (bvh) => [framed2Source(encodeFramed2(bvh), bvh.order), encodeFramed2(bvh).words.length],
  },
  wide4: {
    bytes: 128,
    width: 4,
    source: (bvh) => [wide4Source(encodeWide4(bvh), bvh.order), encodeWide4(bvh).words.length],
  },
  'wide4 at the least cost': {
    bytes: 128,
    width: 4,
    source: (bvh) => {
      const nodes = encodeWide4(bvh, cheapestCollapse(bvh, 4, 16));
      return [wide4Source(nodes, bvh.order), nodes.words.length];
    },
  },
  wide8: { bytes: 80, width: 8, source: (bvh) => [wide8Source(encodeWide8(bvh)), encodeWide8(bvh).words.length] },
};

/** Walks a whole encoding; calls back for each child with its box and the primitives below. Returns the number of nodes. */
function walk(source: NodeSource, child: (box: readonly number[], primitives: readonly number[]) => void): number {
  let nodes = 0;
  const below = (node: number): number[] => {
    nodes++;
    const children = roomForChildren();
    source.readChildren(node, children);
    return Array.from({ length: children.count }, (_, i) => {
      const [count, index] = [children.primitives[i]!, children.index[i]!];
      const primitives = count > 0 ? [...source.order.subarray(index, index + count)] : below(index);
      child([...children.bounds.subarray(6 * i, 6 * i + 6)], primitives);
      return primitives;
    }).flat();
  };
  const all = below(source.root).sort((a, b) => a - b);
  expect(all).toEqual(all.map((_, k) => k));
  expect(all.length).toBe(source.order.length);
  return nodes;
}

const unionOf = (boxes: Float32Array, primitives: readonly number[]): number[] =>
  primitives
    .map((p) => [...boxes.subarray(6 * p, 6 * p + 6)])
    .reduce((u, b) => u.map((x, k) => (k < 3 ? Math.min(x, b[k]!) : Math.max(x, b[k]!))));

const holds = (outer: readonly number[], inner: readonly number[]) =>
  outer.every((x, k) => (k < 3 ? x <= inner[k]! : x >= inner[k]!));

describe.each(Object.entries(encodings))('%s', (name, { bytes, width, source }) => {
  test.each(Object.entries(meshes))(
    'has every triangle once, in boxes that are never too small: %s (seed 81)',
    (_, mesh) => {
      const bvh = buildBvh(mesh, { maxLeafSize: 3 });
      const boxes = triangleBoxes(mesh);
      const [nodes, words] = source(bvh);
      const count = walk(nodes, (box, primitives) => {
        const exact = unionOf(boxes, primitives);
        if (!holds(box, exact)) expect.fail(`${box} does not hold ${exact}`);
        if (name === 'wide2' || name === 'wide4') expect(holds(exact, box)).toBe(true);
      });
      expect(words * 4).toBe(count * bytes);
      const inner = Array.from({ length: bvh.nodeCount }, (_, i) => i).filter((i) => leafCount(bvh, i) === 0).length;
      if (width === 2) expect(count).toBe(Math.max(1, inner));
    },
  );

  test('holds what its words can, and says so where they cannot', () => {
    const same = meshOf(Array.from({ length: 20 }, () => [0, 0, 0, 1, 0, 0, 0, 1, 0]).flat());
    const most = { framed2: 15, wide8: 3 }[name] ?? 16;
    const leaves = (size: number, mesh: TriangleMesh) => source(buildBvh(mesh, { leafSize: size, maxLeafSize: size }));
    const cut = (count: number): TriangleMesh => ({
      positions: same.positions,
      indices: same.indices.subarray(0, 3 * count),
    });
    walk(leaves(most, cut(most))[0], () => {});
    expect(() => leaves(most + 1, cut(most + 1))).toThrow(`${most + 1} primitives; this encoding holds 1 to ${most}`);
  });
});

test('16 bits over the mesh are at most two cells larger, 8 bits of a node two of its own', () => {
  const mesh = bumpySphere(seededRandom(82), 30);
  const boxes = triangleBoxes(mesh);
  const bvh = buildBvh(mesh);
  const { grids } = encodeQuantised2(bvh);
  walk(quantised2Source(encodeQuantised2(bvh), bvh.order), (box, primitives) => {
    const exact = unionOf(boxes, primitives);
    box.forEach((x, k) => {
      if (Math.abs(x - exact[k]!) > 1.001 * 2 ** grids[k % 3]!.exponent) expect.fail(`${x} is far from ${exact[k]}`);
    });
  });
  const extent = bvh.bounds[3]! - bvh.bounds[0]!;
  expect(2 ** grids[0]!.exponent).toBeLessThanOrEqual((2 * extent) / 65535);
  expect(2 ** grids[0]!.exponent).toBeGreaterThanOrEqual(extent / 65535);
});

test('four children: the largest are opened first', () => {
  const bvh = buildBvh(landscape(seededRandom(83), 40), { maxLeafSize: 3 });
  const children = roomForChildren();
  wide4Source(encodeWide4(bvh), bvh.order).readChildren(0, children);
  const [a, b] = [firstChild(0), secondChild(bvh, 0)];
  const grandchildren = [a, b].flatMap((node) => [firstChild(node), secondChild(bvh, node)]);
  const corner = (node: number) => bvh.bounds[6 * node]!;
  expect(Array.from({ length: 4 }, (_, i) => children.bounds[6 * i])).toEqual(grandchildren.map(corner));
});

/** The least cost by trying everything: all forests of at most `most` trees below a node. */
function leastCost(bvh: Bvh, width: number, leaf: number, node: number, most: number): number {
  const { count } = placesBelow(bvh);
  const area = halfArea(bvh, node);
  const asLeaf = count[node]! <= leaf ? area * count[node]! * WIDE_COSTS.primitive : Infinity;
  if (leafCount(bvh, node) > 0) return asLeaf;
  const forest = (trees: number): number => {
    let best = Infinity;
    for (let k = 1; k < trees; k++) {
      const left = leastCost(bvh, width, leaf, firstChild(node), k);
      best = Math.min(best, left + leastCost(bvh, width, leaf, secondChild(bvh, node), trees - k));
    }
    return best;
  };
  return Math.min(asLeaf, forest(width) + area * WIDE_COSTS.node, most > 1 ? forest(most) : Infinity);
}

test('the cheapest collapse is the cheapest there is, and cheaper than opening the largest (seed 85)', () => {
  const random = seededRandom(85);
  for (let k = 0; k < 12; k++) {
    const bvh = buildBvh(soup(random, 9, 0.4), { maxLeafSize: 1 });
    for (const [width, leaf] of [
      [2, 1],
      [3, 2],
      [4, 3],
    ] as const) {
      const tree = cheapestCollapse(bvh, width, leaf);
      // The root is a node in any case.
      const [a, b] = [firstChild(0), secondChild(bvh, 0)];
      const forests = Array.from(
        { length: width - 1 },
        (_, i) => leastCost(bvh, width, leaf, a, i + 1) + leastCost(bvh, width, leaf, b, width - 1 - i),
      );
      const least = Math.min(...forests) / halfArea(bvh, 0) + WIDE_COSTS.node;
      expect(wideCost(bvh, tree, WIDE_COSTS)).toBeCloseTo(least, 9);
      expect(wideCost(bvh, collapse(bvh, width), WIDE_COSTS)).toBeGreaterThan(least - 1e-9);
    }
  }
  const bvh = buildBvh(landscape(random, 60), { maxLeafSize: 1 });
  const cheapest = cheapestCollapse(bvh, 8, 3);
  expect(cheapest.nodeCount).toBeLessThan(bvh.primitiveCount / 7);
  expect(wideCost(bvh, cheapest, WIDE_COSTS)).toBeLessThan(0.9 * wideCost(bvh, collapse(bvh, 8), WIDE_COSTS));
});

test('placed indices: what leaves point to', () => {
  const mesh = landscape(seededRandom(86), 6);
  const bvh = buildBvh(mesh);
  const placed = placedIndices(mesh.indices, bvh.order);
  bvh.order.forEach((triangle, place) => {
    const corners = mesh.indices.subarray(3 * triangle, 3 * triangle + 3);
    expect(placed.subarray(3 * place, 3 * place + 3)).toEqual(corners);
  });
});
