/** Trees over the instances of a scene, built while a frame waits: they keep their arrays, so that a frame allocates nothing. */
import { uniteUpwards } from './bounds.ts';
import type { Bvh } from './bvh.ts';
import { MortonSweep } from './morton-sweep.ts';
import { SahTree } from './sah-tree.ts';
import { splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

const sumOfZeros = (boxes: Float32Array, count: number): number => {
  let sum = 0;
  for (let i = 0; i < count * 6; i++) sum += boxes[i]! * 0;
  return sum;
};

function check(boxes: Float32Array, count: number): void {
  if (boxes.length < 6 * count) throw new RangeError(`${boxes.length} floats are less than ${count} boxes`);
  if (sumOfZeros(boxes, count) !== 0) throw new RangeError('The box of an instance is not finite');
}

/**
 * `boxes`: six floats an instance, least x, y, z, greatest x, y, z in the world. One instance a leaf. The tree that is returned is
 * always the same object of its method and is written again by the next call; its arrays are replaced when they must grow. All
 * methods throw a RangeError when a box is missing or not finite.
 */
export class InstanceTree {
  private readonly tree = new SahTree(new Workspace(), splitRules({ leafSize: 1, maxLeafSize: 1 }));
  private readonly sweep = new MortonSweep();

  /** A good tree, for instances that stay for a while. */
  build(boxes: Float32Array, count: number): Bvh {
    check(boxes, count);
    this.tree.start(boxes, count);
    this.tree.grow(count);
    return this.tree;
  }

  /** A tree in less than half the time, for instances that move. */
  buildQuickly(boxes: Float32Array, count: number): Bvh {
    check(boxes, count);
    return this.sweep.build(boxes, count);
  }

  /** The tree that one of the others has given, over the same instances in other boxes: when all have moved alike. */
  refit(bvh: Bvh, boxes: Float32Array): Bvh {
    const { nodeCount, primitiveCount, links, bounds, order } = bvh;
    check(boxes, primitiveCount);
    for (let i = 0; i < nodeCount; i++) {
      if (links[2 * i + 1] === 0) continue;
      const at = 6 * order[links[2 * i]!]!;
      for (let k = 0; k < 6; k++) bounds[6 * i + k] = boxes[at + k]!;
    }
    uniteUpwards(nodeCount, links, bounds);
    return bvh;
  }
}
