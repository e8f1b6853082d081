import { describe, expect, test } from 'vitest';
import { displacedSphere } from '../../../../../tests/fixtures/meshes/landscapes.ts';
import { PLY_FORMS, type PlyColumn, type PlyFileType, type PlyTable, plyColumns, plyFile } from '../../../../../tests/fixtures/meshes/ply-files.ts'; // biome-ignore format: one line
import { cubeMesh, triangleMesh } from '../../../../../tests/fixtures/meshes/solids.ts';
import { pick, type Random, seededRandom } from '../../../../../tests/fixtures/random.ts';
import { srgbToLinear } from '../../display/srgb.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { MeshContent } from '../mesh-file.ts';
import { readPly } from './read-ply.ts';
import { writePly } from './write-ply.ts';

function read(bytes: Uint8Array): MeshContent {
  const file = readPly(bytes, 'it.ply');
  if (!file.ok) throw new Error(file.problems.map(({ message }) => message).join('\n'));
  return file;
}
const meshOf = (bytes: Uint8Array): Mesh => read(bytes).parts[0]!.mesh;
const text = (...lines: string[]) => new TextEncoder().encode(lines.join('\n'));
function problems(bytes: Uint8Array): string {
  const file = readPly(bytes, 'it.ply');
  return file.ok ? 'none' : file.problems.map(({ message }) => message).join('\n');
}

const faceRows = (indices: ArrayLike<number>) =>
  Array.from({ length: indices.length / 3 }, (_, k) => [indices[3 * k]!, indices[3 * k + 1]!, indices[3 * k + 2]!]);
const faces = (rows: readonly (readonly number[])[], type: PlyFileType = 'i32', name = 'vertex_indices'): PlyColumn => ({ name, count: 'u8', type, rows }); // biome-ignore format: short
const shuffled = <T>(random: Random, things: readonly T[]): T[] =>
  things.map((thing) => [random(), thing] as const).sort(([a], [b]) => a - b).map(([, thing]) => thing); // biome-ignore format: short

describe('what is written is read back', () => {
  test('all that a file may hold', () => {
    const ball = displacedSphere({ triangles: 200 });
    const vertices = ball.positions.length / 3;
    const uv = Float32Array.from({ length: 2 * vertices }, (_, k) => (k % 64) / 64);
    const colors = Float32Array.from({ length: 4 * vertices }, (_, k) => (k % 7) / 2);
    const { parts, notes, degenerate } = read(writePly({ ...ball, uvs: [uv], colors }));
    expect([parts.length, parts[0]!.name, notes, degenerate]).toEqual([1, '', [], 0]);
    const { normals, ...rest } = parts[0]!.mesh;
    expect(rest).toEqual({ positions: ball.positions, indices: ball.indices, uvs: [uv], colors });
    normals!.forEach((x, k) => {
      expect(x).toBeCloseTo(ball.normals![k]!, 6);
    });
  });
  test('as little as it may', () => expect(meshOf(writePly(cubeMesh()))).toEqual(cubeMesh()));
});

