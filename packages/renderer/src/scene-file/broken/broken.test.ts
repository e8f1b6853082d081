import { describe, expect, test } from 'vitest';
import { SCENE_LIMITS } from '../../scene/limits.ts';
import { parseScene } from '../parse-scene.ts';
import type { Problem } from '../problem.ts';
import { brokenAnimation, brokenObjects, brokenParts, brokenRich, brokenShapes } from './broken-scenes.ts';
import { goodScene, richScene } from './good-scene.ts';

function problemsOf(input: unknown): readonly Problem[] {
  const parsed = parseScene(input);
  if (parsed.ok) throw new Error('The scene was accepted.');
  for (const { path, found, allowed, message } of parsed.problems) {
    expect(path).toMatch(/^(\/|$)/);
    for (const text of [found, allowed, message]) {
      expect(text).not.toBe('');
      expect(text.length).toBeLessThan(1000);
    }
    expect(message).toMatch(/[.?]$/);
  }
  return parsed.problems;
}

test('the scene that is broken below is good as it is', () => {
  expect(parseScene(goodScene())).toMatchObject({ ok: true });
  expect(parseScene(JSON.stringify(goodScene()))).toMatchObject({ ok: true });
});

const tables = { brokenParts, brokenShapes, brokenAnimation, brokenObjects, brokenRich };
describe.each(Object.entries(tables))('%s', (name, table) => {
  test.each(table)('%s', (_defect, breakIt, paths) => {
    const scene = name === 'brokenRich' ? richScene() : goodScene();
    breakIt(scene);
    expect(problemsOf(scene).map(({ path }) => path)).toEqual(paths);
  });
});

describe('text that is not JSON tells where', () => {
  test.each([
    ['', 'line 1, column 1', 'a value'],
    ['{"version": 1,}', 'line 1, column 15', 'a key in double quotes'],
    ['{\n  "version": 1\n  "name": "x"\n}', 'line 3, column 3', '"," or "}"'],
    ['{\n  version: 1\n}', 'line 2, column 3', 'a key in double quotes'],
    ["{ 'version': 1 }", 'line 1, column 3', 'a key in double quotes'],
    ['{ "version" 1 }', 'line 1, column 13', '":"'],
    ['[1, 2, NaN]', 'line 1, column 8', 'a value'],
    ['[01]', 'line 1, column 3', '"," or "]"'],
    ['{} {}', 'line 1, column 4', 'the end of the file'],
    ['{"a": "b', 'line 1, column 7', 'a text that ends'],
    ['{"a": "\\x"}', 'line 1, column 8', 'one of'],
    ['{ // comment\n}', 'line 1, column 3', 'a key in double quotes'],
    ['<!doctype html>', 'line 1, column 1', 'a value'],
    [`${'['.repeat(1e6)}`, 'line 1, column 65', 'less nesting'],
  ])('%#', (text, place, expected) => {
    const [problem, ...others] = problemsOf(text);
    expect(others).toEqual([]);
    expect(problem?.message).toContain(place);
    expect(problem?.allowed).toContain(expected);
  });
});

test('a key that stands twice is a problem at its path, and a byte order mark is none', () => {
  const text = JSON.stringify(goodScene());
  const twice = text.replace('"panel":', '"block":');
  expect(problemsOf(twice).map(({ path }) => path)).toEqual(['/shapes/block']);
  expect(parseScene(`\ufeff${text}`)).toMatchObject({ ok: true });
});

test.each([
  ['undefined', undefined],
  ['null', null],
  ['a number', 3],
  ['a BigInt', 3n],
  ['a function', () => goodScene()],
  ['a symbol', Symbol('scene')],
  ['a list', [goodScene()]],
  ['a typed array', new Uint8Array(8)],
  ['a date', new Date(0)],
])('%s instead of a scene is one problem of the whole', (_, value) => {
  expect(problemsOf(value).map(({ path }) => path)).toEqual(['']);
});

test('deep nesting and huge texts are refused quickly', () => {
  const deep = JSON.stringify(goodScene()).replace(
    '"name":"Good"',
    `"name":${'[{"a":'.repeat(5e4)}1${'}]'.repeat(5e4)}`,
  );
  expect(problemsOf(deep).map(({ path }) => path)).toEqual(['/name']);
  expect(problemsOf(' '.repeat(SCENE_LIMITS.fileCharacters + 1))).toHaveLength(1);
  const keys = Array.from({ length: SCENE_LIMITS.keysPerTrack }, (_, time) => ({ time, value: [0, 0, 0] }));
  const crowd = Array.from({ length: SCENE_LIMITS.track }, () => ({ target: '/shapes/ball/center', keys }));
  expect(problemsOf({ ...goodScene(), animation: crowd })[0]?.found).toBe('too many values');
});

test('all problems are listed, at most a hundred and a line that counts the rest', () => {
  const scene = goodScene();
  for (let i = 0; i < 120; i++) scene.shapes[`ball ${i}`] = { ...scene.shapes.ball, radius: -1 };
  const problems = problemsOf(scene);
  expect(problems).toHaveLength(101);
  expect(problems.at(-1)?.message).toBe('… and 20 more problems.');
});

test('a wrong word is answered with the right one', () => {
  const scene = goodScene();
  scene.shapes.ball.material = 'caly';
  scene.shapes.block.colour = 1;
  scene.shapes.floor.nromal = scene.shapes.floor.normal;
  scene.animation[0].target = '/shapes/panel/cornr';
  const messages = problemsOf(scene)
    .map(({ message }) => message)
    .join('\n');
  for (const right of ['"clay"?', '"normal"?', '"/shapes/panel/corner"?'])
    expect(messages).toContain(`Did you mean ${right}`);
});

test('excerpts show no control characters and no text that runs backwards', () => {
  const scene = goodScene();
  scene.shapes.ball.material = '\u202eevil\u0007'.repeat(20);
  expect(problemsOf(scene)[0]?.message).not.toMatch(/[\p{Cc}\p{Cf}]/u);
});
