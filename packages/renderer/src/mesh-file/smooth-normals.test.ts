import { expect, test } from 'vitest';
import { displacedSphere, heightField } from '../../../../tests/fixtures/meshes/landscapes.ts';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { triangleCount } from '../scene/mesh.ts';
import { meshFault } from '../scene/mesh-fault.ts';
import { smoothNormals } from './smooth-normals.ts';
import { weld } from './weld.ts';

test('vertices at one place are one, 0 and −0 too', () => {
  const positions = Float32Array.of(1, 2, 3, 0, 0, 0, 1, 2, 3, -0, 0, -0, 1, 2, 3.0000002);
  expect(weld(positions)).toEqual({ placeOf: Uint32Array.of(0, 1, 0, 1, 2), places: 3 });
  expect(weld(new Float32Array()).places).toBe(0);
  const many = Float32Array.from({ length: 3 * 5000 }, (_, k) => Math.floor(k / 3) % 1000);
  expect(weld(many).places).toBe(1000);
});

test('a ball has normals from its centre, a plain one up', () => {
  const ball = displacedSphere({ triangles: 5000, relief: 0 });
  for (let k = 0; k < ball.positions.length; k++) expect(ball.normals![k]).toBeCloseTo(ball.positions[k]!, 2);
  const plain = heightField({ triangles: 50, relief: 0 });
  expect([...plain.normals!].every((x, k) => x === (k % 3 === 1 ? 1 : 0))).toBe(true);
});

test('it does not matter how the faces of a cube are cut, nor whether vertices are shared', () => {
  const { positions, indices } = cubeMesh();
  const shared = smoothNormals(positions, indices);
  const third = Math.sqrt(1 / 3);
  shared.forEach((x, k) => {
    expect(x).toBeCloseTo(2 * third * positions[k]!, 6);
  });
  const apart = Float32Array.from({ length: 3 * indices.length }, (_, k) => positions[3 * indices[Math.floor(k / 3)]! + (k % 3)]!); // biome-ignore format: one thing
  const normals = smoothNormals(
    apart,
    indices.map((_, k) => k),
  );
  normals.forEach((x, k) => {
    expect(x).toBeCloseTo(2 * third * apart[k]!, 6);
  });
});

test('where there is no direction there is one all the same', () => {
  const back = {
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9),
    indices: Uint32Array.of(0, 1, 2, 0, 2, 1),
  };
  expect(meshFault({ ...back, normals: smoothNormals(back.positions, back.indices) })).toBeNull();
  const line = { positions: Float32Array.of(0, 0, 0, 1, 1, 1, 2, 2, 2), indices: Uint32Array.of(0, 1, 2) };
  expect(meshFault({ ...line, normals: smoothNormals(line.positions, line.indices) })).toBeNull();
});

test('the generators give as many triangles as asked for, outside out, the same for the same seed', () => {
  for (const triangles of [1, 10, 500, 10_000])
    for (const make of [displacedSphere, heightField]) {
      const mesh = make({ triangles });
      expect(triangleCount(mesh)).toBeGreaterThanOrEqual(triangles);
      expect(triangleCount(mesh)).toBeLessThan(1.1 * triangles + 60);
      expect(meshFault(mesh)).toBeNull();
    }
  expect(displacedSphere({ triangles: 100, seed: 4 })).toEqual(displacedSphere({ triangles: 100, seed: 4 }));
  expect(displacedSphere({ triangles: 100, seed: 4 })).not.toEqual(displacedSphere({ triangles: 100, seed: 5 }));
  const { positions, normals } = displacedSphere({ triangles: 900 });
  for (let k = 0; k < positions.length; k += 3)
    expect([0, 1, 2].reduce((sum, c) => sum + positions[k + c]! * normals![k + c]!, 0)).toBeGreaterThan(0);
});
