import { encode } from 'fast-png';
import { zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { writePly } from '../mesh-file/ply/write-ply.ts';
import { isParsedScene } from '../scene-file/trusted-scenes.ts';
import type { GivenFile } from './file-set.ts';
import { openEnvironment } from './open-environment.ts';
import { type OpenedFiles, openFiles } from './open-files.ts';

type Content = string | Uint8Array;
const bytesOf = (content: Content) => (typeof content === 'string' ? new TextEncoder().encode(content) : content);
const given = (files: Record<string, Content>): GivenFile[] =>
  Object.entries(files).map(([path, content]) => {
    const bytes = bytesOf(content);
    return { path, size: bytes.length, read: async () => bytes };
  });
const open = (files: Record<string, Content>) => openFiles(given(files));

function good(opened: OpenedFiles) {
  if (!opened.ok) throw new Error(JSON.stringify(opened.problems));
  return opened;
}

/** A PNG of one white pixel. */
const pixel = () => encode({ width: 1, height: 1, data: new Uint8Array([255, 255, 255, 255]), channels: 4 });
const glb = () => triangleFile().glb();
/** Numbers and a picture beside it. */
const gltf = () => {
  const file = triangleFile();
  const buffer = file.buffer;
  file.json.buffers = [{ byteLength: buffer.length, uri: 'numbers%20here.bin' }];
  file.json.images = [{ uri: 'tex/a.png' }, { uri: 'tex/b.png' }];
  file.json.textures = [{ source: 0 }, { source: 1 }];
  return { text: JSON.stringify(file.json), buffer };
};
const OBJ = 'mtllib cube.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 4\n';
const MTL = 'newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n';

test('a model alone is framed and lit', async () => {
  const opened = good(await open({ 'thing.glb': glb() }));
  expect(opened).toMatchObject({ file: 'thing.glb', scene: { name: 'thing' }, report: { counts: { triangles: 1 } } });
  expect(opened.scene.sky.map).toBeDefined();
});

test('a model with its files, in a folder or in an archive, whatever the letter case and the escapes', async () => {
  const { text, buffer } = gltf();
  const files = { 'm/thing.gltf': text, 'm/Numbers here.bin': buffer, 'm/tex/a.png': 'x', 'm/tex/b.png': 'x' };
  expect(good(await open(files)).file).toBe('thing.gltf');
  const zip = zipSync(Object.fromEntries(Object.entries(files).map(([path, content]) => [path, bytesOf(content)])));
  expect(good(await open({ 'thing.zip': zip })).scene.name).toBe('thing');
});

test('all files that are missing are told by their names at once', async () => {
  const opened = await open({ 'thing.gltf': gltf().text });
  expect(opened.ok).toBe(false);
  const messages = opened.ok ? [] : opened.problems.map(({ message }) => message);
  for (const name of ['numbers here.bin', 'a.png', 'b.png'])
    expect(messages.some((message) => message.includes(`open ${name} together with thing.gltf`))).toBe(true);
});

test('triangles alone are a grey thing in a studio, in the middle of the picture', async () => {
  const { scene, report } = good(await open({ 'my cube.ply': writePly(cubeMesh()) }));
  expect(isParsedScene(scene)).toBe(true);
  expect(scene).toMatchObject({
    name: 'my cube',
    camera: { target: [0, 0, 0] },
    render: { integrator: 'path', toneMapping: 'neutral' },
    materials: { 'part 1': { type: 'metallicRoughness' } },
  });
  expect(scene.sky.map?.width).toBe(128);
  expect(report.counts).toMatchObject({ triangles: 12, placements: 1 });
});

test('an .obj file has the materials of its .mtl file', async () => {
  const { scene, report } = good(await open({ 'cube.obj': OBJ, 'cube.mtl': MTL }));
  expect(scene.materials.red!.baseColor).toEqual([1, 0, 0]);
  expect(scene.materials.blue!.baseColor).toEqual([0, 0, 1]);
  expect(report.entries).toEqual([]);
});

test('textures of an .mtl file are read, normal maps get tangents; what is not there is told', async () => {
  const obj =
    'mtllib m/q.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1 3 2\n';
  const mtl = 'newmtl a\nmap_Kd c.png\nnorm n.png\nmap_Ke away.png\nnewmtl b\nmap_Kd c.png\n';
  const { scene, report } = good(await open({ 'q.obj': obj, 'm/q.mtl': mtl, 'm/c.png': pixel(), 'm/n.png': pixel() }));
  expect(scene.materials.a!.baseColorTexture).toEqual({ texture: 'm/c.png' });
  expect(scene.materials.a!.emissionTexture).toBeUndefined();
  expect(scene.materials.a!.emission).toEqual([0, 0, 0]);
  expect(scene.images!['m/c.png']!.data).toMatchObject({ width: 1, height: 1 });
  expect(scene.meshes!.a!.data!.tangents).toHaveLength(12);
  expect(scene.materials.b!.baseColorTexture).toBeUndefined();
  const told = report.entries.map(({ message }) => message);
  expect(told).toHaveLength(2);
  expect(told[1]).toMatch(/^The image "m\/away.png" cannot be read, so that what it covers is plain: /);
  expect(told[0]).toBe('The material "b" has textures, and its triangles have no texture coordinates.');
});

const TRIANGLE = 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n';

test('images that are made: opacity into the alpha of colours, metallic without roughness; a damaged one is told', async () => {
  const grey = encode({ width: 2, height: 1, data: new Uint8Array([0, 128]), channels: 1 });
  const obj = `mtllib q.mtl\n${TRIANGLE}usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 2/2\nusemtl c\nf 1/1 3/3 2/2\n`;
  const mtl = 'newmtl a\nmap_Kd c.png\nmap_d g.png\nnewmtl b\nmap_Pm g.png\nnewmtl c\nmap_Pm bad.png\nmap_Kd c.png';
  const { scene, report } = good(
    await open({ 'q.obj': obj, 'q.mtl': mtl, 'c.png': pixel(), 'g.png': grey, 'bad.png': 'x' }),
  );
  const pixels = (texture: string) => [...scene.images![scene.textures![texture]!.image]!.data!.rgba];
  expect(pixels(scene.materials.a!.baseColorTexture!.texture)).toEqual([255, 255, 255, 0, 255, 255, 255, 128]);
  expect(pixels(scene.materials.b!.metallicRoughnessTexture!.texture)).toEqual([255, 255, 0, 255, 255, 255, 128, 255]);
  expect(scene.materials.c).toMatchObject({ metallic: 0, baseColorTexture: { texture: 'c.png' } });
  expect(report.entries.map(({ message }) => message)).toEqual([
    'The image "bad.png" cannot be read, so that what it covers is plain: it is no image.',
  ]);
  expect(Object.keys(scene.images!)).not.toContain('g.png');
});

const utf16 = (text: string, littleEndian: boolean) => {
  const view = new DataView(new ArrayBuffer(2 + 2 * text.length));
  for (const [k, letter] of [...`\ufeff${text}`].entries()) view.setUint16(2 * k, letter.charCodeAt(0), littleEndian);
  return new Uint8Array(view.buffer);
};

test.each([
  ['UTF-16, either order of bytes', { 'cube.obj': utf16(OBJ, true), 'cube.mtl': utf16(MTL, false) }],
  ['UTF-8 with its mark', { 'cube.obj': `\ufeff${OBJ}`, 'cube.mtl': `\ufeff${MTL}` }],
  ['a path of another machine', { 'cube.obj': OBJ.replace('cube.mtl', 'C:\\work\\my files\\cube.mtl'), 'cube.mtl': MTL }],
  ['back slashes and quotes', { 'cube.obj': OBJ.replace('cube.mtl', '".\\m\\my cube.mtl"'), 'm/my cube.mtl': MTL }],
  ['several files, in one line and in two', { 'cube.obj': `mtllib a.mtl b c.mtl\n${OBJ}`, 'a.mtl': 'newmtl z', 'b c.mtl': 'newmtl red\nKd 1 0 0', 'cube.mtl': 'newmtl blue\nKd 0 0 1' }],
  ['faces before any mtllib', { 'cube.obj': `${OBJ.replace('mtllib cube.mtl\n', '')}mtllib cube.mtl`, 'cube.mtl': MTL }],
  ['lines that go on, and numbers that count back', { 'cube.obj': OBJ.replace('f 1 2 3', 'f -4 \\\n -3 -2'), 'cube.mtl': MTL }],
])('materials of an .obj file: %s', async (_, files) => {
  const { scene, report } = good(await open(files));
  expect(scene.materials.red!.baseColor).toEqual([1, 0, 0]);
  expect(scene.materials.blue!.baseColor).toEqual([0, 0, 1]);
  expect(report.entries).toEqual([]);
}); // biome-ignore format: table

test('a file of materials that is called like the model stands in for one that is not there', async () => {
  const { scene, report } = good(await open({ 'x.obj': OBJ, 'x.mtl': MTL }));
  expect(scene.materials.red!.baseColor).toEqual([1, 0, 0]);
  expect(report.entries.map(({ message }) => message)[1]).toBe(
    'The materials are those of "x.mtl", which is called like the model.',
  );
});

test('without its .mtl file it is grey and that is told; a broken one is a problem', async () => {
  const { scene, report } = good(await open({ 'cube.obj': OBJ }));
  expect(scene.materials.red!.baseColor).toEqual([0.6, 0.6, 0.6]);
  expect(report.entries.map(({ message }) => message).join(' ')).toContain('open cube.mtl together with cube.obj');
  const broken = await open({ 'cube.obj': OBJ, 'cube.mtl': 'newmtl red\nKd x\n' });
  expect(broken).toMatchObject({ ok: false, problems: [{ path: '/cube.mtl/line 2' }] });
});

test('a scene file with meshes beside it', async () => {
  const scene = {
    version: 1,
    name: 'Cubes',
    camera: { eye: [0, 0, 5], target: [0, 0, 0] },
    materials: { grey: {} },
    meshes: { cube: { file: '../models/cube.ply' } },
    shapes: { cube: { type: 'mesh', mesh: 'cube', material: 'grey' } },
  };
  const files = { 'scenes/cubes.json': JSON.stringify(scene), 'models/cube.ply': writePly(cubeMesh()) };
  const opened = good(await open(files));
  expect(opened.scene.meshes!.cube!.data).toEqual(cubeMesh());
  expect(opened.report.counts).toMatchObject({ triangles: 12, materials: 1 });
});

test('of several models one is shown, and the report tells the others', async () => {
  const opened = good(await open({ 'a.glb': glb(), 'b.glb': glb(), 'deep/c.glb': glb() }));
  expect(opened.file).toBe('a.glb');
  expect(opened.report.entries.at(-1)!.message).toContain('"b.glb", "c.glb"');
});

test.each([
  ['nothing', {}, 'no file'],
  ['a file of another kind', { 'a.txt': 'x' }, 'a file of another kind'],
  ['a model for other programs', { 'a.FBX': 'x', 'a.png': 'x' }, 'a model of another kind (.fbx)'],
  ['an archive without a model', { 'a.zip': zipSync({ 'b.txt': new Uint8Array(3) }) }, 'a file of another kind'],
  ['an archive that is none', { 'a.zip': 'x' }, 'an archive that cannot be opened'],
  ['a broken model', { 'a.glb': glb().slice(0, 30) }, 'cut off'],
  ['broken triangles', { 'a.ply': 'ply\nformat ascii 1.0\n' }, ''],
  ['a broken scene', { 'a.json': '{' }, ''],
])('%s is refused with all that is wrong', async (_, files, found) => {
  const opened = await open(files as Record<string, Content>);
  expect(opened.ok).toBe(false);
  if (opened.ok) return;
  expect(opened.problems.length).toBeGreaterThan(0);
  expect(opened.problems[0]!.found).toContain(found);
  for (const { message, allowed } of opened.problems) expect(message && allowed).not.toBe('');
});

test('a file that cannot be read is a problem, and one in an archive that is damaged', async () => {
  const bad: GivenFile = { path: 'a.glb', size: 9, read: () => Promise.reject(new Error('it has moved')) };
  expect(await openFiles([bad])).toMatchObject({ ok: false, problems: [{ message: '"a.glb" cannot be read: it has moved.' }] }); // biome-ignore format: one line
});

test.each([
  [{ 'a.usdz': 'x' }, /^"a.usdz" cannot be opened as it is: export it as glTF \(\.glb\)/],
  [{ 'a.txt': 'x' }, /^"a.txt" is a file of another kind\. What can be opened/],
  [{ 'a.txt': 'x', 'b.png': 'x' }, /^These are 2 files of other kinds\. What/],
  [{ 'a.zip': zipSync({ 'b.txt': new Uint8Array(3) }) }, /^"a.zip" has a file of another kind\. What/],
])('of %j is said why it cannot be opened', async (files, sentence) => {
  const opened = await open(files as unknown as Record<string, Content>);
  expect(opened.ok ? '' : opened.problems[0]!.message).toMatch(sentence);
});

test('a panorama that cannot be used is no place in a scene file', async () => {
  const [file] = given({ 'light/x.hdr': 'hello' });
  expect(await openEnvironment(file!)).toMatchObject({
    ok: false,
    problems: [
      { path: '', message: expect.stringMatching(/^"x.hdr" is no panorama that can be used\. The HDR first line/) },
    ],
  });
});

test('what was aborted rejects with the reason', async () => {
  const controller = new AbortController();
  controller.abort(new Error('enough'));
  await expect(openFiles(given({ 'a.glb': glb() }), { signal: controller.signal })).rejects.toThrow('enough');
});
