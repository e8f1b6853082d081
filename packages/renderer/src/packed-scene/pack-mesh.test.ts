import { expect, test } from 'vitest';
import { landscape } from '../../../../tests/fixtures/meshes.ts';
import { seededRandom } from '../../../../tests/fixtures/random.ts';
import type { Mesh } from '../scene/mesh.ts';
import { fieldOffset, GEOMETRY_ROW, structSize, VERTEX_FLAGS } from './layout.ts';
import { packMesh } from './pack-mesh.ts';
import { packVertices } from './pack-vertices.ts';
import { wordsOf } from './packed-mesh.ts';

/** What shading/mesh/octahedral.wesl makes of a code. */
function fromOctahedral(code: number): number[] {
  const [x, y] = [(code & 0xffff) / 32767 - 1, (code >>> 16) / 32767 - 1];
  const z = 1 - Math.abs(x) - Math.abs(y);
  const [u, v] = z < 0 ? [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)] : [x, y];
  const size = Math.hypot(u, v, z);
  return [u / size, v / size, z / size];
}

function decorated(mesh: Mesh, seed: number): Mesh & { normals: Float32Array; tangents: Float32Array } {
  const random = seededRandom(seed);
  const count = mesh.positions.length / 3;
  const unit = () => {
    const v = [random() - 0.5, random() - 0.5, random() - 0.5];
    const size = Math.hypot(...v);
    return v.map((x) => x / size);
  };
  const each = (make: () => number[]) => Float32Array.from(Array.from({ length: count }, make).flat());
  return {
    ...mesh,
    normals: each(unit),
    tangents: each(() => [...unit(), random() < 0.5 ? -1 : 1]),
    uvs: [each(() => [random() * 9 - 4, random()]), each(() => [random(), random()])],
    colors: each(() => [random(), Math.round(random() * 255) / 255, Math.round(random() * 65535) / 65535, 1]),
  };
}

const WORDS = (structSize('Vertex') + structSize('VertexMore')) / 4;

test('each vertex is held with all it has, in the order of the mesh (seed 7)', () => {
  const mesh = decorated(landscape(seededRandom(5), 6), 7);
  const { words, rows, flags } = packVertices(mesh);
  const floats = new Float32Array(words.buffer);
  expect(rows * GEOMETRY_ROW).toBe(WORDS);
  expect(flags).toBe(VERTEX_FLAGS.hasNormals | VERTEX_FLAGS.hasTangents);
  const more = structSize('Vertex') / 4;
  for (let v = 0; v < mesh.positions.length / 3; v++) {
    const at = v * WORDS;
    const word = (offset: number) => words[at + offset / 4]!;
    const near = (code: number, [x, y, z]: Float32Array, error: number) => {
      const held = fromOctahedral(code);
      expect(Math.hypot(held[0]! - x!, held[1]! - y!, held[2]! - z!)).toBeLessThan(error);
    };
    near(word(fieldOffset('Vertex', 'normal')), mesh.normals.subarray(3 * v), 6.6e-5);
    const tangent = word(fieldOffset('Vertex', 'tangent'));
    near(tangent, mesh.tangents.subarray(4 * v), 1.4e-4);
    expect((tangent >>> 16) & 1).toBe(mesh.tangents[4 * v + 3]! < 0 ? 1 : 0);
    const uv = at + fieldOffset('Vertex', 'uv') / 4;
    expect([...floats.subarray(uv, uv + 2)]).toEqual([...mesh.uvs![0]!.subarray(2 * v, 2 * v + 2)]);
    const second = at + more + fieldOffset('VertexMore', 'uv') / 4;
    expect([...floats.subarray(second, second + 2)]).toEqual([...mesh.uvs![1]!.subarray(2 * v, 2 * v + 2)]);
    const codes = [
      word(4 * more + fieldOffset('VertexMore', 'redGreen')),
      word(4 * more + fieldOffset('VertexMore', 'blueAlpha')),
    ];
    const color = codes.flatMap((code) => [(code & 0xffff) / 65535, (code >>> 16) / 65535]);
    // Numbers of 8 and 16 bits are held exactly, others to half a step.
    expect(Math.abs(color[0]! - mesh.colors![4 * v]!)).toBeLessThanOrEqual(0.5001 / 65535);
    expect(color.slice(1).map(Math.fround)).toEqual([...mesh.colors!.subarray(4 * v + 1, 4 * v + 4)]);
  }
});

test('a mesh has rows for what it has', () => {
  const { positions, indices, normals, uvs, colors } = decorated(landscape(seededRandom(5), 2), 7);
  const rows = (rest: Partial<Mesh>) => packVertices({ positions, indices, ...rest }).rows;
  expect([rows({}), rows({ normals }), rows({ uvs: [uvs![0]!] })]).toEqual([0, 1, 1]);
  expect([rows({ uvs: uvs! }), rows({ colors: colors! })]).toEqual([2, 2]);
  const white = packVertices({ positions, indices, uvs: uvs! }).words;
  expect(white[structSize('Vertex') / 4 + fieldOffset('VertexMore', 'redGreen') / 4]).toBe(0xffffffff);
});

test('triangles name the vertices that the mesh gives them, in the order of the tree', () => {
  const mesh = decorated(landscape(seededRandom(5), 9), 7);
  const { triangles, order } = packMesh(mesh);
  const stride = structSize('Triangle') / 4;
  const numbers = (['vertexA', 'vertexB', 'vertexC'] as const).map((field) => fieldOffset('Triangle', field) / 4);
  order.forEach((triangle, place) => {
    const named = numbers.map((at) => triangles[place * stride + at]!);
    expect(named).toEqual([...mesh.indices.subarray(3 * triangle, 3 * triangle + 3)]);
  });
});

test('tree, triangles and all that vertices may have take less than 100 bytes a triangle', () => {
  const mesh = decorated(landscape(seededRandom(5), 180), 7);
  const bytes = wordsOf(packMesh(mesh)).reduce((sum, { byteLength }) => sum + byteLength, 0);
  expect(bytes / (mesh.indices.length / 3)).toBeLessThan(100);
});
