import { expect, test } from 'vitest';
import { landscape } from '../../../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import { packMeshes } from './pack-in-worker.ts';
import { isPacked, packMesh } from './pack-mesh.ts';

const mesh = (seed: number, side: number) => landscape(seededRandom(seed), side);

test('without workers meshes are packed in slices on this thread, as they are at once', async () => {
  const [large, small] = [mesh(51, 90), mesh(52, 5)];
  const shares: number[] = [];
  await packMeshes([large, small, large], { onProgress: (done) => shares.push(done) });
  expect(isPacked(large) && isPacked(small)).toBe(true);
  expect(packMesh(large)).toEqual(packMesh({ ...large }));
  expect(shares.length).toBeGreaterThan(2);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
  expect(shares.at(-1)).toBe(1);
});

test('what is packed is not packed again, and little is packed at once', async () => {
  const small = mesh(53, 5);
  const shares: number[] = [];
  await packMeshes([small], { onProgress: (done) => shares.push(done) });
  const packed = packMesh(small);
  await packMeshes([small]);
  expect(packMesh(small)).toBe(packed);
  expect(shares).toEqual([]);
});

test('can be cancelled, before and on the way', async () => {
  const controller = new AbortController();
  const large = mesh(54, 200);
  const packing = packMeshes([large], { onProgress: () => controller.abort(), signal: controller.signal });
  await expect(packing).rejects.toThrow(/abort/i);
  expect(isPacked(large)).toBe(false);
  await expect(packMeshes([large], { signal: controller.signal })).rejects.toThrow(/abort/i);
});

test('what is no mesh is refused', async () => {
  const bad = { ...mesh(55, 90), positions: Float32Array.of(0, 0, 0) };
  await expect(packMeshes([bad])).rejects.toThrow(RangeError);
});
