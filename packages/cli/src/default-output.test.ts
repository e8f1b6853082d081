import { expect, test } from 'vitest';
import { defaultOutput } from './default-output.ts';

test.each([
  ['model.glb', [], 'model.png'],
  ['folder/My room.scene.json', [], 'My room.png'],
  ['cube-room', [], 'cube-room.png'],
  ['models/fox/', [], 'fox.png'],
  ['-', [], 'scene.png'],
  ['a.b.glb', ['a.b.png', 'a.b-2.png'], 'a.b-3.png'],
])('of %s, where there is %j, the picture is %s', (scene, taken: readonly string[], wanted) => {
  expect(defaultOutput(scene, (file) => taken.includes(file))).toBe(wanted);
});
