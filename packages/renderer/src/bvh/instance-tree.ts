/** The tree over the instances of a scene, built anew every frame: it keeps its arrays, so that a frame allocates nothing. */
import type { Bvh } from './bvh.ts';
import { SahTree } from './sah-tree.ts';
import { splitRules } from './split.ts';
import { Workspace } from './workspace.ts';

const sumOfZeros = (boxes: Float32Array, count: number): number => {
  let sum = 0;
  for (let i = 0; i < count * 6; i++) sum += boxes[i]! * 0;
  return sum;
};

export class InstanceTree {
  private readonly tree = new SahTree(new Workspace(), splitRules({ leafSize: 1, maxLeafSize: 1 }));

  /**
   * `boxes`: six floats an instance, least x, y, z, greatest x, y, z in the world. One instance a leaf. The tree that is returned is
   * always the same object and is written again by the next call; its arrays are replaced when they must grow. Throws a
   * RangeError when a box is missing or not finite.
   */
  build(boxes: Float32Array, count: number): Bvh {
    if (boxes.length < 6 * count) throw new RangeError(`${boxes.length} floats are less than ${count} boxes`);
    if (sumOfZeros(boxes, count) !== 0) throw new RangeError('The box of an instance is not finite');
    this.tree.start(boxes, count);
    this.tree.grow(count);
    return this.tree;
  }
}
