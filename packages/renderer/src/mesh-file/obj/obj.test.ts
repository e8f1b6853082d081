import { describe, expect, test } from 'vitest';
import { srgbToLinear } from '../../display/srgb.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { meshFault } from '../../scene/mesh-fault.ts';
import type { MeshFileOptions } from '../mesh-file.ts';
import { readObj } from './read-obj.ts';

const bytes = (lines: string) => new TextEncoder().encode(lines);
function read(lines: string, options: MeshFileOptions = {}) {
  const file = readObj(bytes(lines), 'it.obj', options);
  if (!file.ok) throw new Error(file.problems.map(({ message }) => message).join('\n'));
  for (const { mesh } of file.parts) expect(meshFault(mesh)).toBeNull();
  return { ...file, mesh: file.parts[0]!.mesh };
}
const problems = (lines: string): string[] => {
  const file = readObj(bytes(lines), 'it.obj');
  return file.ok ? [] : file.problems.map(({ message }) => message);
};
/** What an array has at the three corners of a triangle. */
const at = ({ indices }: Mesh, triangle: number, numbers: Float32Array, width = 3) =>
  [0, 1, 2].map((k) => [...numbers.subarray(width * indices[3 * triangle + k]!, width * indices[3 * triangle + k]! + width)]); // biome-ignore format: short

const SQUARE = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n';

