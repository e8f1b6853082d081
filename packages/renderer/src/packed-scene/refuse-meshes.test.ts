import { expect, test } from 'vitest';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { stillMoment } from '../scene/motion.ts';
import { loadGeometryPacker } from './geometry-packer.ts';
import { packPathScene } from './pack-path-scene.ts';
import { packScene } from './pack-scene.ts';
import { refuseMeshes, UntraceableSceneError } from './refuse-meshes.ts';

const at = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
const cube = { type: 'mesh', mesh: 'cube', material: 'white', ...at } as const;
const ball = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' } as const;
const meshes = { cube: { data: cubeMesh() } };

test('meshes that no shape places are no hindrance', () => {
  const scene = testScene({ ball }, {}, { meshes });
  expect(() => refuseMeshes(scene)).not.toThrow();
  expect(packScene(scene, [0, 0, 5]).shapeNames).toEqual(['ball']);
});

test('for the classic integrator nothing is packed without the meshes that it has', async () => {
  await loadGeometryPacker();
  const scene = testScene({ ball, 'my cube': cube }, {}, { meshes });
  expect(() => packScene(scene, [0, 0, 5])).toThrow(UntraceableSceneError);
  expect(() => packScene(scene, [0, 0, 5])).toThrow('The shape "my cube" is a mesh');
  expect(packPathScene(stillMoment(scene), [0, 0, 5]).shapeNames).toEqual(['ball', 'my cube']);
});
