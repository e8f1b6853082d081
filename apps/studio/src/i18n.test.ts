import { expect, test } from 'vitest';
import { en } from './en.ts';
import { pickLanguage } from './i18n.ts';
import { zhCN } from './zh-CN.ts';

test('the first language that there is wins', () => {
  expect(pickLanguage(['fr-FR', 'zh-TW', 'en'])).toBe('zh-CN');
  expect(pickLanguage(['de', 'en-GB', 'zh'])).toBe('en');
  expect(pickLanguage(['zh'])).toBe('zh-CN');
  expect(pickLanguage(['ja'])).toBe('en');
  expect(pickLanguage([])).toBe('en');
});

const keysOf = (value: object, path = ''): string[] =>
  Object.entries(value).flatMap(([key, child]) =>
    child !== null && typeof child === 'object' ? keysOf(child, `${path}/${key}`) : [`${path}/${key}`],
  );

test('both dictionaries say the same things, none of them empty', () => {
  expect(keysOf(zhCN).sort()).toEqual(keysOf(en).sort());
  const texts = JSON.stringify(zhCN);
  expect(texts).not.toContain('""');
});

test('English counts', () => {
  expect(en.panelReflections(1)).toBe('1 reflection');
  expect(en.panelReflections(10)).toBe('10 reflections');
});
