import { openEnvironment, openFiles } from 'mirrorball';
import { expect, test } from 'vitest';
import { triangleFile } from '../../../tests/fixtures/gltf.ts';
import { problemInChinese } from './problem-zh-CN.ts';
import { reportInChinese } from './report-zh-CN.ts';

const given = (files: Readonly<Record<string, string | Uint8Array>>) =>
  Object.entries(files).map(([path, content]) => {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
    return { path, size: bytes.length, read: async () => bytes };
  });
/** Words that are left when names and reasons are taken out. */
const englishWords = (sentence: string): string[] =>
  (sentence.replace(/"[^"]*"|（[^）]*）/g, '').match(/\w*[A-Za-z]\w+/g) ?? []).filter(
    (word) => !/^(GLB|JSON|UTF|glTF|glb|gltf|ply|obj|stl|fbx|zip|scene|json|VENDOR_unknown|KHR_\w+)$/.test(word),
  );

test('what a model is reported of is said in Chinese, with how often', async () => {
  const file = triangleFile((f) => {
    f.json.extensionsUsed = ['VENDOR_unknown'];
    f.json.nodes[0].rotation = [0, 0, 0, 2];
    f.json.meshes.push({ primitives: [{ attributes: { POSITION: 0 }, mode: 0 }] });
    f.json.nodes.push({ mesh: 1 });
    f.json.scenes.push({ nodes: [1] });
    f.json.materials = [{}, {}];
  });
  const opened = await openFiles(given({ 'a.glb': file.glb(), 'b.glb': file.glb() }));
  if (!opened.ok) throw new Error(opened.problems[0]!.message);
  const sentences = opened.report.entries.map(reportInChinese);
  expect(sentences.length).toBeGreaterThanOrEqual(4);
  for (const sentence of sentences) expect(englishWords(sentence).filter((word) => word !== 'meshes' && word !== 'materials'), sentence).toEqual([]); // biome-ignore format: one line
  expect(sentences).toContain('不支持扩展 VENDOR_unknown。');
  expect(reportInChinese({ kind: 'changed', what: 'x', message: 'A unicorn.', places: [], count: 3 })).toBe('A unicorn.（共 3 处）'); // biome-ignore format: one line
});

test.each([
  [
    'a missing file',
    { 'a.gltf': JSON.stringify({ asset: { version: '2.0' }, buffers: [{ byteLength: 4, uri: 'n.bin' }] }) },
  ],
  ['a file of another kind', { 'a.md': 'x' }],
  ['several of them', { 'a.md': 'x', 'b.txt': 'x' }],
  ['a model for other programs', { 'a.fbx': 'x' }],
  ['no archive', { 'a.zip': 'x' }],
  ['a model that is cut off', { 'a.glb': triangleFile().glb().slice(0, 100) }],
  ['bytes', { 'a.glb': new Uint8Array(50).fill(255) }],
])('%s: all said in Chinese', async (_, files) => {
  const opened = await openFiles(given(files as Readonly<Record<string, string>>));
  expect(opened.ok).toBe(false);
  for (const problem of opened.ok ? [] : opened.problems) {
    const sentence = problemInChinese(problem);
    expect(englishWords(sentence.replace(/在 .*? 处/, '')), sentence).toEqual([]);
  }
});

test.each([
  ['x.hdr', 'hello', '这不是 HDR 文件'],
  ['x.exr', 'hello there', '这不是 EXR 文件'],
  ['x.npy', 'hello there', '这不是 NPY 文件'],
  ['x.hdr', '#?RADIANCE\n\n-Y 64 +X 128\n', '文件已损坏或不完整'],
])('%s of %j is no panorama, as is said in Chinese', async (path, content, reason) => {
  const opened = await openEnvironment(given({ [path]: content })[0]!);
  expect(opened.ok ? [] : opened.problems.map(problemInChinese)).toEqual([
    `全景图无法使用（${reason}），应为完整的 .hdr、.exr、.npy 或 .pfm 图片。`,
  ]);
});

test('a device that has no room says so in Chinese', () => {
  const message = 'The meshes of this scene need 3.0 MiB; this device has room for 2.0 MiB (maxBufferSize).';
  const problem = { path: '', found: 'what cannot be drawn here', allowed: 'what can be', message };
  expect(problemInChinese(problem)).toBe(
    '此处无法绘制：场景的网格需要 3.0 MiB，而此设备最多容纳 2.0 MiB（maxBufferSize）。',
  );
});
