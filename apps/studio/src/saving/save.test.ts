import { readdirSync, readFileSync } from 'node:fs';
import { builtInScenes, openFiles, type Scene, withParts } from 'mirrorball';
import { writeGlb, writeMitsuba } from 'mirrorball/scene-export';
import { expect, test } from 'vitest';
import { triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { savedInChinese } from '../saved-zh-CN.ts';
import { fileName, keepingOwnLook, uncovered } from './save.ts';

const folder = new URL('../../../../packages/renderer/src/scene-export/', import.meta.url);

/** Sentences as they stand in the sources, what is filled in written as "x". */
const sentences = readdirSync(folder, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.ts') && !name.endsWith('.test.ts'))
  .flatMap((name) => [
    ...readFileSync(new URL(name, folder), 'utf8').matchAll(
      /'(?:lost|changed)',\s*(?:\w+ \? )?(['"`])(.*?\.)\1(?: : (['"`])(.*?\.)\3)?/g,
    ),
  ])
  .flatMap(([, , one, , other]) => [one!, ...(other ? [other] : [])])
  .map((text) => text.replaceAll(/\$\{[^}]*\}/g, 'x'));

test('every sentence about what a format lacks has a form in Chinese', () => {
  expect(sentences.length).toBeGreaterThan(30);
  expect(
    sentences.filter((message) => !/[\u4e00-\u9fff]/.test(savedInChinese({ kind: 'lost', message, things: [] }))),
  ).toEqual([]);
});

test.each(builtInScenes)('what is told of $id is told in Chinese', ({ scene }) => {
  const told = [...writeGlb(scene).report, ...writeMitsuba(scene).report];
  expect(told.length).toBeGreaterThan(1);
  for (const entry of told) expect(savedInChinese(entry)).toMatch(/[\u4e00-\u9fff].*。$/);
});

test.each([
  ['Fox.glb', 'Fox'],
  ['a/b:c.scene.json', 'a b c.scene'],
  ['...', 'mirrorball'],
  ['立方体房间', '立方体房间'],
])('a file made of %s is called %s', (name, expected) => {
  expect(fileName(name)).toBe(expected);
});

test('of a film only what no panel covers is saved', () => {
  const pixels = Float32Array.from({ length: 4 * 3 * 4 }, (_, i) => Math.floor(i / 4));
  const { width, height, pixels: cut } = uncovered({ view: 'picture', width: 4, height: 3, pixels }, 0.75, 0.6);
  expect([width, height]).toEqual([3, 2]);
  expect([...cut].filter((_, i) => i % 4 === 0)).toEqual([0, 1, 2, 4, 5, 6]);
});

test('a model saved in another look keeps the one that it had, and its other looks as they were', async () => {
  const read = async (bytes: Uint8Array): Promise<Scene> => {
    const opened = await openFiles([{ path: 'a.glb', size: bytes.length, read: async () => bytes }]);
    if (!opened.ok) throw new Error(opened.problems[0]!.message);
    return opened.scene;
  };
  const file = triangleFile((f) => {
    f.json.materials = ['Red', 'Blue', 'Green'].map((name) => ({ name }));
    const [primitive] = f.json.meshes[0].primitives;
    const variants = (...mappings: object[]) => ({ KHR_materials_variants: { mappings } });
    f.json.meshes[0].primitives = [
      { ...primitive, material: 0, extensions: variants({ material: 1, variants: [0] }) },
      { ...primitive, material: 0, extensions: variants({ material: 2, variants: [1] }) },
    ];
    f.json.extensionsUsed = ['KHR_materials_variants'];
    f.json.extensions = { KHR_materials_variants: { variants: [{ name: 'Night' }, { name: 'Original' }] } };
  });
  const original = await read(file.glb());
  expect(keepingOwnLook(original, original)).toBe(original);
  const { files } = writeGlb(keepingOwnLook(withParts(original, { variant: 'Night' }), original));
  const saved = await read(Object.values(files)[0]!);
  const look = (variant?: string) => {
    const { shapes } = variant === undefined ? saved : withParts(saved, { variant });
    return Object.values(shapes).map(({ material }) => material);
  };
  expect(look()).toEqual(['Blue', 'Red']);
  expect(look('Night')).toEqual(['Blue', 'Red']);
  expect(look('Original')).toEqual(['Red', 'Green']);
  expect(look('Original*')).toEqual(['Red', 'Red']);
});
