import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { builtInScenes } from 'mirrorball/built-in';
import { fromInterleaved, writeExr } from 'mirrorball/picture-files';
import { afterAll, beforeAll, describe, expect, test } from 'vitest';
import { triangleFile } from '../../../tests/fixtures/gltf.ts';
import { convert } from './commands/convert.ts';
import { info } from './commands/info.ts';
import { CommandError } from './exit-codes.ts';
import { checkChoices, chosen } from './scene-choices.ts';
import { requireSceneFile } from './scene-source.ts';
import { openTerminal } from './terminal.ts';

const folder = mkdtempSync(join(tmpdir(), 'mirrorball-choices-'));
const inFolder = (name: string): string => join(folder, name);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** A triangle with two clips, two cameras of which one moves, and two looks. */
const model = triangleFile((f) => {
  const sampler = { input: f.floats('SCALAR', 0, 1), output: f.floats('VEC3', 0, 0, 0, 1, 1, 1) };
  for (const name of ['walk', 'run'])
    f.add('animations', { name, samplers: [sampler], channels: [{ sampler: 0, target: { node: 0, path: 'translation' } }] }); // biome-ignore format: one thing
  for (const name of ['near', 'far']) {
    const camera = f.add('cameras', { name, type: 'perspective', perspective: { yfov: 1, znear: 0.1 } });
    f.json.scenes[0].nodes.push(f.add('nodes', { name: `${name} node`, translation: [0, 0, 5], camera }));
  }
  f.add('materials', { name: 'dark' });
  f.json.extensions = { KHR_materials_variants: { variants: [{ name: 'night' }] } };
  f.json.meshes[0].primitives[0].extensions = {
    KHR_materials_variants: { mappings: [{ material: 0, variants: [0] }] },
  };
}).glb();

const said = { stdout: '', stderr: '' };
const stream = (key: 'stdout' | 'stderr') => ({
  write: (text: string) => {
    said[key] += text;
    return true;
  },
});
function terminal(json = false) {
  said.stdout = said.stderr = '';
  return openTerminal(json, {}, { stdout: stream('stdout'), stderr: stream('stderr') });
}

beforeAll(() => {
  writeFileSync(inFolder('model.glb'), model);
  writeFileSync(inFolder('studio.exr'), writeExr(fromInterleaved(2, 1, ['R', 'G', 'B'], [1, 2, 3, 4, 5, 6])));
});
const read = (file = 'model.glb') => requireSceneFile(inFolder(file), terminal());
const choose = async (options: Parameters<typeof chosen>[1]) => chosen(await read(), options, terminal());
const refused = (options: Parameters<typeof chosen>[1]) =>
  choose(options).then(
    () => 'taken',
    (error: CommandError) => `${error.code} ${error.message}`,
  );

describe('choices', () => {
  test('clip, variant, camera', async () => {
    expect((await choose({})).clip).toBe('walk');
    expect((await choose({ clip: 'run' })).clip).toBe('run');
    expect((await choose({ clip: 'none' })).clip).toBeUndefined();
    expect((await choose({ variant: 'night' })).shapes.thing!.material).toBe('dark');
    expect((await choose({})).camera.node).toBe('near node');
    expect((await choose({ camera: 'far' })).camera.node).toBe('far node');
    expect((await choose({ camera: 'frame' })).camera.node).toBeUndefined();
  });

  test('the light around', async () => {
    const { sky } = await choose({ env: inFolder('studio.exr'), envRotation: 90, envStrength: 2 });
    expect(sky).toMatchObject({ image: 'studio.exr', rotation: 90, scale: 2, map: { width: 2, height: 1 } });
    expect(Array.from(sky.map!.data)).toEqual([1, 2, 3, 4, 5, 6]);
    // The model's own studio may be turned too.
    expect((await choose({ envRotation: 45 })).sky).toMatchObject({ rotation: 45, scale: 1 });
    expect(() => checkChoices({ env: 'a.exr' }, { integrator: 'classic' })).toThrow('--integrator path');
  });

  test('what is not there is told with what is', async () => {
    expect(await refused({ clip: 'fly' })).toBe('2 The scene has no clip "fly", but walk, run (none: none plays).');
    expect(await refused({ camera: 'side' })).toContain('but near, far (frame: one that shows everything)');
    expect(await refused({ variant: 'dusk' })).toContain('but night.');
    expect(await refused({ env: inFolder('none.exr') })).toMatch(/^2 --env: there is no file .*none\.exr\.$/);
    expect(await refused({ env: inFolder('model.glb') })).toMatch(/^2 The picture .* cannot be used/);
    const room = builtInScenes[0]!.scene;
    await expect(chosen(room, { envStrength: 2 }, terminal())).rejects.toThrow('give one by --env');
    await expect(chosen(room, { camera: 'top' }, terminal())).rejects.toThrow('The scene has no cameras');
  });
});

