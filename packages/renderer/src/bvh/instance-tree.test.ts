import { expect, test } from 'vitest';
import { between, type Random, seededRandom } from '../../../../tests/fixtures/random.ts';
import { checkTree } from '../../../../tests/fixtures/tree-check.ts';
import { type Bvh, leafCount, sahCost } from './bvh.ts';
import { InstanceTree } from './instance-tree.ts';

function randomBoxes(random: Random, count: number, extent = 100): Float32Array {
  const boxes = new Float32Array(6 * count);
  for (let i = 0; i < count; i++) {
    for (let axis = 0; axis < 3; axis++) {
      const [place, size] = [between(random, 0, extent), extent * 0.1 * random() ** 3];
      boxes[6 * i + axis] = place - size;
      boxes[6 * i + axis + 3] = place + size;
    }
  }
  return boxes;
}

const used = (bvh: Bvh): Bvh => ({ ...bvh, order: bvh.order.slice(0, bvh.primitiveCount) });

test('a tree with one instance a leaf, for any number of them, again and again (seed 51)', () => {
  const random = seededRandom(51);
  const tree = new InstanceTree();
  for (const count of [0, 1, 2, 3, 9, 100, 1000, 7, 0, 1200, 5000, 2]) {
    const boxes = randomBoxes(random, count);
    const bvh = tree.build(boxes, count);
    expect(checkTree(used(bvh), boxes)).toBe(Math.min(count, 1));
    expect(bvh.nodeCount).toBe(Math.max(0, 2 * count - 1));
    expect(Array.from({ length: bvh.nodeCount }, (_, i) => leafCount(bvh, i)).filter((n) => n > 1)).toEqual([]);
  }
});

test('arrays are kept from one frame to the next (seed 52)', () => {
  const random = seededRandom(52);
  const tree = new InstanceTree();
  const { bounds, links, order } = tree.build(randomBoxes(random, 1000), 1000);
  for (const count of [1000, 10, 999]) {
    const again = tree.build(randomBoxes(random, count), count);
    expect([again.bounds === bounds, again.links === links, again.order === order]).toEqual([true, true, true]);
  }
});

test('a grown builder gives what a new one gives (seed 53)', () => {
  const random = seededRandom(53);
  const grown = new InstanceTree();
  grown.build(randomBoxes(random, 3000), 3000);
  const boxes = randomBoxes(random, 400);
  const [a, b] = [grown.build(boxes, 400), new InstanceTree().build(boxes, 400)];
  expect(a.bounds.slice(0, 6 * a.nodeCount)).toEqual(b.bounds.slice(0, 6 * b.nodeCount));
  expect(a.order.slice(0, 400)).toEqual(b.order.slice(0, 400));
  expect(sahCost(a)).toBe(sahCost(b));
});

test('instances in one place, or of no size, are told apart by number only', () => {
  const tree = new InstanceTree();
  const boxes = Float32Array.from({ length: 600 }, (_, k) => (k % 6 < 3 ? 1 : 2));
  checkTree(used(tree.build(boxes, 100)), boxes);
  const points = new Float32Array(600).fill(5);
  const bvh = tree.build(points, 100);
  checkTree(used(bvh), points);
  expect(bvh.depth).toBeLessThanOrEqual(8);
});

test('refuses boxes that are missing or not finite', () => {
  const tree = new InstanceTree();
  expect(() => tree.build(new Float32Array(11), 2)).toThrow('11 floats are less than 2 boxes');
  expect(() => tree.build(Float32Array.of(0, 0, 0, 1, NaN, 1), 1)).toThrow(/not finite/);
});

test('the quick tree is one too, for any number of boxes, again and again, and not much worse (seed 54)', () => {
  const random = seededRandom(54);
  const tree = new InstanceTree();
  for (const count of [0, 1, 2, 3, 9, 100, 1000, 7, 0, 1200, 5000, 2]) {
    const boxes = randomBoxes(random, count);
    const bvh = tree.buildQuickly(boxes, count);
    expect(checkTree(used(bvh), boxes)).toBe(Math.min(count, 1));
    expect(sahCost(bvh)).toBeLessThanOrEqual(1.35 * sahCost(tree.build(boxes, count)));
  }
});

test('the quick tree keeps its arrays and does not grow deep over equal boxes, points and rows (seed 55)', () => {
  const random = seededRandom(55);
  const tree = new InstanceTree();
  const { bounds, links, order } = tree.buildQuickly(randomBoxes(random, 1000), 1000);
  const shapes = [
    new Float32Array(6000).fill(5),
    Float32Array.from({ length: 6000 }, (_, k) => (k % 6 < 3 ? 1 : 2)),
    Float32Array.from({ length: 6000 }, (_, k) => 2 ** (Math.floor(k / 6) / 20) * (k % 6 < 3 ? 1 : 1.01)),
  ];
  for (const boxes of shapes) {
    const bvh = tree.buildQuickly(boxes, 1000);
    checkTree(used(bvh), boxes);
    expect(bvh.depth).toBeLessThanOrEqual(25);
    expect([bvh.bounds === bounds, bvh.links === links, bvh.order === order]).toEqual([true, true, true]);
  }
});

test('either tree is fitted to boxes that have moved (seed 56)', () => {
  const random = seededRandom(56);
  const tree = new InstanceTree();
  const [here, there] = [randomBoxes(random, 300), randomBoxes(random, 300)];
  for (const bvh of [tree.build(here, 300), tree.buildQuickly(here, 300)]) {
    checkTree(used(tree.refit(bvh, there)), there);
    checkTree(used(tree.refit(bvh, here)), here);
  }
  expect(() => tree.refit(tree.build(here, 300), there.subarray(6))).toThrow('less than 300 boxes');
});
