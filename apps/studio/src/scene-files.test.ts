import { writePly } from 'mirrorball/mesh-files';
import { fromInterleaved, writeNpy } from 'mirrorball/picture-files';
import { expect, test } from 'vitest';
import { cubeMesh } from '../../../tests/fixtures/meshes/solids.ts';
import { readSceneFile, sortFiles } from './scene-files.ts';

const sceneFile = (image: string) =>
  new File(
    [
      JSON.stringify({
        version: 1,
        name: 'Sky',
        camera: { eye: [0, 0, 5], target: [0, 0, 0] },
        sky: { image },
        materials: { grey: {} },
        shapes: { ball: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'grey' } },
      }),
    ],
    'sky.scene.json',
  );
const mapFile = () => new File([writeNpy(fromInterleaved(2, 1, ['R', 'G', 'B'], [1, 2, 3, 4, 5, 6]))], 'sky.npy');

test('of files that come together the scene is the one in JSON, whatever their order', () => {
  const files = [{ name: 'sky.npy' }, { name: 'Room.JSON' }, { name: 'b.exr' }];
  expect(sortFiles(files)).toEqual({ scene: files[1], others: [files[0], files[2]] });
  expect(sortFiles([{ name: 'room' }])).toEqual({ scene: { name: 'room' }, others: [] });
  expect(sortFiles([])).toEqual({ scene: undefined, others: [] });
});

test('a map that comes with its scene is found by its name', async () => {
  const read = await readSceneFile(sceneFile('../maps/sky.npy'), [mapFile()]);
  expect(read.ok && read.scene.sky.map).toMatchObject({ width: 2, height: 1 });
});

test('a map that did not come with it is a problem that says what to do', async () => {
  const read = await readSceneFile(sceneFile('other.npy'), [mapFile()]);
  expect(read).toMatchObject({ ok: false, problems: [{ path: '/sky/image' }] });
  if (!read.ok) expect(read.problems[0]!.message).toContain('open other.npy together with the scene');
});

test('meshes that come with their scene are found by their names, or missed with what to do', async () => {
  const scene = {
    version: 1,
    name: 'Cubes',
    camera: { eye: [0, 0, 5], target: [0, 0, 0] },
    materials: { grey: {} },
    meshes: { cube: { file: 'models/cube.ply' }, ball: { file: 'ball.obj' } },
    shapes: { cube: { type: 'mesh', mesh: 'cube', material: 'grey' } },
  };
  const file = new File([JSON.stringify(scene)], 'cubes.json');
  const cube = new File([writePly(cubeMesh())], 'cube.ply');
  const ball = new File(['v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'], 'ball.obj');
  const read = await readSceneFile(file, [ball, cube]);
  expect(read.ok && read.scene.meshes!.cube!.data).toEqual(cubeMesh());
  const missed = await readSceneFile(file, [cube]);
  expect(missed).toMatchObject({ ok: false, problems: [{ path: '/meshes/ball/file' }] });
  if (!missed.ok) expect(missed.problems[0]!.message).toContain('open ball.obj together with the scene');
});
