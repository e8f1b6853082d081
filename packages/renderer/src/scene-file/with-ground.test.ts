import { expect, test } from 'vitest';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { writePly } from '../mesh-file/ply/write-ply.ts';
import { openModel } from '../open/open-model.ts';
import { boundsAt } from '../scene/scene-bounds.ts';
import { isParsedScene } from './trusted-scenes.ts';
import { withGround } from './with-ground.ts';

async function cube() {
  const opened = await openModel(writePly(cubeMesh()), 'cube.ply');
  if (!opened.ok) throw new Error('The cube has not been read.');
  return opened.scene;
}

test('the floor lies just below the lowest point, reaches far, and is seen from above as its front', async () => {
  const scene = withGround(await cube());
  expect(isParsedScene(scene)).toBe(true);
  const { positions, indices } = scene.meshes!.ground!.data!;
  const radius = Math.sqrt(3) / 2;
  expect(positions[1]).toBeCloseTo(-0.5 - 1e-4 * radius, 6);
  const { min, max } = boundsAt(scene, 0)!;
  expect(max[0] - min[0]).toBeCloseTo(24 * radius, 3);
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((n) => 3 * indices[k + n]!) as [number, number, number];
    const [ux, uz] = [positions[b]! - positions[a]!, positions[b + 2]! - positions[a + 2]!];
    const [vx, vz] = [positions[c]! - positions[a]!, positions[c + 2]! - positions[a + 2]!];
    expect(uz * vx - ux * vz, 'the y of the normal').toBeGreaterThan(0);
  }
});

test('a name that is taken is left alone, and what is no scene of the library is refused', async () => {
  const twice = withGround(withGround(await cube()));
  expect(Object.keys(twice.shapes)).toEqual(['part 1', 'ground', 'ground 2']);
  expect(() => withGround({ ...twice })).toThrow(TypeError);
});