describe.each(PLY_FORMS)('%s', (form) => {
  test.each([70, 71, 72, 73, 74, 75, 76, 77])(
    'properties of any type, in any order, among others (seed %i)',
    (seed) => {
      const random = seededRandom(seed);
      const vertices = 20;
      // Whole numbers, so that each type holds them.
      const numbers = (count: number, most = 100) =>
        Float32Array.from({ length: count }, () => Math.floor(random() * most));
      const [positions, normals] = [numbers(3 * vertices), numbers(3 * vertices, 5).map((x) => x + 1)];
      const type = () => pick(random, ['i8', 'u8', 'i16', 'u16', 'i32', 'u32', 'f32', 'f64'] as const);
      const indexType = () => pick(random, ['i8', 'u8', 'i16', 'u16', 'i32', 'u32', 'f32', 'f64'] as const);
      const rows = Array.from({ length: 15 }, () =>
        [0, 1, 2].map((k) => (Math.floor(random() * 6) * 3 + k) % vertices),
      );
      const other = (name: string, count: number): PlyColumn =>
        random() < 0.5
          ? { name, type: type(), rows: Array.from({ length: count }, () => 7) }
          : {
              name,
              count: type(),
              type: type(),
              rows: Array.from({ length: count }, (_, k) => new Array(k % 4).fill(5)),
            };
      const columns = shuffled(random, [
        ...plyColumns(['x', 'y', 'z'], type(), positions),
        ...plyColumns(['nx', 'ny', 'nz'], type(), normals),
        other('quality', vertices),
        other('confidence', vertices),
      ]);
      const list = { ...faces(rows, indexType(), pick(random, ['vertex_indices', 'vertex_index'])), count: type() };
      const tables = shuffled(random, [
        { name: 'vertex', columns },
        { name: 'face', columns: shuffled(random, [list, other('flags', rows.length)]) },
        { name: 'edge', columns: [other('vertex1', 3), other('vertex2', 3)] },
        { name: 'nothing', columns: [] },
      ]);
      const { parts, notes, degenerate } = read(plyFile(form, tables, random, pick(random, ['\n', '\r\n'])));
      const { mesh } = parts[0]!;
      expect(mesh.positions).toEqual(positions);
      expect(mesh.indices.length / 3 + degenerate).toBe(rows.length);
      mesh.normals!.forEach((x, k) => {
        const first = k - (k % 3);
        expect(x).toBeCloseTo(normals[k]! / Math.hypot(...normals.subarray(first, first + 3)), 6);
      });
      for (const passed of ['"edge"', '"quality"', '"confidence"', '"face.flags"'])
        expect(notes.join()).toContain(passed);
    },
  );

  test('faces before vertices, polygons, tiny faces', () => {
    const { positions } = cubeMesh();
    const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1], [], [0, 1, 5, 4]]; // biome-ignore format: short
    const tables = [
      { name: 'face', columns: [faces(quads)] },
      { name: 'vertex', columns: plyColumns(['x', 'y', 'z'], 'f32', positions) },
    ];
    const { parts, notes } = read(plyFile(form, tables));
    expect([...parts[0]!.mesh.indices]).toEqual([0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4]);
    expect(notes).toEqual(['Left out: 2 faces of fewer than three corners.']);
  });

  test('colours of bytes are those of a screen, others are light; v counts from below', () => {
    const columns = (type: PlyFileType, values: number[]): PlyTable[] => [
      {
        name: 'vertex',
        columns: [
          ...plyColumns(['x', 'y', 'z'], 'f32', triangleMesh().positions),
          ...plyColumns(['red', 'green', 'blue', 'alpha'], type, values),
          ...plyColumns(['s', 't'], 'f32', [0, 0.25, 0.5, 0.75, 1, 1]),
        ],
      },
      { name: 'face', columns: [faces([[0, 1, 2]])] },
    ];
    const bytes = meshOf(plyFile(form, columns('u8', [255, 128, 0, 255, 0, 0, 0, 51, 9, 9, 9, 0])));
    expect(bytes.colors![1]).toBeCloseTo(srgbToLinear(128 / 255), 6);
    expect([bytes.colors![0], bytes.colors![2], bytes.colors![3]]).toEqual([1, 0, 1]);
    expect(bytes.colors![7]).toBeCloseTo(0.2, 6);
    expect([...bytes.uvs![0]!]).toEqual([0, 0.75, 0.5, 0.25, 1, 0]);
    const light = meshOf(plyFile(form, columns('f32', [2.5, 0.5, 0, 1, 0, 0, 0, 0.25, -1, 0, 0, 1])));
    expect([...light.colors!.subarray(0, 8)]).toEqual([2.5, 0.5, 0, 1, 0, 0, 0, 0.25]);
    expect(light.colors![8]).toBe(0);
  });

  test('places that are none, and vertices that are not there, each with its place', () => {
    const positions = Float32Array.from({ length: 30 }, (_, k) => k * k);
    positions[4] = Number.NaN;
    positions[29] = -Infinity;
    const tables = [
      { name: 'vertex', columns: plyColumns(['x', 'y', 'z'], 'f32', positions) },
      { name: 'face', columns: [faces([[0, 1, 2], [0, 1, 10], [0, -1, 2]])] }, // biome-ignore format: short
    ];
    const lines = problems(plyFile(form, tables)).split('\n');
    expect(lines.map((line) => line.replace(/^At (?:line|byte) \d+ "it.ply" has /, ''))).toEqual([
      'NaN as "y" of vertex 1; expected a number from -1e9 to 1e9.',
      '-Infinity as "z" of vertex 9; expected a number from -1e9 to 1e9.',
      'the vertex 10 in face 1; expected a whole number from 0 to 9.',
      'the vertex -1 in face 2; expected a whole number from 0 to 9.',
    ]);
    if (form === 'ascii') expect(lines[0]).toMatch(/^At line 12 /);
    else expect(lines[0]).toMatch(/^At byte \d+ /);
  });

  test('normals without direction come from the triangles around', () => {
    const normals = [0, 0, 2, 0, 0, 0, Number.NaN, 0, 1];
    const columns = [
      ...plyColumns(['x', 'y', 'z'], 'f32', triangleMesh().positions),
      ...plyColumns(['nx', 'ny', 'nz'], 'f32', normals),
    ];
    const { parts, notes } = read(plyFile(form, [{ name: 'vertex', columns }, { name: 'face', columns: [faces([[0, 1, 2]])] }])); // biome-ignore format: short
    expect([...parts[0]!.mesh.normals!]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect(notes).toEqual(['Made of the triangles around: 2 normals without direction.']);
  });

  test('triangles without area are left out and counted', () => {
    const positions = [0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 1, 0, 0];
    const rows = [[0, 1, 3], [0, 1, 2], [1, 1, 2], [0, 1, 4]]; // biome-ignore format: short
    const tables = [
      { name: 'vertex', columns: plyColumns(['x', 'y', 'z'], 'f32', positions) },
      { name: 'face', columns: [faces(rows)] },
    ];
    const { parts, degenerate, notes } = read(plyFile(form, tables));
    expect([[...parts[0]!.mesh.indices], degenerate]).toEqual([[0, 1, 2], 3]);
    expect(notes).toEqual(['Left out: 3 triangles without area.']);
    const flat = [tables[0]!, { name: 'face', columns: [faces([[0, 1, 3]])] }];
    expect(problems(plyFile(form, flat))).toContain('none of which has an area');
  });

  test('strips of triangles', () => {
    const { positions } = cubeMesh();
    const strips = [[0, 2, 1, 3, -1, 4, 5, 6, 7]];
    const tables = [
      { name: 'vertex', columns: plyColumns(['x', 'y', 'z'], 'f32', positions) },
      { name: 'tristrips', columns: [{ ...faces(strips), count: 'i32' as const }] },
    ];
    expect(faceRows(meshOf(plyFile(form, tables)).indices)).toEqual([[0, 2, 1], [1, 2, 3], [4, 5, 6], [6, 5, 7]]); // biome-ignore format: short
  });
});

