import { expect, test } from 'vitest';
import { withoutFeatures } from './without-features.ts';

const program = `// A program.
override hasMeshes = false;
override hasBoxes = true;

@group(0) @binding(1) var<storage, read> geometry: array<vec4u>;
var<private> stack: array<u32, 4>;

// Only for meshes.
const deep = 64u;
fn meshes(a: f32) -> f32 { if (a > 1.0) { return f32(stack[deep]); } else { return 0.0; } }
fn boxes(a: f32) -> f32 { return a; }

@fragment fn draw(@builtin(position) p: vec4f) -> @location(0) vec4f {
  var t = 0.0;
  if (hasMeshes) { t = meshes(p.x); }
  if (hasMeshes & (p.x > 0.0)) { t += meshes(p.y); } else if (hasBoxes) { t = boxes(p.x); }
  if (p.y > 1.0) { t = 1.0; } else if (hasMeshes) { t = meshes(t); }
  if (p.y > 1.0) { t = 1.0; } else if (hasMeshes) { t = meshes(t); } else { t = 3.0; }
  if (hasMeshes | hasBoxes) { t = 2.0; }
  return vec4f(select(t, 0.0, hasMeshes & (t > 1.0)));
}
`;

test('what a switch guards is gone, and what only that asked for', () => {
  expect(withoutFeatures(program, ['hasMeshes'])).toBe(
    `const hasMeshes = false;
override hasBoxes = true;

@group(0) @binding(1) var<storage, read> geometry: array<vec4u>;
fn boxes(a: f32) -> f32 { return a; }

@fragment fn draw(@builtin(position) p: vec4f) -> @location(0) vec4f {
  var t = 0.0;
  
  if (hasBoxes) { t = boxes(p.x); }
  if (p.y > 1.0) { t = 1.0; }
  if (p.y > 1.0) { t = 1.0; } else { t = 3.0; }
  if (hasMeshes | hasBoxes) { t = 2.0; }
  return vec4f(select(t, 0.0, hasMeshes & (t > 1.0)));
}
`.replace('const hasMeshes', '// A program.\nconst hasMeshes'),
  );
});

const body = (statements: string) =>
  `override hasHoles = true;\noverride hasFog = true;\nfn walk() { ${statements} }\n`;
const walked = (statements: string, off: readonly string[]) =>
  /fn walk[\s\S]*/
    .exec(withoutFeatures(`${body(statements)}@fragment fn draw() { walk(); }\n`, off))![0]
    .split('@')[0]!
    .trim();

test('a loop of one turn is none', () => {
  const nested = 'loop { loop { i++; if (i > 9) { break; } } if (!hasHoles) { break; } j++; if (j > 9) { break; } }';
  expect(walked(nested, ['hasHoles'])).toBe('fn walk() { { loop { i++; if (i > 9) { break; } } } }');
  expect(walked(nested, ['hasFog'])).toBe(`fn walk() { ${nested} }`);
  const either = 'loop { i++; if (!hasFog | !hasHoles) { break; } if (i > 9) { break; } }';
  expect(walked(either, ['hasHoles'])).toBe('fn walk() { { i++; } }');
});

test.each([
  ['a turn that may end before', 'loop { if (a) { continue; } if (!hasHoles) { break; } }'],
  ['no loop of its own', 'loop { if (a) { if (!hasHoles) { break; } } if (b) { break; } }'],
])('but not with %s', (_, statements) => expect(walked(statements, ['hasHoles'])).toBe(`fn walk() { ${statements} }`));

test('what one of two switches guards needs both to be off', () => {
  const guarded = 'if (hasHoles | (hasFog & a)) { b = 1; }';
  expect(walked(guarded, ['hasHoles'])).toBe(`fn walk() { ${guarded} }`);
  expect(walked('if (hasHoles | hasFog) { b = 1; }', ['hasHoles', 'hasFog'])).toBe('fn walk() {  }');
});

test('with everything on the program is what it was', () => expect(withoutFeatures(program, [])).toBe(program));
