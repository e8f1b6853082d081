// The built program from outside. `npm run build` is not needed before: it is built here when it is not there or old.
import { existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { builtInScenes } from 'mirrorball/built-in';
import { writePly } from 'mirrorball/mesh-files';
import { fromInterleaved, interleave, pickLayer, readExr, readPfm, writeNpy } from 'mirrorball/picture-files';
import { afterAll, beforeAll, describe, expect, test, vi } from 'vitest';
import { buildCliIfStale } from '../../../scripts/build-cli.mjs';
import { cubeMesh } from '../../../tests/fixtures/meshes/solids.ts';
import { findChromium } from '../src/backends/find-chromium.ts';
import {
  bytesOf,
  folder,
  hasDawn,
  inFolder,
  killedOnTheWay,
  largestDifference,
  mirrorball,
  pixelsOf,
  started,
  stopServer,
} from './command.ts';

// A busy machine may take its time; what hangs is broken.
vi.setConfig({ testTimeout: 300_000 });
expect(await buildCliIfStale()).toBe(0);
const dawn = await hasDawn();
const why = dawn ? '' : ' (skipped: Dawn for Node is not installed or there is no Vulkan driver)';
/** What the tests of films run on: the faster there is. */
const backend = dawn ? 'webgpu' : 'cpu';
const SMALL = '--size 24x16 --light-samples 4';

beforeAll(() => writeFileSync(inFolder('bad.json'), '{"version":2,"name":"Bad","materials":{"a":{"roughness":7}}}'));
afterAll(async () => {
  await stopServer();
  rmSync(folder, { recursive: true, force: true });
});

describe('files of triangles', () => {
  test('are scenes by themselves, with the materials that lie beside them', async () => {
    mkdirSync(inFolder('parts'));
    writeFileSync(inFolder('parts/cube.ply'), writePly(cubeMesh()));
    writeFileSync(inFolder('parts/thing.obj'), 'mtllib thing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n');
    expect(await mirrorball('validate parts/cube.ply')).toMatchObject({ code: 0 });
    const bare = await mirrorball('validate parts/thing.obj');
    expect(bare).toMatchObject({ code: 0 });
    writeFileSync(inFolder('parts/thing.mtl'), 'newmtl red\nKd x\n');
    const broken = await mirrorball('validate parts/thing.obj');
    expect(broken).toMatchObject({ code: 4, stderr: expect.stringContaining('/thing.mtl/line 2') });
  });
});

describe('a sky with an image', () => {
  const skyScene = (image: string) =>
    JSON.stringify({
      version: 1,
      name: 'Sky',
      camera: { eye: [0, 0, 5], target: [0, 0, 0] },
      sky: { image },
      materials: { grey: {} },
      shapes: { ball: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'grey' } },
    });
  const map = (values: readonly number[]) => writeNpy(fromInterleaved(2, 1, ['R', 'G', 'B'], values));
  const put = (name: string, content: string | Uint8Array) => writeFileSync(inFolder(name), content);

  test('is looked for beside the scene; one that is missing or broken is a problem with its place', async () => {
    mkdirSync(inFolder('scenes'));
    mkdirSync(inFolder('maps'));
    put('maps/a.npy', map([1, 2, 3, 4, 5, 6]));
    put('scenes/good.json', skyScene('../maps/a.npy'));
    expect(await mirrorball('validate scenes/good.json')).toMatchObject({ code: 0 });
    put('scenes/missing.json', skyScene('a.npy'));
    const missing = await mirrorball('validate scenes/missing.json');
    expect(missing).toMatchObject({ code: 4, stderr: expect.stringContaining('/sky/image') });
    expect(missing.stderr).toContain('there is no file scenes/a.npy');
    put('scenes/b.npy', 'no array');
    put('scenes/broken.json', skyScene('b.npy'));
    expect(await mirrorball('validate scenes/broken.json')).toMatchObject({ code: 4 });
    put('scenes/folder.json', skyScene('x.npy'));
    mkdirSync(inFolder('scenes/x.npy'));
    expect((await mirrorball('validate scenes/folder.json')).stderr).toContain('x.npy is no file');
  });

  test('belongs to the film: a part of another map does not go on, one of the same map by another name does', async () => {
    const render = () => mirrorball('render sky.json -o sky.part --size 4x4 --spp 2 --resume --backend cpu');
    put('a.npy', map([1, 2, 3, 4, 5, 6]));
    put('sky.json', skyScene('a.npy'));
    expect(await render()).toMatchObject({ code: 0 });
    put('a.npy', map([1, 2, 3, 4, 5, 7]));
    expect(await render()).toMatchObject({ code: 2, stderr: expect.stringContaining('another scene') });
    put('b.npy', map([1, 2, 3, 4, 5, 6]));
    put('sky.json', skyScene('b.npy'));
    expect(await render()).toMatchObject({ code: 0 });
  });
});

