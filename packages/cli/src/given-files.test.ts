import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { zipSync } from 'fflate';
import { afterAll, expect, test } from 'vitest';
import { filesIn, pathBeside } from './given-files.ts';
import { readScene } from './scene-source.ts';

const folder = mkdtempSync(join(tmpdir(), 'mirrorball-given-'));
afterAll(() => rmSync(folder, { recursive: true }));
const put = (path: string, content: string | Uint8Array) => {
  mkdirSync(join(folder, path, '..'), { recursive: true });
  writeFileSync(join(folder, path), content);
};
const OBJ = 'mtllib Sub Folder\\\\CUBE.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n'.replace('\\\\', '\\');
put('model/cube.obj', OBJ);
put('model/sub folder/cube.mtl', 'newmtl red\nKd 1 0 0\n');
put('model/.git/big.obj', 'x');
put('model.zip', zipSync({ 'm/cube.obj': new TextEncoder().encode(OBJ), 'm/Sub Folder/CUBE.mtl': new TextEncoder().encode('newmtl red\nKd 1 0 0\n') })); // biome-ignore format: one archive

test('a folder gives all of its files but hidden ones, an archive itself, a file none', async () => {
  const given = await filesIn(join(folder, 'model'));
  expect(given!.map(({ path }) => path.replaceAll('\\', '/')).sort()).toEqual(['cube.obj', 'sub folder/cube.mtl']);
  expect((await filesIn(join(folder, 'model.zip')))!.map(({ path }) => path)).toEqual(['model.zip']);
  expect(await filesIn(join(folder, 'model/cube.obj'))).toBeNull();
  expect(await filesIn(join(folder, 'nothing'))).toBeNull();
});

test('names are found whatever their slashes, letter case and escapes; what is not there stays as it was named', async () => {
  const model = join(folder, 'model');
  const right = join(model, 'sub folder', 'cube.mtl');
  for (const name of ['sub folder/cube.mtl', 'Sub%20Folder/Cube.MTL', '.\\sub folder\\cube.mtl'])
    expect(await pathBeside(model, name)).toBe(right);
  expect(await pathBeside(model, '../model/cube.obj')).toBe(join(model, 'cube.obj'));
  expect(await pathBeside(model, 'a/b.png')).toBe(join(model, 'a', 'b.png'));
});

test.each(['model', 'model.zip', 'model/cube.obj'])('%s is opened with its materials', async (path) => {
  const source = await readScene(join(folder, path));
  if ('problems' in source) throw new Error(source.problems[0]!.message);
  expect(source.scene.materials.red!.baseColor).toEqual([1, 0, 0]);
  expect(source.notes).toEqual([]);
});

test('an address is told to be one', async () => {
  await expect(readScene('https://a.b/c.glb')).rejects.toThrow('is an address, and only files are opened');
});
