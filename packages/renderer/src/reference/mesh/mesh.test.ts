import { describe, expect, test } from 'vitest';
import { displacedSphere, heightField, triangleSoup } from '../../../../../tests/fixtures/meshes/landscapes.ts';
import { cubeMesh, triangleMesh } from '../../../../../tests/fixtures/meshes/solids.ts';
import { between, inCube, randomDirection, seededRandom } from '../../../../../tests/fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../../../tests/fixtures/scenes.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { MeshShape, Scene, Vec3 } from '../../scene/scene.ts';
import { addScaled, dot, length, normalize, subtract } from '../../scene/vec3.ts';
import { closestHit, occluded, surfaceAt } from '../cast.ts';
import { traceClassic } from '../classic.ts';
import { prepareFirstHit, traceFirstHit } from '../first-hit.ts';
import { prepareScene } from '../prepare.ts';
import { cameraRay, rayLeaving } from '../ray.ts';
import { closestTriangle, type MeshHit, treeOf } from './tree.ts';
import { intersectTriangle, meshRay } from './triangle.ts';

const placed = (part: Partial<MeshShape> = {}): MeshShape => ({
  type: 'mesh',
  mesh: 'it',
  material: 'white',
  translation: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
  ...part,
});
const sceneOf = (mesh: Mesh, part: Partial<MeshShape> = {}, rest: Partial<Scene> = {}): Scene =>
  testScene(
    { it: placed(part) },
    { lamp: testLight({ center: [2, 4, 3] }) },
    { meshes: { it: { data: mesh } }, ...rest },
  );

function bruteForce(mesh: Mesh, origin: Vec3, direction: Vec3): { t: number; count: number } {
  const ray = meshRay(origin, direction);
  let [t, count] = [Infinity, 0];
  for (let k = 0; k < mesh.indices.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => 3 * mesh.indices[k + corner]!) as [number, number, number];
    const hit = intersectTriangle(ray, mesh.positions, a, b, c);
    if (!hit || hit.t <= 0) continue;
    count++;
    t = Math.min(t, hit.t);
  }
  return { t, count };
}

test('a mesh with instances is met where each of them stands, and seen as one shape', () => {
  const mesh = cubeMesh();
  const at = [
    [-3, 0, 0],
    [4, 1, 0],
  ] as const;
  const instances = Float32Array.from(at.flatMap(([x, y, z]) => [1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z]));
  const scene = sceneOf(mesh, { scale: [2, 2, 2], instances });
  const prepared = prepareScene(scene);
  expect(prepared.meshes).toHaveLength(2);
  const inMiddle = closestHit(prepareScene(sceneOf(mesh, { scale: [2, 2, 2] })), cameraRay([0, 0, 9], [0, 0, -1])).t;
  expect(inMiddle).toBeLessThan(9);
  for (const [x, y] of at) expect(closestHit(prepared, cameraRay([x, y, 9], [0, 0, -1])).t).toBeCloseTo(inMiddle, 12);
  expect(closestHit(prepared, cameraRay([0, 0, 9], [0, 0, -1])).t).toBe(Infinity);
  const size = { width: 32, height: 32, integrator: 'path', seed: 1 } as const;
  const tracer = prepareFirstHit({ ...scene, camera: { ...scene.camera, eye: [0, 0, 12], target: [0, 0, 0] } }, size);
  const seen = Array.from({ length: 32 }, (_, x) => traceFirstHit(tracer, x, 16, 0).hit?.id);
  expect(new Set(seen)).toEqual(new Set([undefined, 1]));
});

test.each([
  ['soup', triangleSoup(500), 3000],
  ['a dented ball', displacedSphere({ triangles: 800 }), 3000],
  ['hills', heightField({ triangles: 700 }), 3000],
  ['one triangle', triangleMesh(), 500],
])('the tree finds what looking at all triangles finds: %s (seed 51)', (_, mesh, rays) => {
  const random = seededRandom(51);
  let met = 0;
  for (let k = 0; k < rays; k++) {
    const [origin, direction] = [inCube(random, 1.5), randomDirection(random)];
    const found = closestTriangle(mesh, treeOf(mesh), meshRay(origin, direction), 0, Infinity, -1);
    expect(found?.t ?? Infinity).toBe(bruteForce(mesh, origin, direction).t);
    if (found) met++;
  }
  expect(met).toBeGreaterThan(5);
});

