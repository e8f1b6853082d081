import { beforeEach, expect, test } from 'vitest';
import { modelOf, openedModels, rememberModel } from './opened-models.ts';

const files = (name: string, content = name, lastModified = 0) => [
  { path: name, file: new File([content], name, { lastModified }) },
];
const open = (name: string, from = files(name)) => {
  const model = modelOf(name, from);
  rememberModel(model);
  return model.key;
};
const listed = () => openedModels.peek().map(({ name }) => name);

beforeEach(() => {
  openedModels.value = [];
});

test('a model is listed once, at its place, and under its last name', () => {
  const first = open('a.glb');
  open('b.glb');
  expect(open('again', files('a.glb'))).toBe(first);
  expect(listed()).toEqual(['again', 'b.glb']);
});

test('a file that was changed, or of another size, is another model', () => {
  const keys = [files('a.glb'), files('a.glb', 'a.glb', 1), files('a.glb', 'longer'), [...files('a.glb'), ...files('b.bin')]].map((from) => open('a', from)); // biome-ignore format: one list
  expect(new Set(keys).size).toBe(4);
});

test('what is only looked for is not listed', () => {
  modelOf('a.glb', files('a.glb'));
  expect(listed()).toEqual([]);
});

test('the last six are listed', () => {
  for (let i = 0; i < 9; i++) open(`${i}.glb`);
  expect(listed()).toEqual(['3.glb', '4.glb', '5.glb', '6.glb', '7.glb', '8.glb']);
});
