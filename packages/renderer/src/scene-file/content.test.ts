import { expect, test } from 'vitest';
import { cubeMesh } from '../../../../tests/fixtures/meshes/solids.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { sceneAt } from '../scene/animation.ts';
import type { MeshSource } from '../scene/mesh.ts';
import type { Scene } from '../scene/scene.ts';
import { goodScene } from './broken/good-scene.ts';
import { parseScene } from './parse-scene.ts';
import { requireScene } from './require-scene.ts';
import { writeScene } from './write-scene.ts';

const at = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
const cube = { type: 'mesh', mesh: 'cube', material: 'white', ...at } as const;
const sceneWith = (source: MeshSource, rest: Partial<Scene> = {}) =>
  testScene({ cube }, {}, { meshes: { cube: source }, ...rest });

test('a scene in memory may have a mesh without a file', () => {
  const data = cubeMesh();
  const scene = requireScene(sceneWith({ data }));
  expect(scene.meshes!.cube).toEqual({ data, shading: 'auto' });
  expect(scene.meshes!.cube!.data).toBe(data);
  expect(requireScene(scene)).toBe(scene);
  expect(() => writeScene(scene)).toThrow('The mesh "cube" has no file');
});

test('and with one, which is all that is written', () => {
  const scene = requireScene(sceneWith({ data: cubeMesh(), file: 'cube.ply' }));
  const parsed = parseScene(writeScene(scene));
  if (!parsed.ok) throw new Error(parsed.problems[0]!.message);
  expect(parsed.scene.meshes).toEqual({ cube: { file: 'cube.ply', shading: 'auto' } });
  expect(parsed.scene.shapes).toEqual(scene.shapes);
  expect(() => requireScene(parsed.scene)).toThrow('The mesh "cube" of "cube.ply" has not been loaded');
  expect(() => requireScene(sceneWith({ file: 'cube.ply' }))).toThrow('has not been loaded');
});

test('normals are made or left out as the shading says, once', () => {
  const data = cubeMesh();
  const smooth = requireScene(sceneWith({ data, shading: 'smooth' })).meshes!.cube!.data!;
  const third = Math.sqrt(1 / 3);
  expect(smooth.normals).toHaveLength(24);
  for (const x of smooth.normals!) expect(Math.abs(x)).toBeCloseTo(third, 6);
  expect(requireScene(sceneWith({ data, shading: 'smooth' })).meshes!.cube!.data).toBe(smooth);
  const flat = requireScene(sceneWith({ data: smooth, shading: 'flat' })).meshes!.cube!.data!;
  expect(flat).toEqual(data);
  expect(requireScene(sceneWith({ data: smooth, shading: 'auto' })).meshes!.cube!.data).toBe(smooth);
});

test('content that cannot be used is told at its place', () => {
  const { indices, positions } = cubeMesh();
  const data = { positions, indices: indices.map((i) => i + 1) };
  expect(() => requireScene(sceneWith({ data }))).toThrow('/meshes/cube/data: the mesh has the vertex 8 in triangle');
  expect(() => requireScene(sceneWith({ data: 5 } as unknown as MeshSource))).toThrow('no content');
  expect(() => requireScene(sceneWith({ data: cubeMesh(), file: '/cube.ply' }))).toThrow('/meshes/cube/file');
  expect(() => requireScene({ ...sceneWith({ data: cubeMesh() }), meshes: [cubeMesh()] })).toThrow('/meshes');
});

test('triangles stay while the shape moves', () => {
  const track = { target: '/shapes/cube/translation/1', interpolation: 'linear', repeat: 'once', keys: [{ time: 0, value: 0 }, { time: 1, value: 4 }] } as const; // biome-ignore format: one thing
  const scene = requireScene(sceneWith({ data: cubeMesh() }, { animation: [track] }));
  const now = sceneAt(scene, 0.5);
  expect(now.shapes.cube).toMatchObject({ translation: [0, 2, 0] });
  expect(now.meshes).toBe(scene.meshes);
  expect(requireScene(now).meshes!.cube!.data).toBe(scene.meshes!.cube!.data);
});

test('a scene of a program may say its sky as files do, or nothing of it', () => {
  const { sky: _, meshes: __, shapes, ...bare } = goodScene();
  const scene = { ...bare, shapes: { ball: shapes.ball } };
  expect(requireScene(scene).sky).toEqual({ horizon: [0, 0, 0], zenith: [0, 0, 0] });
  const color = [0.1, 0.2, 0.3];
  expect(requireScene({ ...scene, sky: color }).sky).toEqual({ horizon: color, zenith: color });
});