const HEAD = [
  'ply',
  'format ascii 1.0',
  'element vertex 3',
  'property float x',
  'property float y',
  'property float z',
];
const FACE = ['element face 1', 'property list uchar int vertex_indices', 'end_header'];
const BODY = ['0 0 0', '1 0 0', '0 1 0', '3 0 1 2'];

describe('a header that claims too much fails at once', () => {
  test.each(PLY_FORMS)('a milliard of vertices (%s)', (form) => {
    const claim = [...HEAD, ...FACE, ...BODY]
      .join('\n')
      .replace('vertex 3', 'vertex 1000000000')
      .replace('ascii', form);
    expect(problems(text(claim))).toBe(
      'At line 3 "it.ply" has 1000000000 vertices; expected at most 16777216 of them.',
    );
    const less = claim.replace('1000000000', '16000000');
    expect(problems(text(less))).toMatch(/^At line 3 "it.ply" has 16000000 × "vertex", which take at least \d+ bytes, and \d+ bytes left for them; expected /); // biome-ignore format: long
  });
  test.each(PLY_FORMS)('a milliard of faces, or of anything else (%s)', (form) => {
    const good = [...HEAD, ...FACE, ...BODY, ...BODY].join('\n').replace('ascii', form);
    expect(problems(text(good.replace('face 1', 'face 1000000000')))).toContain('1000000000 × "face"');
    const other = good.replace(
      'element vertex',
      'element fog 999999999999999\nproperty double density\nelement vertex',
    );
    expect(problems(text(other))).toContain('999999999999999 × "fog"');
  });
  test('a list of milliards', () => {
    const list = (count: string) => text(...HEAD, ...FACE, ...BODY.slice(0, 3), `${count} 0 1 2`);
    expect(problems(list('4000000000'))).toContain('a list of 4000000000 items, and 6 bytes left');
    expect(problems(list('-3'))).toContain('-3 as the length of a list');
    expect(problems(list('3.5'))).toContain('"3.5"; expected a whole number');
  });
});