describe('meshes', () => {
  const meshScene = (mesh: object) =>
    JSON.stringify({
      version: 1,
      name: 'Cubes',
      camera: { eye: [1, 2, 4], target: [0, 0, 0] },
      materials: { grey: {} },
      meshes: { cube: mesh },
      shapes: { cube: { type: 'mesh', mesh: 'cube', material: 'grey' } },
      lights: { lamp: { type: 'sphere', center: [2, 4, 3], radius: 0.2, radiance: 400 } },
    });
  const put = (name: string, content: string | Uint8Array) => writeFileSync(inFolder(name), content);
  const cube = cubeMesh();

  test('are looked for beside the scene, counted, and told of when they are missing or broken', async () => {
    put('cube.ply', writePly(cube));
    put('cubes.json', meshScene({ file: 'cube.ply' }));
    expect(await mirrorball('validate cubes.json')).toMatchObject({
      code: 0,
      stdout: 'cubes.json: valid, with 12 triangles of 8 vertices.\n',
    });
    const facts = (await mirrorball('info cubes.json --json')).events[0]!;
    expect(facts).toMatchObject({ vertices: 8, triangles: 12, shapes: { mesh: 1 } });
    expect(facts.meshes).toEqual({
      cube: { file: 'cube.ply', vertices: 8, triangles: 12, has: [], from: [-0.5, -0.5, -0.5], to: [0.5, 0.5, 0.5] },
    });
    const file = (await mirrorball('info cube.ply --json')).events[0]!;
    expect(file).toMatchObject({ kind: 'mesh file', vertices: 8, triangles: 12 });
    put('short.ply', writePly(cube).subarray(0, 300));
    expect(await mirrorball('info short.ply')).toMatchObject({ code: 2, stderr: expect.stringContaining('At byte') });
    put('bad-cubes.json', meshScene({ file: 'short.ply' }));
    expect(await mirrorball('validate bad-cubes.json')).toMatchObject({
      code: 4,
      stderr: expect.stringContaining('bad-cubes.json#/meshes/cube/file: The mesh "cube" cannot be used. At byte'),
    });
    put('no-cubes.json', meshScene({ file: 'none.stl' }));
    expect((await mirrorball('validate no-cubes.json')).stderr).toContain('there is no file none.stl');
  });

  test('are drawn by the CPU, and belong to the film', async () => {
    put('cube.ply', writePly(cube));
    put('cubes.json', meshScene({ file: 'cube.ply' }));
    const render = () => mirrorball('render cubes.json -o cubes.part --size 8x8 --spp 2 --resume --backend cpu');
    expect(await render()).toMatchObject({ code: 0 });
    put('cube.ply', writePly({ ...cube, positions: cube.positions.map((x) => 1.5 * x) }));
    expect(await render()).toMatchObject({ code: 2, stderr: expect.stringContaining('another scene') });
    await mirrorball('render cubes.json -o cubes.pfm --size 8x8 --spp 1 --backend cpu');
    expect(Math.max(...readPfm(bytesOf('cubes.pfm')).channels[0]!.data)).toBeGreaterThan(0.1);
  });

  test.runIf(dawn)(`are refused by a GPU, until its kernels know them${why}`, async () => {
    put('cube.ply', writePly(cube));
    put('cubes.json', meshScene({ file: 'cube.ply' }));
    const ended = await mirrorball('render cubes.json -o cubes.exr --size 8x8 --spp 1 --backend webgpu');
    expect(ended).toMatchObject({ code: 1, stderr: expect.stringContaining('The shape "cube" is a mesh') });
    expect(existsSync(inFolder('cubes.exr'))).toBe(false);
  });
});

