import { expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { importGltf } from '../gltf/index.ts';
import type { Scene } from '../scene/scene.ts';
import { studioEnvironment } from '../scene/studio-environment.ts';
import { requireScene } from './require-scene.ts';
import { withParts } from './with-parts.ts';

async function model(): Promise<Scene> {
  const file = triangleFile((f) => {
    const sampler = { input: f.floats('SCALAR', 0, 1), output: f.floats('VEC3', 0, 0, 0, 1, 1, 1) };
    for (const name of ['walk', 'run'])
      f.add('animations', {
        name,
        samplers: [sampler],
        channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }],
      });
    f.add('materials', { name: 'dark' });
    f.json.extensions = { KHR_materials_variants: { variants: [{ name: 'night' }] } };
    f.json.meshes[0].primitives[0].extensions = {
      KHR_materials_variants: { mappings: [{ material: 0, variants: [0] }] },
    };
  });
  const result = await importGltf(file.glb());
  if (!result.ok) throw new Error('The model cannot be read.');
  return result.scene;
}

test('a model with another clip, variant, camera and sky is as good as before', async () => {
  const scene = await model();
  const camera = { eye: [0, 0, 5], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 20, node: 'thing' } as const;
  const map = studioEnvironment();
  const other = withParts(scene, {
    clip: 'run',
    variant: 'night',
    camera,
    sky: { horizon: [0, 0, 0], zenith: [0, 0, 0], map },
  });
  expect(requireScene(other)).toBe(other);
  expect(other).toMatchObject({
    clip: 'run',
    camera: { verticalFov: 20, node: 'thing' },
    shapes: { thing: { material: 'dark' } },
  });
  expect(other.sky.map).toBe(map);
  expect(other.meshes).toBe(scene.meshes);
  expect(withParts(other, { clip: null }).clip).toBeUndefined();
  const { camera: _, sky: __, ...rest } = withParts(scene, {});
  expect(scene).toMatchObject(rest);
});

test('what is wrong is thrown with its words', async () => {
  const scene = await model();
  expect(() => withParts(scene, { clip: 'fly' })).toThrow('no clip "fly"');
  expect(() => withParts(scene, { variant: 'dusk' })).toThrow('no variant "dusk"');
  expect(() => withParts(scene, { camera: { ...scene.camera, node: 'nobody' } })).toThrow('no node "nobody"');
  expect(() => withParts(scene, { camera: { ...scene.camera, verticalFov: 500 } })).toThrow('/camera/verticalFov');
  expect(() => withParts({ ...scene }, {})).toThrow(TypeError);
});
