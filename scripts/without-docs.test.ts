import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { withoutDocs } from './without-docs.mjs';

const LAYOUT = new URL('../packages/renderer/src/packed-scene/layout.ts', import.meta.url);

test('fields lose their words and nothing else', () => {
  const one = (doc: string) =>
    `a: field('vec3f', ${doc}),\n  b: field(\n    { array: 'vec4f', length: N },\n    ${doc},\n  ),`;
  expect(withoutDocs(one("'of the box (x, y)'"))).toBe(
    "a: field('vec3f', ''),\n  b: field({ array: 'vec4f', length: N }, ''),",
  );
});

test('layout.ts has no field that keeps them', () => {
  const short = withoutDocs(readFileSync(LAYOUT, 'utf8'));
  const fields = [...short.matchAll(/^ {4}\w+: field\((.*)/gm)].map(([, rest]) => rest);
  expect(fields.length).toBeGreaterThan(100);
  for (const rest of fields) expect(rest).toMatch(/, ''\),$/);
});