describe('exit codes', () => {
  test.each([
    ['--help', 0],
    ['render --help', 0],
    ['schema', 0],
    ['validate cube-room', 0],
    ['', 2],
    ['rendr', 2],
    ['render cube-room --frames 0-1', 2],
    ['render cube-room -o x.tiff', 2],
    ['render cube-room -o none/x.exr', 2],
    ['render none.json -o x.exr', 2],
    ['render cube-room -o x.exr --resume --size 4x4 --region 0,0,9,9', 2],
    ['render cube-room -o x.exr --integrator path --backend cpu', 2],
    ['merge none.part -o x.exr', 2],
    ['compare none.exr none.exr', 2],
    ['info none.exr', 2],
    ['render bad.json -o x.exr', 4],
    ['validate bad.json', 4],
  ])('mirrorball %s: %i', async (args, code) => {
    const ended = await mirrorball(args);
    expect([ended.code, ended.stderr]).toEqual([code, expect.not.stringContaining('    at ')]);
    expect(existsSync(inFolder('x.exr'))).toBe(false);
  });

  test.each([
    ['--help', 0],
    ['', 2],
    ['validate bad.json', 4],
  ])('as a process, mirrorball %s: %i', async (args, code) => {
    const [ended, same] = [await started(args), await mirrorball(args)];
    expect([ended.code, ended.stdout, ended.stderr]).toEqual([code, same.stdout, same.stderr]);
  });

  test('3 when nothing can render, and what to install', async () => {
    if (process.platform !== 'linux') return; // others do not reach their GPU by Vulkan
    const ended = await started('render cube-room -o x.exr --size 4x4 --backend webgpu', undefined, {
      VK_ICD_FILENAMES: '/nowhere.json',
    });
    expect(ended.code).toBe(3);
    expect(ended.stderr).toContain('Install the package "webgpu"');
  });
});

test('a bad scene: all problems, each with file and JSON path, for people and for programs', async () => {
  const plain = await mirrorball('validate bad.json cube-room');
  const lines = plain.stderr.trim().split('\n');
  expect(lines.slice(0, -1).map((line) => line.split(': ')[0])).toEqual([
    'bad.json#/version',
    'bad.json#/camera',
    'bad.json#/materials/a/roughness',
    'bad.json#/shapes',
  ]);
  expect(plain.stdout).toBe('cube-room: valid.\n');
  const some = await mirrorball('validate bad.json none.json cube-room');
  expect([some.code, some.stdout]).toEqual([4, 'cube-room: valid.\n']);
  expect(some.stderr).toContain('There is no file none.json');
  expect(some.stderr).toContain('4 problems in bad.json. 1 file cannot be read.');
  const facts = await mirrorball('info none.exr cube-room none.json');
  expect([facts.code, facts.stdout]).toEqual([2, expect.stringContaining('Cube room')]);
  expect(facts.stderr.trim().split('\n')).toHaveLength(3);
  const { events } = await mirrorball('render bad.json -o x.exr --json');
  expect(events.map(({ event, file, path }) => [event, file, path])).toEqual([
    ['problem', 'bad.json', '/version'],
    ['problem', 'bad.json', '/camera'],
    ['problem', 'bad.json', '/materials/a/roughness'],
    ['problem', 'bad.json', '/shapes'],
    ['error', undefined, undefined],
  ]);
});

test('the schema is the one that is committed', async () => {
  const { stdout } = await mirrorball('schema');
  expect(JSON.parse(stdout)).toMatchObject({ title: 'Mirrorball scene' });
});