test('a square: four vertices, two triangles, flat', () => {
  const { mesh, parts, notes } = read(`# a comment\n${SQUARE}f 1 2 3 4`);
  expect([...mesh.indices]).toEqual([0, 1, 2, 0, 2, 3]);
  expect([...mesh.positions]).toEqual([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  expect([mesh.normals, mesh.uvs, mesh.colors, notes, parts.length]).toEqual([undefined, undefined, undefined, [], 1]);
});

test('numbers count back from the last with a minus, and lines go on after a backslash', () => {
  const { mesh } = read(`${SQUARE}f -4 -3 \\\n  -2\nv 5 5 5\nf -5 -3 \\\r\n -2`);
  expect(at(mesh, 1, mesh.positions)).toEqual([[0, 0, 0], [1, 1, 0], [0, 1, 0]]); // biome-ignore format: short
});

test('corners with texture coordinates and normals become vertices of their own where these differ', () => {
  const rest = 'vt 0 0\nvt 1 0.25\nvt 0.5\nvn 0 0 2\nvn 0 1 1\n';
  const { mesh } = read(`${SQUARE}${rest}f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/2/2 4/-1/-1`);
  expect(mesh.positions).toHaveLength(15);
  expect(at(mesh, 0, mesh.uvs![0]!, 2)).toEqual([[0, 1], [1, 0.75], [0.5, 1]]); // biome-ignore format: short
  expect(at(mesh, 0, mesh.normals!)).toEqual([[0, 0, 1], [0, 0, 1], [0, 0, 1]]); // biome-ignore format: short
  expect(at(mesh, 1, mesh.normals!)[2]![1]).toBeCloseTo(Math.SQRT1_2, 6);
});

test('all forms of a corner', () => {
  const rest = 'vt 0 0\nvn 0 0 1\n';
  for (const corner of ['', '/1', '/1/1', '//1', '/', '//', '/1/'])
    expect(read(`${SQUARE}${rest}f 1${corner} 2${corner} 3${corner}`).mesh.indices).toHaveLength(3);
});

describe('normals that the file leaves out', () => {
  // Two squares that meet at a right angle, along the edge 2-3.
  const ROOF = `${SQUARE}v 1 0 -1\nv 1 1 -1\n`;
  const [LEFT, RIGHT] = ['f 1 2 3 4\n', 'f 2 5 6 3\n'];
  const slanted = [Math.SQRT1_2, 0, Math.SQRT1_2];
  const near = (a: number[], b: number[]) =>
    a.forEach((x, k) => {
      expect(x).toBeCloseTo(b[k]!, 6);
    });

  test('none at all: flat', () => expect(read(`${ROOF}s off\n${LEFT}${RIGHT}`).mesh.normals).toBeUndefined());
  test('one smoothing group: blended along the edge', () => {
    const { mesh } = read(`${ROOF}s 1\n${LEFT}${RIGHT}`);
    expect(mesh.positions).toHaveLength(18);
    near(at(mesh, 0, mesh.normals!)[1]!, slanted);
    near(at(mesh, 0, mesh.normals!)[0]!, [0, 0, 1]);
  });
  test('two groups, or a group and none: an edge between', () => {
    for (const [first, second] of [
      ['1', '2'],
      ['1', 'off'],
      ['0', '1'],
    ]) {
      // biome-ignore format: short
      const { mesh } = read(`${ROOF}s ${first}\n${LEFT}s ${second}\n${RIGHT}`);
      expect(mesh.positions).toHaveLength(24);
      for (const n of at(mesh, 0, mesh.normals!)) near(n, [0, 0, 1]);
      for (const n of at(mesh, 2, mesh.normals!)) near(n, [1, 0, 0]);
    }
  });
  test('some faces have them', () => {
    const { mesh } = read(`${ROOF}vn 0 0 -1\nf 1//1 2//1 3//1 4//1\n${RIGHT}`);
    expect(at(mesh, 0, mesh.normals!)).toEqual([[0, 0, -1], [0, 0, -1], [0, 0, -1]]); // biome-ignore format: short
    for (const n of at(mesh, 2, mesh.normals!)) near(n, [1, 0, 0]);
  });
  test('some are no numbers', () => {
    const { mesh, notes } = read(`${SQUARE}vn nan nan nan\nf 1//1 2//1 3//1`);
    near(at(mesh, 0, mesh.normals!)[0]!, [0, 0, 1]);
    expect(notes[0]).toMatch(/: 3 normals without direction/);
  });
});

test('a part for each material, in the order of use, or one of all', () => {
  const lines = `mtllib a b.mtl c.mtl\nmtllib c.mtl\n${SQUARE}f 1 2 3\nusemtl red  paint\nf 1 3 4\nusemtl steel\nf 1 2 4\nusemtl red  paint\nf 2 3 4`;
  const { parts, materialFiles } = read(lines);
  expect(parts.map(({ name, mesh }) => [name, mesh.indices.length / 3])).toEqual([['', 1], ['red  paint', 2], ['steel', 1]]); // biome-ignore format: short
  expect(materialFiles).toEqual(['a b.mtl', 'c.mtl']);
  expect(read('mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3').materialFiles).toEqual(['a.mtl', 'b.mtl']);
  const all = read(lines, { asOne: true });
  expect(all.parts.map(({ name, mesh }) => [name, mesh.indices.length / 3, mesh.positions.length / 3])).toEqual([['', 4, 4]]); // biome-ignore format: short
});

test('colours of vertices are those of a screen, white where there are none', () => {
  const { mesh } = read('v 0 0 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1\nf 1 2 3');
  const half = Math.fround(srgbToLinear(0.5));
  expect(at(mesh, 0, mesh.colors!, 4)).toEqual([[1, 1, 1, 1], [1, half, 0, 1], [1, 1, 1, 1]]); // biome-ignore format: short
});

test('polygons with a notch, faces that are none, other statements', () => {
  const { mesh, notes, degenerate } = read(
    `v 0 0 0\nv 4 4 0\nv 0 2 0\nv -4 4 0\nf 1 2 3 4\nf 1 2\nf 1 1 2\nl 1 2\nl 2 3\ng x\no y\ncurv2 1 2`,
  );
  expect(mesh.indices).toHaveLength(6);
  expect(at(mesh, 0, mesh.positions).flat()).toContain(2);
  expect(degenerate).toBe(1);
  expect(notes).toEqual([
    'Left out: 1 triangle without area.',
    'Left out: 1 face of fewer than three corners.',
    'Nothing is made of its lines "l" (2), "curv2" (1).',
  ]);
});

test('references to normals and texture coordinates of which there are none', () => {
  const { mesh, notes } = read(`${SQUARE}f 1/1/1 2/1/1 3/1/1`);
  expect([mesh.normals, mesh.uvs, mesh.positions.length]).toEqual([undefined, undefined, 9]);
  expect(notes).toEqual(
    ['texture coordinates', 'normals'].map((kind) => `Its faces refer to ${kind}, which it has none of.`),
  );
});

test('a mark of byte order at the start is no word', () =>
  expect(read(`\ufeff${SQUARE}f 1 2 3`).mesh.indices).toHaveLength(3));

test('references to what comes later in the file', () =>
  expect(read(`f 1 2 3\n${SQUARE}`).mesh.indices).toHaveLength(3));

test.each([
  ['a vertex that is not there', `${SQUARE}f 1 2 5`, 'At line 5 "it.obj" has the number 5 of a vertex; expected at most 4.'],
  ['a texture coordinate that is not there', `${SQUARE}vt 0 0\nf 1/1 2/2 3/1`, 'the number 2 of a texture coordinate; expected at most 1.'],
  ['a normal that is not there', `${SQUARE}vn 0 0 1\nf 1//1 2//2 3//1`, 'At line 6 "it.obj" has the number 2 of a normal; expected at most 1.'],
  ['too far back', `${SQUARE}f -5 -4 -3`, 'At line 5 "it.obj" has "-5" as corner 1 of a face; expected numbers'],
  ['number 0', `${SQUARE}f 1 0 2`, '"0" as corner 2 of a face'],
  ['words as corners', `${SQUARE}f 1 b 2`, '"b" as corner 2 of a face'],
  ['fractions', `${SQUARE}f 1.5 2 3`, '"1.5" as corner 1 of a face'],
  ['four numbers', `${SQUARE}f 1/1/1/1 2 3`, '"1/1/1/1" as corner 1 of a face'],
  ['a milliard of milliards', `${SQUARE}f 1 2 3000000000`, '"3000000000" as corner 3 of a face'],
  ['two coordinates', 'v 1 2\nf 1 1 1', 'At line 1 "it.obj" has the vertex 1 2 NaN'],
  ['a word as coordinate', `v 1 two 3\n${SQUARE}f 1 2 3`, 'the vertex 1 NaN 3'],
  ['an infinite vertex', `${SQUARE}v 1 inf 3\nf 1 2 3`, 'At line 5 "it.obj" has the vertex 1 Infinity 3'],
  ['a word as normal', `${SQUARE}vn up 0 0\nf 1 2 3`, 'At line 5 "it.obj" has too few numbers, or others; expected 3 numbers.'],
  ['no faces', SQUARE, 'no faces; expected lines that begin with "f"'],
  ['nothing', '', 'no faces'],
  ['triangles without area', 'v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3', '1 triangles, none of which has an area'],
  ['what is no OBJ file', '\u0001\u0002\u0003 x', 'the word "\\u0001\\u0002\\u0003"'],
])('%s', (_, lines, expected) => expect(problems(lines)[0]).toContain(expected)); // biome-ignore format: table

test('all faults are told, one sentence each', () => {
  expect(problems(`${SQUARE}f 1 2 x\nf 1 2 9\nv a b c\nf 1 2 3`)).toHaveLength(3);
});
