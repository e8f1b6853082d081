import { loadFiles, type Problem, parseScene } from 'mirrorball';
import { describe, expect, test } from 'vitest';
import {
  brokenAnimation,
  brokenObjects,
  brokenParts,
  brokenRich,
  brokenShapes,
} from '../../../packages/renderer/src/scene-file/broken/broken-scenes.ts';
import { goodScene, richScene } from '../../../packages/renderer/src/scene-file/broken/good-scene.ts';
import { problemInChinese } from './problem-zh-CN.ts';

function problemsOf(input: unknown): readonly Problem[] {
  const parsed = parseScene(input);
  return parsed.ok ? [] : parsed.problems;
}
/** Words that are left when names, texts of the file and paths are taken out; "one" is the name of a symbol there. */
const englishWords = (sentence: string): string[] =>
  (
    sentence
      .replace(/^在 .*? 处：/s, '')
      .replace(/"[^"]*"|（.*?）/g, '')
      .match(/[A-Za-z]{2,}/g) ?? []
  ).filter(
    (word) =>
      !['true', 'false', 'null', 'JSON', 'Pointer', 'NaN', 'Infinity', 'Symbol', 'BigInt', 'one'].includes(word),
  );

describe.each(Object.entries({ brokenParts, brokenShapes, brokenAnimation, brokenObjects, brokenRich }))(
  '%s',
  (name, table) => {
    test.each(table)('%s: all said in Chinese', (_defect, breakIt) => {
      const scene = name === 'brokenRich' ? richScene() : goodScene();
      breakIt(scene);
      for (const problem of problemsOf(scene)) {
        const sentence = problemInChinese(problem);
        expect(englishWords(sentence), sentence).toEqual([]);
        expect(sentence).toContain('应为');
      }
    });
  },
);

test.each(['', '{"version": 1,}', '{"a": 1 "b": 2}', '{ version: 1 }', '["\\x"]', '[', '{} {}', '{"a": "b', '[[1]'])(
  'text that is not JSON: %j',
  (text) => {
    const [problem] = problemsOf(text);
    expect(englishWords(problemInChinese(problem!)).filter((word) => word !== 'version')).toEqual([]);
  },
);

test('sentences', () => {
  const scene = goodScene();
  scene.camera.verticalFov = 180;
  scene.materials.clay.colour = [1, 0, 0];
  delete scene.name;
  const sentences = problemsOf(scene).map(problemInChinese);
  expect(sentences).toContain('在 /camera/verticalFov 处：值为 180，应为 0.01 到 179 之间的数。');
  expect(sentences).toContain('在 /name 处：缺少此项，应为不超过 200 个字符的文本。');
  expect(
    sentences.find((sentence) => sentence.startsWith('在 /materials/clay/colour 处：含有未知的键 "colour"')),
  ).toBeDefined();
  expect(problemInChinese({ path: '', found: '7 more', allowed: 'none', message: '' })).toBe('……另有 7 个问题。');
});

test('files that cannot be used: what is wrong inside of them stays in English', async () => {
  const meshes = {
    gone: { file: 'gone.ply' },
    lid: { file: 'pot.obj', part: 'lid' },
    pot: { file: 'pot.obj', part: 'x' },
  };
  const parsed = parseScene({ ...goodScene(), meshes, shapes: { ball: goodScene().shapes.ball } });
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  const pot = new TextEncoder().encode('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const loaded = await loadFiles(parsed.scene, async (name) => {
    if (name === 'pot.obj') return pot;
    throw new Error('there is no such file');
  });
  expect(loaded.ok ? [] : loaded.problems.map(problemInChinese)).toEqual([
    '在 /meshes/gone/file 处：文件 "gone.ply" 无法使用（there is no such file），应为三角形网格的文件名（.ply、.obj 或 .stl），路径相对于场景所在的文件夹，用 "/" 分隔（.glb 和 .gltf 请写在 "models" 里）。',
    '在 /meshes/lid/part 处：名称为 "lid"，应为空（该文件没有分部，请去掉 "part"）。',
    '在 /meshes/pot/part 处：名称为 "x"，应为空（该文件没有分部，请去掉 "part"）。',
  ]);
});

test('models and images that cannot be used', () => {
  const say = (found: string, allowed: string) => problemInChinese({ path: '/x', found, allowed, message: '' });
  expect(say('17 lights together with those of the scene', 'at most 16')).toBe(
    '在 /x 处：连同场景自带的共有 17 个光源，应为最多 16 个。',
  );
  expect(say('images of 9 bytes once they are decoded', 'at most 8 bytes')).toBe(
    '在 /x 处：图片解码后共 9 字节，应为最多 8 字节。',
  );
  expect(say('the name "dusk"', 'no "variant", as the file has none')).toContain('没有其他外观');
  expect(say('nothing', 'a glTF 2.0 file that can be read')).toContain('应为可以读取的 glTF 2.0 文件');
});

test('a phrase that has no form here stays as it is', () => {
  expect(problemInChinese({ path: '/x', found: 'a unicorn', allowed: 'a horse', message: '' })).toBe(
    '在 /x 处：值为 a unicorn，应为 a horse。',
  );
});