describe(`films, by ${backend}`, () => {
  const render = (args: string) => mirrorball(`render cube-room --backend ${backend} ${SMALL} ${args}`);

  test('kill -TERM leaves a part and no picture; --resume ends with the film of an undisturbed run, bit for bit', async () => {
    writeFileSync(inFolder('a.exr'), 'the old file');
    const args = `render cube-room --backend ${backend} ${SMALL} --spp 1000000 --json -o`;
    const killed = await started(`${args} a.exr`, killedOnTheWay('SIGTERM'));
    expect(killed.code).toBe(143);
    expect(bytesOf('a.exr').toString()).toBe('the old file');
    const { events } = await mirrorball('info a.exr.part --json');
    const held = Number(String(events[0]!.samples).split('-').at(-1)) + 1;
    expect(held).toBeGreaterThan(0);
    const spp = `--spp ${held + 7}`;
    expect((await render(`${spp} -o a.exr --resume`)).code).toBe(0);
    expect(existsSync(inFolder('a.exr.part'))).toBe(false);
    expect((await render(`${spp} -o b.exr`)).code).toBe(0);
    expect(bytesOf('a.exr').equals(bytesOf('b.exr'))).toBe(true);
    expect(readdirSync(folder).filter((name) => name.endsWith('.tmp'))).toEqual([]);
  });

  test('kill -KILL leaves what was saved on the way; --resume ends with the film of an undisturbed run, bit for bit', async () => {
    const args = `render cube-room --backend ${backend} ${SMALL} --json --save-every 0.1 -o k.exr`;
    const killed = await started(`${args} --spp 1000000`, (stdout, child) => {
      if (stdout.includes('"saved"') && !child.killed) child.kill('SIGKILL');
    });
    expect([killed.code, existsSync(inFolder('k.exr'))]).toEqual([null, false]);
    const { events } = await mirrorball('info k.exr.part --json');
    const held = Number(String(events[0]!.samples).split('-').at(-1)) + 1;
    expect(held).toBeGreaterThan(0);
    const spp = `--spp ${held + 7}`;
    const resumed = await mirrorball(`${args} ${spp} --resume`);
    expect(resumed.events.find(({ event }) => event === 'start')).toMatchObject({ held });
    expect((await render(`${spp} -o l.exr`)).code).toBe(0);
    expect(bytesOf('k.exr').equals(bytesOf('l.exr'))).toBe(true);
    expect(existsSync(inFolder('k.exr.part'))).toBe(false);
    for (const name of readdirSync(folder).filter((file) => file.endsWith('.tmp'))) rmSync(inFolder(name));
  });

  test('what was saved on the way goes when the picture is there, and --save-every 0 saves nothing', async () => {
    const saves = (ended: Awaited<ReturnType<typeof render>>) => ended.events.filter(({ event }) => event === 'saved');
    const often = await render('--spp 40 --json --save-every 0.001 -o m.npy');
    expect(saves(often).length).toBeGreaterThan(0);
    const never = await render('--spp 40 --json --save-every 0 -o n.npy');
    expect(saves(never)).toEqual([]);
    expect(bytesOf('m.npy').equals(bytesOf('n.npy'))).toBe(true);
    expect(existsSync(inFolder('m.npy.part'))).toBe(false);
  });

  test('Ctrl+C ends with 130, and a part of another picture is refused', async () => {
    const args = `render cube-room --backend cpu ${SMALL} --spp 1000000 --json -o c.png`;
    expect((await started(args, killedOnTheWay('SIGINT'))).code).toBe(130);
    const other = await render('--seed 5 --spp 8 -o c.png --resume');
    expect([other.code, other.stderr]).toEqual([2, expect.stringContaining('seed 0 instead of 5')]);
    rmSync(inFolder('c.png.part'));
  });

  test('four ranges merged are one run to 1e-6; overlapping and foreign parts are refused', async () => {
    expect((await render('--spp 60 -o whole.npy')).code).toBe(0);
    const ranges = ['0-14', '15-31', '32-40', '41-59'];
    for (const range of ranges) expect((await render(`--samples ${range} -o p${range}.part`)).code).toBe(0);
    const files = ranges
      .map((range) => `p${range}.part`)
      .reverse()
      .join(' ');
    const merged = await mirrorball(`merge ${files} -o merged.npy`);
    expect([merged.code, merged.stdout]).toEqual([0, expect.stringContaining('60 samples a pixel (0-59)')]);
    expect(largestDifference(pixelsOf('merged.npy'), pixelsOf('whole.npy'))).toBeLessThanOrEqual(1e-6);
    const twice = await mirrorball('merge p0-14.part p15-31.part p0-14.part -o x.exr');
    expect([twice.code, twice.stderr]).toEqual([2, expect.stringContaining('holds samples 0-14, which another')]);
    expect((await render('--samples 60-61 --seed 1 -o foreign.part')).code).toBe(0);
    const foreign = await mirrorball('merge p0-14.part foreign.part -o x.exr');
    expect([foreign.code, foreign.stderr]).toEqual([2, expect.stringContaining('seed 1 instead of 0')]);
    expect(existsSync(inFolder('x.exr'))).toBe(false);
  });

  test('ranges cut where blocks end, at 256 and 512, are one run', async () => {
    expect((await render('--spp 530 -o long.npy')).code).toBe(0);
    const parts = ['0-255', '256-511', '512-529'].map((range) => ({ range, file: `b${range}.part` }));
    for (const { range, file } of parts) expect((await render(`--samples ${range} -o ${file}`)).code).toBe(0);
    const { code, stdout } = await mirrorball(`merge ${parts.map(({ file }) => file).join(' ')} -o blocks.npy`);
    expect([code, stdout]).toEqual([0, expect.stringContaining('530 samples a pixel (0-529)')]);
    expect(bytesOf('blocks.npy').equals(bytesOf('long.npy'))).toBe(true);
  });

  test('--region and --pixel have the values of the whole picture, exactly', async () => {
    expect((await render('--spp 5 -o all.npy')).code).toBe(0);
    expect((await render('--spp 5 --region 7,3,5,11 -o some.npy')).code).toBe(0);
    const [all, some] = [pixelsOf('all.npy'), pixelsOf('some.npy')];
    const cut = Array.from({ length: 11 * 5 * 3 }, (_, i) => {
      const [row, column] = [Math.floor(i / 15), i % 15];
      return all[((3 + row) * 24 + 7) * 3 + column]!;
    });
    expect(Array.from(some)).toEqual(cut);
    const { stdout } = await render('--spp 5 --pixel 20,15');
    const at = (15 * 24 + 20) * 3;
    expect(stdout.trim().split(' ').map(Number)).toEqual(Array.from(all.subarray(at, at + 3)));
  });

  test('a region of a picture that no device could hold is traced alone', async () => {
    const huge = `render materials --backend ${backend} --integrator classic --size 32768x32000 --light-samples 4 --spp 3`;
    const [column, row] = [14_321, 20_007];
    expect((await mirrorball(`${huge} --region ${column - 2},${row - 1},5,3 -o huge.npy`)).code).toBe(0);
    const { stdout } = await mirrorball(`${huge} --pixel ${column},${row}`);
    const pixel = stdout.trim().split(' ').map(Number);
    expect(Math.max(...pixel)).toBeGreaterThan(0);
    expect(Array.from(pixelsOf('huge.npy').subarray(21, 24))).toEqual(pixel);
  });

  test('regions merged are the whole picture, samples and all; where one is missing, with a word only', async () => {
    const tiles = ['0,0,10,16', '10,0,14,9', '10,9,14,7'];
    const files = tiles.map((_, i) => `tile${i}.part`);
    for (const [i, tile] of tiles.entries())
      expect((await render(`--spp 40 --region ${tile} -o ${files[i]}`)).code).toBe(0);
    expect((await render('--spp 40 -o tiled.npy')).code).toBe(0);
    const [first, second, third] = files;
    const all = await mirrorball(`merge ${third} ${first} ${second} -o tiles.npy`);
    expect([all.code, all.stdout]).toEqual([0, expect.stringContaining('3 regions, 40 samples a pixel (0-39)')]);
    expect(bytesOf('tiles.npy').equals(bytesOf('tiled.npy'))).toBe(true);

    // A part of them goes on like one of the whole picture.
    expect((await mirrorball(`merge ${files.join(' ')} -o tiles.part`)).code).toBe(0);
    expect((await render('--spp 45 -o tiles.part --resume')).code).toBe(0);
    expect((await render('--spp 45 -o more.npy')).code).toBe(0);
    expect((await mirrorball('merge tiles.part -o gone-on.npy')).code).toBe(0);
    expect(largestDifference(pixelsOf('gone-on.npy'), pixelsOf('more.npy'))).toBeLessThanOrEqual(1e-6);

    const gap = await mirrorball(`merge ${first} ${third} -o gap.npy`);
    expect([gap.code, existsSync(inFolder('gap.npy'))]).toEqual([2, false]);
    expect(gap.stderr).toContain('126 of 384 pixels are in no part: 10,0,14,9. Render these regions');
    const allowed = await mirrorball(`merge ${first} ${third} -o gap.npy --allow-gaps --json`);
    expect([allowed.code, allowed.events.at(-1)!.gaps]).toEqual([0, [{ x: 10, y: 0, width: 14, height: 9 }]]);
    const [whole, holed] = [pixelsOf('tiles.npy'), pixelsOf('gap.npy')];
    const within = (i: number) => Math.floor(i / 3) % 24 < 10 || i >= 9 * 24 * 3;
    expect(Array.from(holed)).toEqual(Array.from(whole, (value, i) => (within(i) ? value : 0)));
    // One region alone is a picture of its own, but where gaps are allowed.
    expect((await mirrorball(`merge ${first} -o alone.npy`)).code).toBe(0);
    expect(pixelsOf('alone.npy')).toHaveLength(10 * 16 * 3);
    expect((await mirrorball(`merge ${first} -o alone.npy --allow-gaps`)).code).toBe(0);
    expect(pixelsOf('alone.npy')).toHaveLength(whole.length);
    expect((await mirrorball(`merge ${first} -o x.part --allow-gaps`)).code).toBe(2);

    expect((await render('--spp 40 --region 8,0,4,16 -o across.part')).code).toBe(0);
    const across = await mirrorball(`merge ${files.join(' ')} across.part -o x.exr`);
    expect([across.code, across.stderr]).toEqual([2, expect.stringContaining('hold some of the same pixels')]);
  });

  test('frames are pictures of their times; what is there is kept by --resume', async () => {
    const scene = `render moving-shadows --backend ${backend} --size 16x12 --light-samples 1 --spp 1`;
    expect((await mirrorball(`${scene} --frames 1-2 --fps 2 -o f.npy`)).code).toBe(0);
    expect((await mirrorball(`${scene} --time 1 -o g.npy`)).code).toBe(0);
    expect(bytesOf('f.0002.npy').equals(bytesOf('g.npy'))).toBe(true);
    expect(bytesOf('f.0001.npy').equals(bytesOf('g.npy'))).toBe(false);
    const { events } = await mirrorball(`${scene} --frames 1-3 --fps 2 -o f.npy --resume --json`);
    expect(events.filter(({ event }) => event === 'kept')).toHaveLength(2);
    expect(existsSync(inFolder('f.0003.npy'))).toBe(true);
  });

  test('--resume keeps a finished picture, and refuses one of another scene or with fewer samples, before it traces', async () => {
    const args = `--backend ${backend} --size 16x12 --light-samples 1 --frames 0-2 -o kept####.png`;
    expect((await mirrorball(`render moving-shadows ${args} --spp 2`)).code).toBe(0);
    rmSync(inFolder('kept0000.png'));
    const before = bytesOf('kept0001.png');
    const fewer = await mirrorball(`render moving-shadows ${args} --spp 8 --resume`);
    expect([fewer.code, fewer.stderr]).toEqual([2, expect.stringContaining('only the samples 0-1 of 0-7')]);
    const other = await mirrorball(`render cube-room ${args} --spp 2 --resume`);
    expect([other.code, other.stderr]).toEqual([2, expect.stringContaining('it has another scene')]);
    expect([existsSync(inFolder('kept0000.png')), bytesOf('kept0001.png').equals(before)]).toEqual([false, true]);
    const { events } = await mirrorball(`render moving-shadows ${args} --spp 1 --resume --json`);
    expect(events.filter(({ event }) => event === 'kept')).toHaveLength(2);
    const single = await mirrorball(
      `render moving-shadows ${args.replace('--frames 0-2 -o kept####', '-o kept0000')} --spp 1 --resume`,
    );
    expect([single.code, single.stderr]).toEqual([0, 'kept0000.png is there already.\n']);
  });

  test('with --json every line is an object, and the last says what came of it', async () => {
    const { events, stderr, code } = await mirrorball(
      `render cube-room --backend ${backend} ${SMALL} --spp 64 -o j.png --bits 16 --json`,
    );
    expect(code).toBe(0);
    expect(events.map(({ event }) => event).filter((event) => event !== 'progress')).toEqual([
      'backend',
      'start',
      'done',
    ]);
    expect(events.at(-1)).toMatchObject({ samples: 64, ranges: [{ first: 0, last: 63 }], ending: 'all samples' });
    expect(events.at(-1)!.error).toBeGreaterThan(0);
    expect(stderr).not.toContain('Tracing');
    const facts = (await mirrorball('info j.png --json')).events[0]!;
    expect(JSON.parse(String(facts.Render))).toMatchObject({ samples: '0-63', integrator: 'classic', width: 24 });
    expect((JSON.parse(String(facts.Scene)) as { name: string }).name).toBe('Cube room');
  });

  test('plain output has no colour, no cursor movement and no bar under NO_COLOR in a pipe', async () => {
    const { stdout, stderr } = await started(`render cube-room --backend ${backend} ${SMALL} --spp 2 -o n.hdr`);
    expect(stdout + stderr).not.toContain('\u001b');
    expect(stdout).toContain('n.hdr: 2 samples a pixel');
  });

  test('stops when the error is reached', async () => {
    const { events } = await mirrorball(
      `render cube-room --backend ${backend} ${SMALL} --until-error 0.5 -o e.exr --json`,
    );
    expect(events.at(-1)).toMatchObject({ ending: 'error reached', samples: 64 });
  });
});

