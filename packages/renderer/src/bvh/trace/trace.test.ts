import { describe, expect, test } from 'vitest';
import { awkwardMeshes, bumpySphere, landscape, meshOf, shuffled, soup } from '../../../../../tests/fixtures/meshes.ts';
import { between, pick, type Random, randomDirection, seededRandom } from '../../../../../tests/fixtures/random.ts';
import { buildBvh } from '../build-bvh.ts';
import type { TriangleMesh } from '../bvh.ts';
import { bvhSource, type NodeSource } from './node-source.ts';
import { anyHit, closestByBruteForce, closestHit, tryTriangle } from './trace.ts';
import { hitTriangle, type Ray, shearRay } from './watertight.ts';

type Point = [number, number, number];

function sourcesOf(mesh: TriangleMesh): Readonly<Record<string, NodeSource>> {
  return {
    good: bvhSource(buildBvh(mesh, { maxLeafSize: 3 })),
    'larger leaves': bvhSource(buildBvh(mesh, { leafSize: 8 })),
  };
}

/** Somewhere on the mesh: a corner, the middle of an edge, or anywhere in a triangle. */
function pointOn(random: Random, { positions, indices }: TriangleMesh): Point {
  const t = Math.floor(random() * (indices.length / 3));
  const corner = (k: number) => [...positions.subarray(3 * indices[3 * t + k]!, 3 * indices[3 * t + k]! + 3)];
  const [u, v] = pick(random, [
    [0, 0],
    [0.5, 0],
    [0.5, 0.5],
    [random() / 2, random() / 2],
  ] as const);
  return corner(0).map((a, axis) => (1 - u - v) * a + u * corner(1)[axis]! + v * corner(2)[axis]!) as Point;
}

const axisDirection = (random: Random): Point => {
  const direction: Point = [0, 0, 0];
  direction[Math.floor(random() * 3)] = pick(random, [-1, 1, 0.125]);
  return direction;
};

/** Aimed at the mesh or past it, along axes, in planes of boxes, from corners, faces and from far away. */
function randomRay(random: Random, mesh: TriangleMesh, size: number): Ray {
  const aim = pointOn(random, mesh);
  const direction = random() < 0.4 ? axisDirection(random) : ([...randomDirection(random)] as Point);
  const back = pick(random, [0, 1, size, 1e3 * size]);
  const aside = pick(random, [0, 0, 0, size / 7]);
  const origin = aim.map((x, axis) => x - back * direction[axis]! + aside * between(random, -1, 1)) as Point;
  const tMin = pick(random, [0, 0, -size, 1e-6 * size]);
  return { origin, direction, tMin, tMax: pick(random, [Infinity, Infinity, size, 0.5]) };
}

const sizeOf = (mesh: TriangleMesh) => mesh.positions.reduce((most, x) => Math.max(most, Math.abs(x)), 1e-30);

function expectLikeBruteForce(mesh: TriangleMesh, sources: Readonly<Record<string, NodeSource>>, ray: Ray): boolean {
  const expected = closestByBruteForce(mesh, ray);
  for (const [name, source] of Object.entries(sources)) {
    const found = closestHit(source, mesh, ray);
    const any = anyHit(source, mesh, ray);
    if (found?.t !== expected?.t || found?.triangle !== expected?.triangle || any !== (expected !== null)) {
      expect.fail(`${name}: ${JSON.stringify({ ray, found, any, expected })}`);
    }
  }
  return expected !== null;
}

describe('every tree finds what brute force finds', () => {
  const random = seededRandom(91);
  const meshes = Object.entries({
    ...awkwardMeshes(random),
    soup: soup(random, 400),
    landscape: landscape(random, 12),
    sphere: shuffled(random, bumpySphere(random, 10)),
  }).filter(([, mesh]) => mesh.indices.length > 0);

  test.each(meshes)('%s (seed 92)', (_, mesh) => {
    const rays = seededRandom(92);
    const sources = sourcesOf(mesh);
    const size = sizeOf(mesh);
    for (let k = 0; k < 400; k++) expectLikeBruteForce(mesh, sources, randomRay(rays, mesh, size));
  });
});

