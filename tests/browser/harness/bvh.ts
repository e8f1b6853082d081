import { buildBvh } from '../../../packages/renderer/src/bvh/build-bvh.ts';
import { buildBvhInWorker } from '../../../packages/renderer/src/bvh/build-in-worker.ts';
import type { Bvh } from '../../../packages/renderer/src/bvh/bvh.ts';
import { landscape } from '../../fixtures/meshes.ts';
import { seededRandom } from '../../fixtures/random.ts';

const equal = (a: Bvh, b: Bvh) =>
  a.depth === b.depth &&
  (['bounds', 'links', 'order'] as const).every(
    (part) => a[part].length === b[part].length && a[part].every((x, i) => x === b[part][i]),
  );

/** A tree from a worker beside one of this thread; another is cancelled, one is refused. */
export async function treesFromWorker(side: number) {
  const mesh = landscape(seededRandom(43), side);
  const shares: number[] = [];
  const fast: Bvh[] = [];
  const built = buildBvhInWorker(mesh, {
    onFastTree: (bvh) => fast.push(bvh),
    onProgress: (done) => shares.push(done),
  });
  // An empty array as the mesh's would be a mesh that was handed over and not copied.
  const kept = mesh.indices.length > 0;
  const bvh = await built;

  const controller = new AbortController();
  const cancelled = await buildBvhInWorker(mesh, {
    onProgress: () => controller.abort(new Error('enough')),
    signal: controller.signal,
  }).then(
    () => 'built',
    (error: Error) => error.message,
  );
  const indices = Uint32Array.of(0, 1, 1e9);
  const refused = await buildBvhInWorker({ positions: mesh.positions, indices }).then(
    () => 'built',
    (error: Error) => `${error.name}: ${error.message}`,
  );
  return {
    same: equal(bvh, buildBvh(mesh)),
    fastNodes: fast.map((tree) => tree.nodeCount),
    shares,
    kept,
    cancelled,
    refused,
  };
}