test('no gaps: rays at vertices and edges of a closed mesh meet it, from inside of it too (seed 52)', () => {
  const mesh = displacedSphere({ triangles: 400, relief: 0.05 });
  const random = seededRandom(52);
  const vertex = (k: number): Vec3 => [...mesh.positions.subarray(3 * k, 3 * k + 3)] as unknown as Vec3;
  for (let k = 0; k < 5000; k++) {
    const at = 3 * Math.floor((random() * mesh.indices.length) / 3);
    const [a, b] = [vertex(mesh.indices[at]!), vertex(mesh.indices[at + 1]!)];
    const target = addScaled(a, subtract(b, a), k % 2 ? 0 : random());
    // From outside only where the surface looks to us: a ray at the rim may pass by rounding.
    const outside = addScaled(target, randomDirection(random), 3);
    const inside = k % 4 < 2 || dot(target, subtract(outside, target)) < 0.5;
    const from: Vec3 = inside ? [0.01, 0.02, -0.01] : outside;
    const ray = meshRay(from, subtract(target, from));
    expect(closestTriangle(mesh, treeOf(mesh), ray, 0, Infinity, -1)).not.toBeNull();
  }
});

test('weights say where the hit is, and t counts in lengths of the direction', () => {
  const mesh = triangleMesh();
  const hit = closestTriangle(mesh, treeOf(mesh), meshRay([0.5, 0.25, 4], [0, 0, -2]), 0, Infinity, -1)!;
  expect(hit).toEqual({ t: 2, weights: [0.25, 0.5, 0.25], triangle: 0 } satisfies MeshHit);
  expect(closestTriangle(mesh, treeOf(mesh), meshRay([0.5, 0.25, 4], [0, 0, -2]), 0, 2, -1)).toBeNull();
  expect(closestTriangle(mesh, treeOf(mesh), meshRay([0.5, 0.25, 4], [0, 0, -2]), 2, 9, -1)).toBeNull();
  expect(closestTriangle(mesh, treeOf(mesh), meshRay([0.5, 0.25, 4], [0, 0, -2]), 0, 9, 0)).toBeNull();
});

describe('a cube of triangles is the box', () => {
  const box = { type: 'box', center: [0.2, 0.4, -0.1], size: [1, 0.6, 0.8], rotation: [20, 35, -15] } as const;
  const cube = placed({ translation: box.center, rotation: box.rotation, scale: box.size });
  const materials = { white: testMaterial({ reflectivity: 0.3, specular: 0.4, roughness: 0.4 }) };
  const ground = { type: 'quad', corner: [-5, -0.5, -5], u: [0, 0, 10], v: [10, 0, 0], material: 'white' } as const;
  const lights = { lamp: testLight({ center: [2, 4, 3], radius: 0.5, radiance: 90, visible: true }) };
  const picture = (it: Scene['shapes'][string]) =>
    traceClassic(testScene({ it, ground }, lights, { materials, meshes: { it: { data: cubeMesh() } } }), {
      width: 48,
      height: 36,
      maxReflections: 4,
      lightSamples: 9,
    });
  test('in the picture, with mirrors and shadows', () => {
    const [ours, theirs] = [picture(cube), picture({ ...box, material: 'white' })];
    const far = ours.reduce((count, x, k) => count + Number(Math.abs(x - theirs[k]!) > 1e-9), 0);
    expect(far).toBe(0);
    expect(Math.max(...ours)).toBeGreaterThan(0.1);
  });
  test('and when it is mirrored', () => {
    const mirrored = picture({ ...cube, scale: [-1, 0.6, 0.8] });
    const far = picture(cube).reduce((count, x, k) => count + Number(Math.abs(x - mirrored[k]!) > 1e-9), 0);
    expect(far).toBe(0);
  });
});

