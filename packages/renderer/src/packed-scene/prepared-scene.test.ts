import { expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { openModel } from '../open/open-model.ts';
import { isParsedScene } from '../scene-file/trusted-scenes.ts';
import { areMeshesReady } from './geometry-packer.ts';
import { adoptScene, buffersOf, prepareScene } from './prepared-scene.ts';

async function model() {
  const opened = await openModel(triangleFile().glb(), 'thing.glb');
  if (!opened.ok) throw new Error('The triangle has not been read.');
  return opened.scene;
}

test('a scene that was posted is as good as it was, with its meshes packed, and nothing large was copied', async () => {
  const shares: number[] = [];
  const prepared = await prepareScene(await model(), (done) => shares.push(done));
  const buffers = buffersOf(prepared);
  const lengths = buffers.map(({ byteLength }) => byteLength);
  const [name] = Object.keys(prepared.scene.meshes!);
  const positions = [...prepared.scene.meshes![name!]!.data!.positions];
  const posted = structuredClone(prepared, { transfer: buffers });
  expect(
    buffers.every(({ byteLength }) => byteLength === 0),
    'it has gone over',
  ).toBe(true);
  expect(buffersOf(posted).map(({ byteLength }) => byteLength)).toEqual(lengths);
  const scene = await adoptScene(posted);
  expect(isParsedScene(scene)).toBe(true);
  expect(areMeshesReady(scene)).toBe(true);
  expect([...scene.meshes![name!]!.data!.positions]).toEqual(positions);
  expect(Object.isFrozen(scene) && Object.isFrozen(scene.camera.eye)).toBe(true);
  for (const things of [scene.materials, scene.shapes, scene.meshes!, scene.lights])
    expect(Object.getPrototypeOf(things), 'no name finds what nobody gave').toBeNull();
  expect(shares.at(-1) ?? 1).toBeLessThanOrEqual(1);
});

test('memory that several arrays share is told once', () => {
  const shared = new ArrayBuffer(8);
  expect(buffersOf({ a: new Uint8Array(shared), b: [new Float32Array(shared)] })).toEqual([shared]);
});
