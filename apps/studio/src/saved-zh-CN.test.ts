import { readdirSync, readFileSync } from 'node:fs';
import { builtInScenes } from 'mirrorball';
import { writeGlb, writeMitsuba } from 'mirrorball/scene-export';
import { expect, test } from 'vitest';
import { savedInChinese } from './saved-zh-CN.ts';
import { fileName } from './saving/save.ts';

const folder = new URL('../../../packages/renderer/src/scene-export/', import.meta.url);

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
