import { expect, test } from 'vitest';
import { FileSet, type GivenFile, MOST_FILE_BYTES } from './file-set.ts';

const file = (path: string, size = 1): GivenFile => ({ path, size, read: async () => new TextEncoder().encode(path) });
const set = (...paths: string[]) => new FileSet(paths.map((path) => file(path)));

test('files are found from the folder of the one that names them', () => {
  const files = set('fox/fox.gltf', 'fox/textures/a.png', 'other/textures/a.png', 'b.png');
  expect(files.beside('fox/fox.gltf', 'textures/a.png').path).toBe('fox/textures/a.png');
  expect(files.beside('fox/fox.gltf', './textures//a.png').path).toBe('fox/textures/a.png');
  expect(files.beside('fox/fox.gltf', '../b.png').path).toBe('b.png');
  expect(files.beside('fox/fox.gltf', '../other/textures/a.png').path).toBe('other/textures/a.png');
  // Above the top there is nothing, so a path that leads there begins at the top.
  expect(files.beside('fox/fox.gltf', '../../../b.png').path).toBe('b.png');
});

test.each([
  ['capital letters', 'Textures/Bark.PNG', 'textures/bark.png'],
  ['escapes that the name has not', 'tex/my bark.png', 'tex/my%20bark.png'],
  ['escapes that only the name has', 'tex/my%20bark.png', 'tex/my bark.png'],
  ['a % that stands for itself', '100%.png', '100%.png'],
  ['letters that are composed in two ways', 'a\u0308.png', '\u00e4.png'],
  ['backslashes', 'tex/a.png', 'tex\\a.png'],
])('%s are no hindrance', (_, path, name) => {
  expect(set(`m/${path}`, 'm/m.gltf').beside('m/m.gltf', name).path).toBe(`m/${path}`);
});

test('the file of the exact place goes before others of its name', () => {
  const files = set('m/a.gltf', 'm/x/t.png', 'm/y/t.png');
  expect(files.beside('m/a.gltf', 'y/t.png').path).toBe('m/y/t.png');
});

test('what is somewhere else is taken if there is only one of its name', () => {
  expect(set('a.gltf', 't.png').beside('a.gltf', 'textures/t.png').path).toBe('t.png');
  expect(() => set('a.gltf', 'x/t.png', 'y/t.png').beside('a.gltf', 't.png')).toThrow('2 files of this name');
});

test('what is missing is told with what to do', () => {
  expect(() => set('m/a.gltf').beside('m/a.gltf', 'textures/t.png')).toThrow('open t.png together with a.gltf');
});

test('a file that is too large is not read', async () => {
  const large = { ...file('a.bin', MOST_FILE_BYTES + 1), read: () => Promise.reject(new Error('was read')) };
  await expect(new FileSet([large]).readBeside('a.gltf', 'a.bin')).rejects.toThrow('where at most 1073741824 are read');
});
