import { expect, test } from 'vitest';
import { chooseMain } from './main-file.ts';

const files = (...paths: (string | [string, number])[]) =>
  paths.map((one) => (typeof one === 'string' ? { path: one, size: 1 } : { path: one[0], size: one[1] }));
const main = (...paths: (string | [string, number])[]) => chooseMain(files(...paths))?.main.path ?? null;

test.each([
  [['sky.npy', 'Room.JSON', 'b.exr'], 'Room.JSON'],
  [['a.ply', 'room.scene.json', 'model.glb'], 'room.scene.json'],
  [['package.json', 'model.gltf', 'model.bin'], 'model.gltf'],
  [['teapot.mtl', 'teapot.obj', 'part.stl'], 'teapot.obj'],
  [['deep/down/a.glb', 'b/b.glb'], 'b/b.glb'],
  [['__MACOSX/._a.ply', 'a.stl', '._a.glb'], 'a.stl'],
])('of %j the one to open is %s', (paths, wanted) => {
  expect(main(...paths)).toBe(wanted);
});

test('of equals the largest, and the others are told', () => {
  const chosen = chooseMain(files(['a.stl', 5], ['b.stl', 9], ['c.stl', 9]));
  expect(chosen?.main.path).toBe('b.stl');
  expect(chosen?.others.map(({ path }) => path)).toEqual(['c.stl', 'a.stl']);
});

test('what nobody can open is not chosen', () => {
  expect(main('a.fbx', 'readme.txt')).toBeNull();
  expect(main()).toBeNull();
});
