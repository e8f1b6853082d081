import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { COMMON_FEATURES, FEATURES } from './features.ts';

test('features.wesl has these switches, and those on that most scenes need', () => {
  const text = readFileSync(new URL('./features.wesl', import.meta.url), 'utf8');
  const switches = [...text.matchAll(/^override (\w+) = (\w+);/gm)].map(([, name, value]) => [name, value === 'true']);
  const common = new Set<string>(COMMON_FEATURES);
  expect(Object.fromEntries(switches)).toEqual(Object.fromEntries(FEATURES.map((name) => [name, common.has(name)])));
});