test.skipIf(!dawn)(`paths: 256 samples are four times 64, and a picture is its parts${why}`, async () => {
  const render = (args: string) => mirrorball(`render materials --backend webgpu --size 24x16 ${args}`);
  expect((await render('--spp 256 -o long.npy')).code).toBe(0);
  const ranges = ['192-255', '0-63', '128-191', '64-127'];
  for (const range of ranges) expect((await render(`--samples ${range} -o q${range}.part`)).code).toBe(0);
  const files = ranges.map((range) => `q${range}.part`).join(' ');
  expect((await mirrorball(`merge ${files} -o short.npy`)).code).toBe(0);
  const long = pixelsOf('long.npy');
  expect(largestDifference(pixelsOf('short.npy'), long)).toBeLessThanOrEqual(1e-6);
  const union = new Float32Array(long.length).fill(Number.NaN);
  for (const [x, y, width, height] of [
    [11, 0, 13, 16],
    [0, 0, 11, 16],
  ] as const) {
    expect((await render(`--spp 256 --region ${x},${y},${width},${height} -o r.npy`)).code).toBe(0);
    const part = pixelsOf('r.npy');
    for (let row = 0; row < height; row++)
      union.set(part.subarray(row * width * 3, (row + 1) * width * 3), ((y + row) * 24 + x) * 3);
  }
  expect(Array.from(union)).toEqual(Array.from(long));
});