describe('mistakes in a header', () => {
  const broken = (from: string, to: string) => problems(text([...HEAD, ...FACE, ...BODY].join('\n').replace(from, to)));
  test('none', () => expect(broken('', '')).toBe('none'));
  test.each([
    ['no ply', 'ply', 'plx', 'At line 1 "it.ply" has "plx" at its start; expected the word "ply".'],
    ['an unknown format', 'ascii', 'text', 'At line 2 "it.ply" has the format "text"'],
    ['another version', '1.0', '2.0', 'At line 2 "it.ply" has the version "2.0"'],
    ['no format', 'format ascii 1.0', 'comment none', 'no line "format" in its header'],
    ['half a count', 'vertex 3', 'vertex 3.5', 'At line 3 "it.ply" has "3.5" as the number of "vertex"'],
    ['a negative count', 'face 1', 'face -1', 'At line 7 "it.ply" has "-1" as the number of "face"'],
    ['an unknown type', 'float y', 'quad y', 'At line 5 "it.ply" has the type "quad"; expected one of the types char,'],
    ['a type that objects inherit', 'float y', 'valueOf y', 'the type "valueOf"'],
    ['a property without name', 'float z', 'float', 'At line 6 "it.ply" has a property without a name'],
    ['a property first', 'element vertex 3', 'comment', 'a property before any element'],
    ['an unknown word', 'element face 1', 'elephant face 1', 'At line 7 "it.ply" has the word "elephant" in its header'],
    ['no end', 'end_header', 'comment', 'no end of the header'],
    ['no z', 'float z', 'float w', 'At line 3 "it.ply" has vertices without "x", "y" and "z"'],
    ['a list as x', 'float x', 'list uchar float x', 'vertices without'],
    ['faces without a list', 'list uchar int vertex_indices', 'int vertex_indices', '"face" without a list'],
    ['no vertices', 'vertex 3', 'point 3', 'the vertex 0 in face 0; expected no faces, as there are no vertices'],
    ['no faces', 'face 1', 'face 0', 'no faces: it is a cloud of points'],
    ['too few rows', '3 0 1 2', '', 'its end; expected all the rows'],
    ['too few numbers', '1 0 0', '1 0', 'At line 11 "it.ply" has too few numbers in a row; expected a number.'],
    ['a word as number', '0 1 0', '0 one 0', 'At line 12 "it.ply" has "one"; expected a number.'],
    ['half a vertex', '3 0 1 2', '3 0 1 1.5', 'At line 13 "it.ply" has "1.5"; expected a whole number.'],
  ])('%s', (_, from, to, expected) => expect(broken(from, to)).toContain(expected)); // biome-ignore format: table

  test('several are told together', () => {
    const lines = [...HEAD, ...FACE].join('\n').replace('float x', 'foat x').replace('face 1', 'face many');
    expect(problems(text(lines)).split('\n')).toHaveLength(2);
  });
  test('of many faults in the numbers the first are told, and how many more there are', () => {
    const rows = Array.from({ length: 100 }, () => '3 7 8 9');
    const lines = problems(text(...HEAD, 'element face 100', ...FACE.slice(1), ...BODY.slice(0, 3), ...rows)).split(
      '\n',
    );
    expect(lines).toHaveLength(21);
    expect(lines.at(-1)).toBe('… and 80 more problems.');
  });
});

test('the line that ends a binary header may end in three ways', () => {
  const { positions, indices } = triangleMesh();
  // Its first byte looks like the end of a line.
  const tables = [
    { name: 'vertex', columns: [{ name: 'flag', type: 'u8' as const, rows: [10, 13, 10] }, ...plyColumns(['x', 'y', 'z'], 'f32', positions)] },
    { name: 'face', columns: [faces(faceRows(indices))] },
  ]; // biome-ignore format: short
  for (const newline of ['\n', '\r\n', '\r'])
    expect(meshOf(plyFile('binary_little_endian', tables, undefined, newline)).positions).toEqual(positions);
});
