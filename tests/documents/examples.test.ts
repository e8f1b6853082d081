import { describe, expect, test } from 'vitest';
import { parseScene } from '../../packages/renderer/src/scene-file/index.ts';
import { codeBlocks } from './documents.ts';

const smallest = JSON.parse(codeBlocks('docs/scene-file.md', 'json')[0]!);

/** An example of one part of a scene, put into the smallest scene. */
const completed = (example: object): object => ('version' in example ? example : { ...smallest, ...example });

describe.each(['README.md', 'README.zh-CN.md', 'docs/scene-file.md', 'docs/materials.md'])(
  'the scenes of %s',
  (path) => {
    const examples = codeBlocks(path, 'json');
    test('there are some', () => expect(examples.length).toBeGreaterThan(0));

    test.each(examples)('example %# can be read', (text) => {
      const parsed = parseScene(completed(JSON.parse(text)));
      expect(parsed.ok ? [] : parsed.problems).toEqual([]);
    });
  },
);

test('the broken scene has just the problems that the page lists', () => {
  const parsed = parseScene(codeBlocks('docs/scene-file.md', 'json broken')[0]);
  const messages = parsed.ok ? [] : parsed.problems.map(({ message }) => `${message}\n`);
  expect(messages.join('')).toBe(codeBlocks('docs/scene-file.md', 'text problems')[0]);
});
