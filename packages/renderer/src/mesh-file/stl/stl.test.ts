import { describe, expect, test } from 'vitest';
import { displacedSphere } from '../../../../../tests/fixtures/meshes/landscapes.ts';
import { cubeMesh } from '../../../../../tests/fixtures/meshes/solids.ts';
import { stlBinary, stlText } from '../../../../../tests/fixtures/meshes/stl-files.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { readStl } from './read-stl.ts';

const read = (bytes: Uint8Array) => {
  const file = readStl(bytes, 'it.stl');
  if (!file.ok) throw new Error(file.problems.map(({ message }) => message).join('\n'));
  return { ...file, mesh: file.parts[0]!.mesh };
};
const problems = (bytes: Uint8Array): string => {
  const file = readStl(bytes, 'it.stl');
  return file.ok ? 'none' : file.problems.map(({ message }) => message).join('\n');
};
const text = (lines: string) => new TextEncoder().encode(lines);
/** The same triangles, whatever the order of vertices; −0 is 0. */
const cornersOf = ({ positions, indices }: Mesh) =>
  Array.from(indices, (i) => [...positions.subarray(3 * i, 3 * i + 3)].map((x) => x + 0));

describe.each([
  ['bytes', stlBinary],
  ['text', stlText],
] as const)('%s', (_, write) => {
  test.each([
    ['a cube', cubeMesh()],
    ['a dented ball', displacedSphere({ triangles: 300, smooth: false })],
  ])('%s comes back with its corners welded', (_name, mesh) => {
    const { mesh: found, notes, degenerate, parts } = read(write(mesh));
    expect(cornersOf(found)).toEqual(cornersOf(mesh));
    expect(found.positions).toHaveLength(mesh.positions.length);
    expect([found.normals, notes, degenerate, parts.length]).toEqual([undefined, [], 0, 1]);
  });
  test('a triangle without area is left out and counted', () => {
    const { positions, indices } = cubeMesh();
    const { notes, degenerate } = read(write({ positions, indices: Uint32Array.of(...indices, 3, 3, 1) }));
    expect([degenerate, notes]).toEqual([1, ['Left out: 1 triangle without area.']]);
  });
  test('no triangles', () =>
    expect(problems(write({ ...cubeMesh(), indices: new Uint32Array() }))).toContain('no triangles'));
  test('a place that is none', () => {
    const { positions, indices } = cubeMesh();
    positions[0] = Number.NaN;
    expect(problems(write({ positions, indices }))).toMatch(/^At (byte 96|line 4) "it.stl" has /);
  });
});

describe('bytes', () => {
  test('that begin with "solid", as a text does', () => {
    for (const header of ['solid', 'solid made by a program', 'solid facet normal', '  SOLID']) {
      expect(read(stlBinary(cubeMesh(), header)).mesh.indices).toHaveLength(36);
      const longer = Uint8Array.of(...stlBinary(cubeMesh(), header), 0, 0, 0);
      if (!header.includes('facet'))
        expect(read(longer).notes).toEqual(['Nothing is made of 3 bytes after the last triangle.']);
    }
  });
  test('that end too early, or claim too much', () => {
    const bytes = stlBinary(cubeMesh());
    expect(problems(bytes.subarray(0, -1))).toBe('At byte 80 "it.stl" has 12 as the number of triangles, and bytes for 11; expected at most 11.'); // biome-ignore format: long
    new DataView(bytes.buffer).setUint32(80, 4e9, true);
    expect(problems(bytes)).toContain('4000000000 as the number of triangles, and bytes for 12');
    expect(problems(bytes.subarray(0, 40))).toContain('40 bytes; expected at least the 84 of a header');
    expect(problems(new Uint8Array())).toContain('0 bytes');
  });
});

describe('text', () => {
  const FACET = 'facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n';
  test('several solids, capitals, facets in one line, no name, no end of the last line', () => {
    const one = `solid a b\n${FACET}endsolid a b\nSOLID\n${FACET.replaceAll('\n', ' ').replace('1 0 0', '5 0 0').toUpperCase()}\nendsolid`;
    expect(read(text(one)).mesh.indices).toHaveLength(6);
    expect(read(text(one)).mesh.positions).toHaveLength(12);
  });
  test('a loop of four', () => {
    const square = FACET.replace('vertex 0 1 0', 'vertex 1 1 0\nvertex 0 1 0');
    expect([...read(text(`solid\n${square}endsolid`)).mesh.indices]).toEqual([0, 1, 2, 0, 2, 3]);
  });
  test.each([
    ['an end within a facet', 'endfacet\n', '', 'At line 8 "it.stl" has its end within a facet'],
    ['a loop that does not end', 'endloop\nendfacet\nendsolid', '', 'its end within a loop'],
    ['a solid that does not end', 'endsolid', '', 'its end within a solid'],
    ['two corners', 'vertex 1 0 0\n', '', 'At line 6 "it.stl" has a loop of 2 vertices; expected three of them.'],
    ['a corner of two numbers', 'vertex 1 0 0', 'vertex 1 0', 'At line 5 "it.stl" has the corner 1 0 NaN'],
    ['a corner outside', 'outer loop\n', '', 'At line 3 "it.stl" has a vertex outside of any loop'],
    ['another word', 'outer loop', 'inner loop', 'At line 3 "it.stl" has the word "inner"'],
    ['words as numbers', 'vertex 0 1 0', 'vertex zero one nought', 'the corner NaN NaN NaN'],
  ])('%s', (_, from, to, expected) => {
    const lines = `solid\n${FACET}endsolid`;
    expect(lines).toContain(from);
    expect(problems(text(lines.replace(from, to)))).toContain(expected);
  });
});