/** The tolerances of the browser's parity test: rounding moves edges, and nothing else. */
function expectParity(a: Float32Array, b: Float32Array): void {
  const differences = Array.from(a, (value, i) => Math.abs(value - b[i]!));
  expect(differences.reduce((sum, d) => sum + d, 0) / differences.length).toBeLessThan(1e-3);
  expect(differences.filter((d) => d > 0.02).length / differences.length).toBeLessThan(0.005);
}
const picture = `render mirror-blocks --size 32x24 --light-samples 4 --spp 4 --time 0.4`;

test.skipIf(!dawn)(`cpu = webgpu${why}`, async () => {
  for (const name of ['cpu', 'webgpu'])
    expect((await mirrorball(`${picture} --backend ${name} -o ${name}.npy`)).code).toBe(0);
  expectParity(pixelsOf('webgpu.npy'), pixelsOf('cpu.npy'));
  const { stdout } = await mirrorball('compare webgpu.npy cpu.npy');
  expect(stdout).toMatch(/^relMSE/);
});

const chromium = findChromium() !== null;
test.skipIf(!chromium)(`cpu = chromium${chromium ? '' : ' (skipped: no Chromium is installed)'}`, async () => {
  for (const name of ['cpu', 'chromium'])
    expect((await mirrorball(`${picture} --backend ${name} -o ${name}.npy`)).code).toBe(0);
  expectParity(pixelsOf('chromium.npy'), pixelsOf('cpu.npy'));
});

