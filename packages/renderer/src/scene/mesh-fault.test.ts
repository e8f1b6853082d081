import { expect, test } from 'vitest';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import type { Mesh } from './mesh.ts';
import { crowdFault, meshFault } from './mesh-fault.ts';

const fill = (count: number, value = 0) => new Float32Array(count).fill(value);
const with_ = (numbers: Float32Array, at: number, value: number) => numbers.map((x, k) => (k === at ? value : x));
const up = () => Float32Array.from({ length: 24 }, (_, k) => (k % 3 === 1 ? 1 : 0));
const cube = cubeMesh();

test('a good mesh, with all that one may have', () => {
  expect(meshFault(cube)).toBeNull();
  const rich: Mesh = {
    ...cube,
    normals: up(),
    tangents: fill(32),
    uvs: [fill(16), fill(16)],
    colors: fill(32, 1),
    skin: { joints: new Uint16Array(32), weights: fill(32, 0.25) },
    morphTargets: [{ positions: fill(24) }, { normals: fill(24), tangents: fill(24) }],
  };
  expect(meshFault(rich)).toBeNull();
});

// biome-ignore lint/suspicious/noExplicitAny: what is tried has no type
const BROKEN: readonly [what: string, mesh: any, fault: RegExp][] = [
  ['nothing', null, /no content/],
  ['lists of numbers', { positions: [0, 0, 0], indices: [0, 0, 0] }, /no Float32Array/],
  ['indices of 16 bits', { ...cube, indices: new Uint16Array(3) }, /no Uint32Array/],
  ['two numbers too many', { ...cube, positions: fill(26) }, /26 numbers as positions/],
  ['half a triangle', { ...cube, indices: new Uint32Array(4) }, /4 indices/],
  ['no triangle', { ...cube, indices: new Uint32Array(0) }, /no triangle/],
  ['a vertex that is not there', { ...cube, indices: Uint32Array.of(0, 1, 2, 3, 8, 1) }, /the vertex 8 in triangle 1, where there are 8 vertices/], // biome-ignore format: table
  ['NaN as position', { ...cube, positions: with_(cube.positions, 7, Number.NaN) }, /NaN at vertex 2/],
  ['a vertex far away', { ...cube, positions: with_(cube.positions, 0, 2e9) }, /the coordinate 2000000000 at vertex 0/],
  ['too few normals', { ...cube, normals: fill(23) }, /23 numbers as normals, where its vertices need 24/],
  ['a long normal', { ...cube, normals: with_(up(), 4, 2) }, /a normal of length 2 at vertex 1/],
  ['a normal of zero', { ...cube, normals: with_(up(), 22, 0) }, /a normal of length 0 at vertex 7/],
  ['infinite tangents', { ...cube, tangents: fill(32, Infinity) }, /Infinity among its tangents/],
  ['three sets of coordinates', { ...cube, uvs: [fill(16), fill(16), fill(16)] }, /3 sets/],
  ['negative colours', { ...cube, colors: fill(32, -1) }, /-1 among its colours, where 0 to 1e9/],
  ['three joints a vertex', { ...cube, skin: { joints: new Uint16Array(24), weights: fill(24) } }, /24 joints/],
  ['joints without weights', { ...cube, skin: { joints: new Uint16Array(32), weights: fill(31) } }, /31 numbers as weights/], // biome-ignore format: table
  ['a short morph target', { ...cube, morphTargets: [{}, { normals: fill(3) }] }, /3 numbers as normals of a morph/],
];
test.each(BROKEN)('%s', (_, mesh, fault) => expect(meshFault(mesh)).toMatch(fault));

test('all meshes of a scene together; one that is there twice counts once', () => {
  const large: Mesh = { positions: cube.positions, indices: new Uint32Array(3 * 2 ** 23) };
  expect(crowdFault([{ data: large }, { data: large }, { data: cube }])).toBeNull();
  expect(crowdFault([{ data: large }, { data: { ...large } }, { data: cube }])).toMatch(/16777228 triangles together/);
});
