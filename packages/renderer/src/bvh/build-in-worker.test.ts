import { expect, test } from 'vitest';
import { landscape } from '../../../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { buildBvh } from './build-bvh.ts';
import { buildBvhInWorker } from './build-in-worker.ts';
import type { Bvh } from './bvh.ts';
import { buildFastBvh } from './fast-tree.ts';

const mesh = landscape(seededRandom(41), 120);

test('without workers it builds in slices on this thread: first the fast tree, then the good one', async () => {
  const fast: Bvh[] = [];
  const shares: number[] = [];
  const options = { leafSize: 2, maxLeafSize: 3 };
  const bvh = await buildBvhInWorker(mesh, {
    options,
    onFastTree: (tree) => fast.push(tree),
    onProgress: (done) => shares.push(done),
  });
  expect(bvh).toEqual(buildBvh(mesh, options));
  expect(fast).toEqual([buildFastBvh(mesh, { leafSize: 3 })]);
  expect(shares.length).toBeGreaterThan(4);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  expect(shares.at(-1)).toBe(1);
});

test('no fast tree unless asked for', async () => {
  expect(await buildBvhInWorker(mesh)).toEqual(buildBvh(mesh));
});

test('can be cancelled, before and on the way', async () => {
  const controller = new AbortController();
  const build = buildBvhInWorker(landscape(seededRandom(42), 200), {
    onProgress: () => controller.abort(),
    signal: controller.signal,
  });
  await expect(build).rejects.toThrow(/abort/i);
  await expect(buildBvhInWorker(mesh, { signal: controller.signal })).rejects.toThrow(/abort/i);
});

test('what is no mesh is refused', async () => {
  const bad = { positions: mesh.positions, indices: Uint32Array.of(0, 1, 1e9) };
  await expect(buildBvhInWorker(bad)).rejects.toThrow(RangeError);
  await expect(buildBvhInWorker(bad, { onFastTree: () => {} })).rejects.toThrow(/Triangle 0 has index 1000000000/);
});