const options = { time: 0, size: { width: 8, height: 4 }, spp: 4 };
const write = (from: string, to: string, more = {}) => convert(from, inFolder(to), { ...options, ...more }, terminal());

describe('convert', () => {
  test('a model to a scene file that names it, and that to GLB again', async () => {
    await write(inFolder('model.glb'), 'model.json', { clip: 'run', env: inFolder('studio.exr') });
    const file = JSON.parse(readFileSync(inFolder('model.json'), 'utf8'));
    expect(file).toMatchObject({ models: { model: { file: 'model.glb' } }, clip: 'model/run', sky: { image: 'model.sky.exr' } }); // biome-ignore format: one thing
    const scene = await read('model.json');
    expect(Object.keys(scene.shapes)).toEqual(['model/thing']);
    expect(Array.from(scene.sky.map!.data)).toEqual([1, 2, 3, 4, 5, 6]);
    await write(inFolder('model.json'), 'again.glb');
    expect(said.stderr).toContain('Lost: glTF has no sky');
    expect((await read('again.glb')).clip).toBe('model/run');
  });

  test('a scene to Mitsuba, with what it needs beside it', async () => {
    await write('materials', 'm.xml');
    const files = said.stdout.trim().split('\n');
    expect(files).toEqual(expect.arrayContaining([inFolder('m.xml'), inFolder('m.py')]));
    for (const name of files) expect(readFileSync(name).length).toBeGreaterThan(0);
    expect(readFileSync(inFolder('m.xml'), 'utf8')).toContain('"width" value="8"');
  });

  test('a scene file in another folder finds its files still', async () => {
    writeFileSync(inFolder('a.json'), JSON.stringify({ ...JSON.parse(readFileSync(inFolder('model.json'), 'utf8')) }));
    await write(inFolder('a.json'), 'b.json');
    expect(JSON.parse(readFileSync(inFolder('b.json'), 'utf8')).models.model.file).toBe('model.glb');
  });

  test('other formats, a folder that is made, and nowhere to write', async () => {
    await expect(write('materials', 'm.obj')).rejects.toThrow('.glb, .xml or .json');
    await write('materials', 'made/for/m.glb');
    expect(readFileSync(inFolder('made/for/m.glb')).length).toBeGreaterThan(0);
    await expect(write('materials', 'made/for/m.glb/m.glb')).rejects.toThrow(CommandError);
    await expect(write('materials', 'made/for/m.glb/deep/m.glb')).rejects.toThrow('m.glb is no folder');
  });
});

test('info tells what a model has, and what it takes', async () => {
  await info([inFolder('model.glb')], terminal(true));
  expect(JSON.parse(said.stdout)).toMatchObject({
    kind: 'model',
    vertices: 3,
    triangles: 1,
    clips: { walk: '1 s', run: '1 s' },
    cameras: ['near', 'far'],
    variants: ['night'],
    memory: { geometry: '0.00 MB', animation: '0.00 MB' },
  });
  await info([inFolder('model.glb')], terminal());
  expect(said.stdout).toContain('  triangles    1\n');
});
