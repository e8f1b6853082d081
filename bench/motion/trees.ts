/** How good trees of moving things are, and how long they take. */
import { buildBvh } from '../../packages/renderer/src/bvh/build-bvh.ts';
import { type Bvh, sahCost } from '../../packages/renderer/src/bvh/bvh.ts';
import { InstanceTree } from '../../packages/renderer/src/bvh/instance-tree.ts';
import { planRefit, refit } from '../../packages/renderer/src/bvh/refit.ts';
import { Bodies } from '../../packages/renderer/src/scene/bodies.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { seededRandom } from '../../tests/fixtures/random.ts';
import { median } from '../statistics.mjs';

const FRAMES = 200;
/** Moments of a clip. */
const MOMENTS = 24;
/** As kernels take them. */
const options = { maxLeafSize: 7 };

/** Boxes of many sizes, elsewhere in each frame. One row: how many, milliseconds and cost of the good tree, and of the quick one. */
export function instanceTrees(count: number): string[] {
  const random = seededRandom(5);
  const trees = new InstanceTree();
  const boxes = new Float32Array(6 * count);
  const kinds = [() => trees.build(boxes, count), () => trees.buildQuickly(boxes, count)];
  const [times, costs]: [number[][], number[][]] = [
    [[], []],
    [[], []],
  ];
  for (let frame = 0; frame < FRAMES; frame++) {
    for (let i = 0; i < 3 * count; i++) {
      const [place, size] = [100 * random(), random() ** 4 * 10];
      const at = 6 * Math.floor(i / 3) + (i % 3);
      boxes[at] = place - size;
      boxes[at + 3] = place + size;
    }
    kinds.forEach((build, kind) => {
      const start = performance.now();
      const bvh: Bvh = build();
      times[kind]!.push(performance.now() - start);
      if (frame % 20 === 0) costs[kind]!.push(sahCost(bvh));
    });
  }
  const ms = times.map((of) => median(of).toFixed(3));
  const [good, quick] = costs.map(median) as [number, number];
  return [String(count), ms[0]!, ms[1]!, (quick / good).toFixed(2)];
}

/** For each mesh of the scene that bends: cost of the tree that follows it, by that of one built for the moment; mean and worst. */
export function refittedTrees(name: string, scene: Scene): string[][] {
  const bodies = new Bodies(scene);
  const { duration } = scene.clips![scene.clip!]!;
  return bodies.all
    .filter(({ pose }) => pose !== null)
    .map((body) => {
      const { mesh } = body;
      const tree = buildBvh(mesh, options);
      const plan = planRefit(tree, mesh);
      const ratios = Array.from({ length: MOMENTS }, (_, k) => {
        bodies.goTo((duration * k) / MOMENTS);
        const { positions } = body.form!;
        refit(tree, positions, plan);
        return sahCost(tree) / sahCost(buildBvh({ positions, indices: mesh.indices }, options));
      });
      const mean = ratios.reduce((sum, x) => sum + x, 0) / MOMENTS;
      return [name, String(mesh.indices.length / 3), mean.toFixed(2), Math.max(...ratios).toFixed(2)];
    });
}