describe(`AOVs, by ${backend}`, () => {
  const path = dawn ? '--integrator path --max-depth 5' : '--light-samples 1';
  const render = (args: string, integrator = '--integrator classic --light-samples 1') =>
    mirrorball(`render cube-room --backend ${backend} --size 20x14 ${integrator} ${args}`);
  const layer = (file: string, name: string) => interleave(pickLayer(readExr(bytesOf(file)), name));

  test('one EXR has them as layers: direct + indirect = the picture, and places fit depths and numbers', async () => {
    const names =
      'albedo,normal,geometric-normal,depth,position,primitive-id,material-id,direct,indirect,samples,error';
    const { code, stderr } = await render(`--spp 34 --half -o aov.exr --aov ${names}`, path);
    expect([code, stderr]).toEqual([0, expect.any(String)]);
    const [direct, indirect, picture] = ['direct', 'indirect', ''].map((name) => layer('aov.exr', name));
    const sum = direct!.map((value, i) => value + indirect![i]!);
    // All three are rounded to 16 bits.
    expect(largestDifference(sum, picture!)).toBeLessThan(2e-3);
    expect(Math.max(...indirect!)).toBeGreaterThan(0.01);
    expect(new Set(layer('aov.exr', 'samples'))).toEqual(new Set([34]));
    expect(Math.max(...layer('aov.exr', 'error'))).toBeGreaterThan(0);
    const { eye, target } = builtInScenes.find(({ id }) => id === 'cube-room')!.scene.camera;
    const forward = target.map((x, c) => x - eye[c]!);
    const [depth, position] = [layer('aov.exr', 'depth'), layer('aov.exr', 'P')];
    depth.forEach((z, i) => {
      const along = forward.reduce((d, f, c) => d + f * (position[3 * i + c]! - eye[c]!), 0) / Math.hypot(...forward);
      expect(z).toBeCloseTo(along, 4);
    });
    const facts = (await mirrorball('info aov.exr --json')).events[0]!;
    const ids = JSON.parse(String(facts.PrimitiveIds)) as string[];
    expect(Math.max(...layer('aov.exr', 'primitiveId'))).toBeLessThan(ids.length);
    expect(ids[1]).toMatch(/^\/shapes\//);
  });

  test('merged parts have the AOVs of the whole picture, and so has a part of the picture', async () => {
    const aov = '--aov depth,albedo,indirect';
    expect((await render(`--spp 12 -o one.npy ${aov}`)).code).toBe(0);
    for (const range of ['0-4', '5-11']) expect((await render(`--samples ${range} -o q${range}.part`)).code).toBe(0);
    const merged = await mirrorball(`merge q0-4.part q5-11.part -o two.npy --backend ${backend} ${aov}`);
    expect([merged.code, merged.stderr]).toEqual([0, expect.any(String)]);
    for (const name of ['depth', 'albedo', 'indirect'])
      expect(largestDifference(pixelsOf(`two.${name}.npy`), pixelsOf(`one.${name}.npy`))).toBeLessThan(1e-5);
    for (const [name, tile] of Object.entries({ left: '0,0,7,14', right: '7,0,13,14' }))
      expect((await render(`--spp 12 --region ${tile} -o ${name}.part`)).code).toBe(0);
    const tiled = `merge right.part left.part --backend ${backend} ${aov},samples`;
    expect((await mirrorball(`${tiled} -o tiles.npy`)).code).toBe(0);
    for (const name of ['depth', 'albedo', 'indirect'])
      expect(pixelsOf(`tiles.${name}.npy`)).toEqual(pixelsOf(`one.${name}.npy`));
    expect((await mirrorball(`merge right.part --backend ${backend} ${aov},samples -o g.exr --allow-gaps`)).code).toBe(
      0,
    );
    const counts = layer('g.exr', 'samples');
    expect([counts.length, counts[6], counts[7]]).toEqual([20 * 14, 0, 12]);
    expect((await render(`--spp 12 -o cut.npy --region 3,2,5,4 ${aov}`)).code).toBe(0);
    const [cut, whole] = [pixelsOf('cut.depth.npy'), pixelsOf('one.depth.npy')];
    expect(Array.from(cut)).toEqual(
      Array.from({ length: 20 }, (_, i) => whole[(2 + Math.floor(i / 5)) * 20 + 3 + (i % 5)]!),
    );
  });

  test('files of their own where a format has no layers; what it cannot hold is refused before any work', async () => {
    const { code, events } = await render('--spp 2 -o s.png --aov albedo,direct --json');
    expect([code, events.at(-1)!.files]).toEqual([0, ['s.png', 's.albedo.png', 's.direct.png']]);
    expect(existsSync(inFolder('s.direct.png'))).toBe(true);
    expect((await render('--spp 2 -o n.pfm --aov normal,depth')).code).toBe(0);
    expect(readPfm(bytesOf('n.normal.pfm')).channels).toHaveLength(3);
    const again = await render('--spp 2 -o n.pfm --resume --aov position');
    expect([again.code, again.stderr]).toEqual([2, expect.stringContaining('without the AOVs position')]);
    const refused = await render('--spp 2 -o t.png --aov depth');
    expect([refused.code, refused.stderr]).toEqual([2, expect.stringContaining('Write .exr, .npy or .pfm')]);
    const strange = await render('--spp 2 -o t.exr --aov depht');
    expect([strange.code, strange.stderr]).toEqual([2, expect.stringContaining('not "depht"')]);
  });
});

test('bench measures both integrators on a GPU, the classic one alone on the CPU', async () => {
  const args = '--size 16x12 --spp 3 --seconds 0.2 --scene cube-room --json';
  const { events, code } = await mirrorball(`bench --backend ${backend} ${args}`);
  expect(code).toBe(0);
  const measured = events.filter(({ event }) => event === 'measured');
  expect(measured.map(({ integrator }) => integrator)).toEqual(dawn ? ['classic', 'path'] : ['classic']);
  for (const { samples, samplesPerSecond, firstSampleSeconds } of measured) {
    expect(samples).toBeGreaterThan(0);
    expect(samplesPerSecond).toBeGreaterThan(0);
    expect(firstSampleSeconds).toBeGreaterThan(0);
  }
});

test('doctor names each backend', async () => {
  const { events, code } = await mirrorball('doctor --json');
  expect(events.filter(({ event }) => event === 'finding').map(({ name }) => name)).toEqual([
    'webgpu',
    'chromium',
    'cpu',
  ]);
  expect([0, 3]).toContain(code);
});
