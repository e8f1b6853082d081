import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { translate } from 'naga-wasm';
import { describe, expect, test } from 'vitest';
import { minifiedDeclarations } from './shader-minify.mjs';

const folder = fileURLToPath(new URL('../packages/renderer/src/shading/generated/', import.meta.url));
const words = (text: string) => text.replace(/\/\/.*$/gm, '').match(/[A-Za-z_]\w*|[\d.]+\w*|[^\s\w]/g) ?? [];

/**
 * Which word became which, in one declaration. With one new name for each old one and the other way round, all scopes stay as they
 * are, whatever the language; this knows nothing of how names are found.
 */
function renamed(before: readonly string[], after: readonly string[]): Map<string, string> {
  const [there, back] = [new Map<string, string>(), new Map<string, string>()];
  before.forEach((word, i) => {
    // What stands behind a dot is a member's name, and in an attribute it is the language's; both keep it.
    const other = '.@'.includes(before[i - 1] ?? ' ') || before[i - 3] === '@' ? '.' : '';
    const [old, now] = [`${other}${word}`, `${other}${after[i]}`];
    // Asked of every word: an expectation for each would take most of the time.
    if ((there.get(old) ?? now) !== now || (back.get(now) ?? old) !== old)
      expect([there.get(old) ?? now, back.get(now) ?? old], before.join(' ')).toEqual([now, old]);
    there.set(old, now);
    back.set(now, old);
  });
  return new Map([...there].filter(([old, now]) => old !== now));
}

describe('shaders in few letters are the same programs', () => {
  for (const file of readdirSync(folder))
    test(file, () => {
      const text = readFileSync(folder + file, 'utf8');
      const language = file.endsWith('.wgsl') ? 'wgsl' : 'glsl';
      const before = words(text);
      const changed = new Map<string, string>();
      const kept = new Set<string>();
      let at = 0;
      for (const part of minifiedDeclarations(text, language)) {
        const after = words(part);
        const old = before.slice(at, at + after.length);
        const names = renamed(old, after);
        for (const [name, now] of names) changed.set(name, now);
        if (names.size === 0) for (const word of old) kept.add(word);
        at += after.length;
      }
      expect(at, 'no word is lost').toBe(before.length);
      for (const name of changed.keys()) expect(name).toMatch(/^[A-Za-z_]\w*$/);
      // What functions are called by, what the renderer binds, and switches.
      const own = [...text.matchAll(/\bfn (\w+)|\boverride (\w+)|^const bool (\w+)|var<?[\w, ]*>? (\w+): texture/gm)];
      for (const [, ...names] of own) expect(changed.has(names.find(Boolean)!), names.join('')).toBe(false);
    });
});

test.each(readdirSync(folder).filter((file) => file.endsWith('.wgsl')))('%s is still WGSL to a compiler', (file) => {
  const source = minifiedDeclarations(readFileSync(folder + file, 'utf8'), 'wgsl').join('');
  const variables = source.replace(/override (\w+)=(true|false);/g, 'var<private> $1:bool=$2;');
  expect(translate({ from: 'wgsl', to: 'wgsl', source: variables }).length).toBeGreaterThan(100);
});

test('operators that would run together keep their space, directives their line', () => {
  const glsl =
    '#version 300 es\n\nprecision highp float;\nfloat f(float first) {\n    float second = (first - -1.0);\n    return second;\n}\n';
  expect(minifiedDeclarations(glsl, 'glsl').join('')).toBe(
    '#version 300 es\nprecision highp float;float f(float a){float b=(a- -1.0);return b;}',
  );
  const wgsl =
    '@at fn f(@location(at) at: vec2f, length: f32) -> f32 { let x = at.x; return x / length(at) - length; }';
  expect(minifiedDeclarations(wgsl, 'wgsl').join('')).toBe(
    '@at fn f(@location(at)a:vec2f,length:f32)->f32{let b=a.x;return b/length(a)-length;}',
  );
});