test('geometric normals look out of a closed mesh, however it is placed (seed 53)', () => {
  const random = seededRandom(53);
  const mesh = displacedSphere({ triangles: 200, relief: 0 });
  for (let k = 0; k < 300; k++) {
    const size = () => between(random, 0.5, 2) * (random() < 0.5 ? -1 : 1);
    const translation = inCube(random, 2);
    const scene = prepareScene(sceneOf(mesh, { translation, rotation: inCube(random, 180), scale: [size(), size(), size()] })); // biome-ignore format: one thing
    const direction = randomDirection(random);
    const ray = cameraRay(addScaled(translation, direction, -5), direction);
    const { t, shape, spot } = closestHit(scene, ray);
    const hit = surfaceAt(shape!, ray, t, spot);
    expect(dot(hit.outwardNormal, direction)).toBeLessThan(0);
    expect(length(hit.outwardNormal)).toBeCloseTo(1, 12);
    expect(dot(hit.shadingNormal, hit.geometricNormal)).toBeGreaterThan(0.9);
    // The other way it lies behind; and from where the ray met it nothing of it is met again at once.
    const away = rayLeaving(hit, [-direction[0], -direction[1], -direction[2]], ray.eye);
    expect(closestHit(scene, away).t).toBe(Infinity);
    expect(occluded(scene, ray, t * (1 - 1e-9))).toBe(false);
    expect(occluded(scene, ray, t * (1 + 1e-9))).toBe(true);
  }
});

test('a fine ball with normals is lit as the sphere is', () => {
  const camera = { eye: [0, 1, 5], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 35 } as const;
  const settings = { width: 40, height: 40, lightSamples: 1 };
  const ball = traceClassic(sceneOf(displacedSphere({ triangles: 20_000, relief: 0 }), {}, { camera }), settings);
  const sphere = testScene({ it: { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' } }, { lamp: testLight({ center: [2, 4, 3] }) }, { camera }); // biome-ignore format: one thing
  const theirs = traceClassic(sphere, settings);
  const most = Math.max(...theirs.filter((_, k) => k % 4 < 3));
  const off = ball.filter((x, k) => k % 4 < 3 && Math.abs(x - theirs[k]!) > 0.02 * most).length;
  expect(off).toBeLessThan(40 * 3); // some pixels of the rim
});

test('colours of vertices multiply, and what is seen first tells both normals', () => {
  const mesh: Mesh = {
    ...triangleMesh(),
    colors: Float32Array.of(1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1),
    normals: Float32Array.of(0, 0, 1, ...normalize([1, 0, 1]), ...normalize([0, 1, 1])),
  };
  const camera = { eye: [0.25, 0.5, 3], target: [0.25, 0.5, 0], up: [0, 1, 0], verticalFov: 10 } as const;
  const materials = { white: testMaterial({ baseColor: [0.8, 0.4, 0.2] }) };
  const tracer = prepareFirstHit(sceneOf(mesh, {}, { camera, materials }), { width: 1, height: 1, integrator: 'classic', seed: 0 }); // biome-ignore format: one thing
  const { hit } = traceFirstHit(tracer, 0, 0, 0);
  const expected = { albedo: [0.8 * 0.25, 0.4 * 0.25, 0.2 * 0.5], geometricNormal: [0, 0, 1], id: 1 };
  hit!.albedo.forEach((x, c) => {
    expect(x).toBeCloseTo(expected.albedo[c]!, 9);
  });
  expect(hit).toMatchObject({ geometricNormal: expected.geometricNormal, id: 1 });
  const blend = normalize([0.25 * Math.SQRT1_2, 0.5 * Math.SQRT1_2, 0.25 + 0.75 * Math.SQRT1_2]);
  hit!.normal.forEach((x, c) => {
    expect(x).toBeCloseTo(blend[c]!, 7);
  });
});

test('a mesh that has not been loaded is no picture without it', () => {
  const scene = testScene({ it: placed() }, {}, { meshes: { it: { file: 'it.ply' } } });
  expect(() => prepareScene(scene)).toThrow('The mesh "it" has not been loaded.');
});
