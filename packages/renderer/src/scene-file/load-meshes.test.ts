import { expect, test } from 'vitest';
import { displacedSphere } from '../../../../tests/fixtures/meshes/landscapes.ts';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { stlBinary } from '../../../../tests/fixtures/meshes/stl-files.ts';
import { writePly } from '../mesh-file/ply/write-ply.ts';
import type { Scene } from '../scene/scene.ts';
import { loadFiles } from './load-files.ts';
import { parseScene } from './parse-scene.ts';
import { requireScene } from './require-scene.ts';
import { writeScene } from './write-scene.ts';

const POT = `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nusemtl iron\nf 1 2 3\nusemtl wood\nf 1 3 4\nf 1 3 2\n`;
const ball = displacedSphere({ triangles: 60 });
const FILES: Readonly<Record<string, Uint8Array>> = {
  'cube.ply': writePly(cubeMesh()),
  'Ball.PLY': writePly(ball),
  'parts/pot.obj': new TextEncoder().encode(POT),
  'cube.stl': stlBinary(cubeMesh()),
  'broken.ply': writePly(cubeMesh()).subarray(0, 300),
  'bad.obj': new TextEncoder().encode('v 0 0 0\nf 1 2 3\nf 4 5 6\n'),
  'flat.obj': new TextEncoder().encode(`${POT}f 1 1 2\n`),
};

function sceneWith(meshes: object): Scene {
  const shapes = Object.fromEntries(
    Object.keys(meshes).map((mesh) => [mesh, { type: 'mesh', mesh, material: 'grey' }]),
  );
  const camera = { eye: [0, 0, 5], target: [0, 0, 0] };
  const parsed = parseScene({ version: 1, name: 'meshes', camera, materials: { grey: {} }, meshes, shapes });
  if (!parsed.ok) throw new Error(parsed.problems.map(({ message }) => message).join('\n'));
  return parsed.scene;
}
async function load(meshes: object) {
  const asked: string[] = [];
  const loaded = await loadFiles(sceneWith(meshes), async (name) => {
    asked.push(name);
    const bytes = FILES[name];
    if (!bytes) throw new Error('there is no such file');
    return bytes;
  });
  return { loaded, asked };
}
async function meshesOf(meshes: object) {
  const { loaded } = await load(meshes);
  if (!loaded.ok) throw new Error(loaded.problems.map(({ message }) => message).join('\n'));
  return loaded.scene.meshes!;
}
async function problemsOf(meshes: object) {
  const { loaded } = await load(meshes);
  return loaded.ok ? [] : loaded.problems;
}

test('files of three kinds, each read once, also where several meshes are of it', async () => {
  const sources = {
    cube: { file: 'cube.ply' },
    smooth: { file: 'cube.ply', shading: 'smooth' },
    block: { file: 'cube.stl' },
    lid: { file: 'parts/pot.obj', part: 'iron' },
    handle: { file: 'parts/pot.obj', part: 'wood' },
    ball: { file: 'Ball.PLY', shading: 'flat' },
  };
  const { loaded, asked } = await load(sources);
  if (!loaded.ok) throw new Error(loaded.problems[0]!.message);
  expect(asked).toEqual(['cube.ply', 'cube.stl', 'parts/pot.obj', 'Ball.PLY']);
  const { cube, smooth, block, lid, handle, ball: flat } = loaded.scene.meshes!;
  expect(cube!.data).toEqual(cubeMesh());
  expect([cube!.file, cube!.shading]).toEqual(['cube.ply', 'auto']);
  expect(smooth!.data!.normals).toHaveLength(24);
  expect(block!.data!.indices).toHaveLength(36);
  expect([lid!.data!.indices.length, handle!.data!.indices.length]).toEqual([3, 6]);
  expect([flat!.data!.normals, flat!.data!.positions]).toEqual([undefined, ball.positions]);
  // It is as good as any scene that was read, is not loaded again, and is written without its content.
  expect(requireScene(loaded.scene)).toBe(loaded.scene);
  expect((await loadFiles(loaded.scene, () => Promise.reject(new Error('asked')))).ok).toBe(true);
  expect(parseScene(writeScene(loaded.scene))).toEqual({ ok: true, scene: sceneWith(sources) });
});

test('all parts of a file as one mesh', async () => {
  const { pot } = await meshesOf({ pot: { file: 'parts/pot.obj' } });
  expect(pot!.data!.indices).toHaveLength(9);
});

test('what was left out is told once', async () => {
  const { loaded } = await load({ a: { file: 'flat.obj' }, b: { file: 'flat.obj', shading: 'smooth' } });
  expect(loaded.ok && loaded.notes).toEqual(['The mesh file "flat.obj": Left out: 1 triangle without area.']);
});

test('all that is wrong with all files, each at its place', async () => {
  const problems = await problemsOf({
    gone: { file: 'gone.ply' },
    broken: { file: 'broken.ply' },
    bad: { file: 'bad.obj' },
    cap: { file: 'parts/pot.obj', part: 'wod' },
    none: { file: 'cube.stl', part: 'lid' },
    good: { file: 'cube.ply' },
  });
  const told = problems.map(({ path, message }) => `${path} ${message}`);
  expect(told[0]).toBe('/meshes/gone/file The mesh "gone" cannot be read from "gone.ply": there is no such file.');
  expect(told[1]).toMatch(
    /^\/meshes\/broken\/file The mesh "broken" cannot be used\. At byte 292 "broken.ply" has a list of 3 items, and 7 bytes left/,
  );
  expect(told.filter((line) => line.startsWith('/meshes/bad/file'))).toHaveLength(5);
  expect(told[2]).toBe('/meshes/bad/file The mesh "bad" cannot be used. At line 2 "bad.obj" has the number 2 of a vertex; expected at most 1.'); // biome-ignore format: long
  expect(told.at(-2)).toBe('/meshes/cap/part The mesh "cap" is the part "wod" of "parts/pot.obj", which has no such part; expected one of "iron", "wood". Did you mean "wood"?'); // biome-ignore format: long
  expect(told.at(-1)).toContain('expected no "part", as the file has none.');
  expect(problems[2]!.found).toBe('the file "bad.obj", which cannot be used (line 2: the number 2 of a vertex)');
});
