import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { METALS } from '../../packages/renderer/src/scene/metals.ts';

const page = readFileSync(new URL('../../docs/materials.md', import.meta.url), 'utf8');

test('docs/materials.md has each named metal with its constants, and what they give from ahead', () => {
  const rows = Object.entries(METALS).map(([name, { eta, k }]) => {
    const ahead = eta.map((e, c) => ((e - 1) ** 2 + k[c]! ** 2) / ((e + 1) ** 2 + k[c]! ** 2));
    return `| \`${name}\` | ${eta.join(', ')} | ${k.join(', ')} | ${ahead.map((f) => f.toFixed(2)).join(', ')} |`;
  });
  const listed = page.split('\n').filter((line) => /^\| `\w+` \| \d+\.\d+, /.test(line));
  expect(listed).toEqual(rows);
});
