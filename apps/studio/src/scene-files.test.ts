import { fromInterleaved, writeNpy } from 'mirrorball/picture-files';
import { expect, test } from 'vitest';
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