test('no triangle, no hit', () => {
  const mesh = meshOf([]);
  for (const source of Object.values(sourcesOf(mesh))) {
    const ray: Ray = { origin: [0, 0, 0], direction: [0, 1, 0], tMin: 0, tMax: Infinity };
    expect(closestHit(source, mesh, ray)).toBeNull();
    expect(anyHit(source, mesh, ray)).toBe(false);
  }
});

test('a ray along an edge of the mesh, in the planes of boxes, from a corner', () => {
  const mesh = meshOf([0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1]);
  const sources = sourcesOf(mesh);
  const shoot = (origin: Point, direction: Point) => {
    const ray = { origin, direction, tMin: 0, tMax: Infinity };
    expectLikeBruteForce(mesh, sources, ray);
    return closestHit(sources.good!, mesh, ray)?.t;
  };
  expect(shoot([0, 2, 0], [0, -1, 0])).toBe(1);
  expect(shoot([0, 0.5, 0], [0, -1, 0])).toBe(0.5);
  expect(shoot([0.5, 0.5, 0.5], [0, -1, 0]), 'the diagonal').toBe(0.5);
  expect(shoot([0, 0, 0], [0, 1, 0]), 'on the surface').toBe(0);
  expect(shoot([-1, 0, 0], [1, 0, 0]), 'within the plane').toBeUndefined();
  expect(shoot([1, 2, 1], [0, -1, 0])).toBe(2);
});

test('closed surfaces have no gaps: from inside every ray hits, aimed at edges and corners too (seed 93)', () => {
  const random = seededRandom(93);
  const mesh = bumpySphere(random, 24);
  const source = bvhSource(buildBvh(mesh));
  for (let k = 0; k < 3000; k++) {
    const aim = pointOn(random, mesh);
    const origin = [0, 1, 2].map(() => between(random, -0.2, 0.2)) as Point;
    const direction = aim.map((x, axis) => x - origin[axis]!) as Point;
    const hit = closestHit(source, mesh, { origin, direction, tMin: 0, tMax: Infinity });
    if (hit === null || Math.abs(hit.t - 1) > 1e-9) expect.fail(`${origin} to ${aim}: ${hit?.t}`);
  }
});

test('weights give the point back; distance is in units of the direction (seed 94)', () => {
  const random = seededRandom(94);
  for (let k = 0; k < 2000; k++) {
    const corners = Array.from({ length: 9 }, () => between(random, -1, 1));
    const [a, b] = [random(), random()];
    const [u, v] = a + b < 1 ? [a, b] : [1 - a, 1 - b];
    const at = (axis: number) => (1 - u - v) * corners[axis]! + u * corners[3 + axis]! + v * corners[6 + axis]!;
    const origin: Point = [2, -3, 1.5];
    const t = between(random, 0.5, 4);
    const direction = origin.map((x, axis) => (at(axis) - x) / t) as Point;
    const hit = hitTriangle(shearRay({ origin, direction, tMin: 0, tMax: 9 }), corners);
    if (hit === null) continue; // seen from the edge
    expect(hit.t).toBeCloseTo(t, 6);
    const p = [0, 1, 2].map(
      (axis) => (1 - hit.u - hit.v) * corners[axis]! + hit.u * corners[3 + axis]! + hit.v * corners[6 + axis]!,
    );
    p.forEach((x, axis) => {
      expect(x).toBeCloseTo(at(axis), 6);
    });
  }
  const mesh = meshOf([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const ray = { origin: [0.2, 0.2, 4] as Point, direction: [0, 0, -2] as Point, tMin: 0, tMax: 2 };
  expect(tryTriangle(shearRay(ray), mesh, 0)?.t).toBe(2);
  expect(tryTriangle(shearRay({ ...ray, tMax: 1.999 }), mesh, 0)).toBeNull();
});
