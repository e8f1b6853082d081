import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { parseScene } from '../../scene-file/parse-scene.ts';
import { isParsedScene } from '../../scene-file/trusted-scenes.ts';
import { sceneAt } from '../index.ts';
import type { Box, Plane, Scene, Shape, Sphere, SphereLight, Vec3 } from '../scene.ts';
import { cross, dot, length, normalize, subtract } from '../vec3.ts';
import { builtInScenes } from './index.ts';

type Matrix = readonly [Vec3, Vec3, Vec3];

/** The box's three axes in the world: the columns of Rz·Ry·Rx. */
function axes({ rotation }: Box): Matrix {
  const [x, y, z] = rotation.map((degrees) => (degrees * Math.PI) / 180) as [number, number, number];
  const [cx, sx, cy, sy, cz, sz] = [Math.cos(x), Math.sin(x), Math.cos(y), Math.sin(y), Math.cos(z), Math.sin(z)];
  return [
    [cz * cy, sz * cy, -sy],
    [cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx],
    [cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx],
  ];
}

/** Half the width of the solid along a unit direction. */
function reach(shape: Sphere | Box, direction: Vec3): number {
  if (shape.type === 'sphere') return shape.radius;
  return axes(shape).reduce((sum, axis, i) => sum + (Math.abs(dot(axis, direction)) * shape.size[i]!) / 2, 0);
}

/** The widest gap between two solids along the directions that can part them; negative when they intersect. */
function gap(a: Sphere | Box, b: Sphere | Box): number {
  const between = subtract(b.center, a.center);
  const [axesA, axesB] = [a, b].map((shape) => (shape.type === 'box' ? axes(shape) : []));
  const edges = axesA!.flatMap((p) => axesB!.map((q) => cross(p, q))).filter((edge) => length(edge) > 1e-6);
  const nearest = [...corner(a, b), ...corner(b, a), between].filter((v) => length(v) > 1e-9);
  const directions = [...axesA!, ...axesB!, ...edges, ...nearest].map(normalize);
  return Math.max(...directions.map((d) => Math.abs(dot(between, d)) - reach(a, d) - reach(b, d)));
}

/** From the point of a box that is nearest to a ball's centre, to that centre. */
function corner(a: Sphere | Box, b: Sphere | Box): Vec3[] {
  if (a.type !== 'box' || b.type !== 'sphere') return [];
  const out = subtract(b.center, a.center);
  const rest = axes(a).map((axis, i) => {
    const along = dot(out, axis);
    const beyond = along - Math.max(-a.size[i]! / 2, Math.min(a.size[i]! / 2, along));
    return axis.map((x) => x * beyond) as unknown as Vec3;
  });
  return [[0, 1, 2].map((c) => rest.reduce((sum, v) => sum + v[c]!, 0)) as unknown as Vec3];
}

const isSolid = (shape: Shape): shape is Sphere | Box => shape.type === 'sphere' || shape.type === 'box';
const isPlane = (shape: Shape): shape is Plane => shape.type === 'plane';
const heightOver = (plane: Plane, point: Vec3) => dot(subtract(point, plane.point), normalize(plane.normal));

/** The smallest gap between any two things of the scene, with their names. Lamps are solids here. */
function tightest(scene: Scene): [number, string] {
  const lamps = Object.entries(scene.lights).map(
    ([name, light]) => [name, { ...(light as SphereLight), material: '' }] as const,
  );
  const solids = [...Object.entries(scene.shapes), ...lamps].filter((entry): entry is [string, Sphere | Box] =>
    isSolid(entry[1]),
  );
  let least: [number, string] = [Number.POSITIVE_INFINITY, ''];
  const keep = (space: number, names: string) => {
    if (space < least[0]) least = [space, names];
  };
  solids.forEach(([name, solid], i) => {
    for (const [other, second] of solids.slice(i + 1)) keep(gap(solid, second), `${name} and ${other}`);
    for (const [other, plane] of Object.entries(scene.shapes)) {
      if (isPlane(plane))
        keep(heightOver(plane, solid.center) - reach(solid, normalize(plane.normal)), `${name} and ${other}`);
    }
  });
  return least;
}

const longest = ({ animation }: Scene) =>
  Math.max(...animation.map(({ keys, repeat }) => keys.at(-1)!.time * (repeat === 'ping-pong' ? 2 : 1)));

describe.each(builtInScenes)('$name', ({ scene }) => {
  test('nothing ever intersects, over several rounds', () => {
    const end = 3 * longest(scene);
    for (let time = 0; time < end; time += end / 1500) {
      const [space, names] = tightest(sceneAt(scene, time));
      // Things that stand on one another touch.
      if (space < -1e-9) throw new Error(`${names} intersect by ${-space} m at ${time} s`);
    }
  });

  test('the camera stays outside of everything and on the inner side of every plane', () => {
    for (let time = 0; time < longest(scene); time += 0.1) {
      const { camera, shapes } = sceneAt(scene, time);
      for (const shape of Object.values(shapes)) {
        if (isPlane(shape)) expect(heightOver(shape, camera.eye)).toBeGreaterThan(0.01);
        else if (isSolid(shape)) {
          const eye: Sphere = { type: 'sphere', center: camera.eye, radius: 0.01, material: '' };
          expect(gap(eye, shape)).toBeGreaterThan(0);
        }
      }
    }
  });

  test('moves, and every loop closes where it began', () => {
    expect(scene.animation.length).toBeGreaterThan(2);
    for (const { target, repeat, keys } of scene.animation) {
      if (repeat === 'ping-pong') continue;
      const [first, last] = [keys[0]!.value, keys.at(-1)!.value];
      if (/rotation/.test(target)) {
        const turn = [last].flat().map((degrees, i) => degrees - [first].flat()[i]!);
        for (const degrees of turn) expect(degrees % 360).toBe(0);
      } else expect(last).toEqual(first);
    }
  });
});

const count = (scene: Scene, type: Shape['type']) => Object.values(scene.shapes).filter((s) => s.type === type).length;

test('the scenes are what their names say', () => {
  expect(builtInScenes.map(({ id }) => id)).toEqual(['cube-room', 'mirror-blocks', 'moving-shadows', 'materials']);
  const [room, blocks, shadows] = builtInScenes.map(({ scene }) => scene);
  expect([count(room!, 'plane'), count(room!, 'box'), count(room!, 'sphere')]).toEqual([6, 2, 4]);
  expect(Object.keys(room!.lights)).toHaveLength(1);
  expect(count(blocks!, 'box')).toBeGreaterThanOrEqual(4);
  expect(count(blocks!, 'sphere')).toBeGreaterThanOrEqual(3);
  expect(Object.keys(shadows!.lights)).toHaveLength(2);
  expect(builtInScenes.map(({ scene }) => scene.render.integrator)).toEqual(['classic', 'classic', 'classic', 'path']);
  expect([room!, blocks!, shadows!].map(({ render }) => render.lightSamples)).toEqual([9, 9, 16]);
});

test.each(builtInScenes)('$id is what the reader makes of its file now (else: npm run scenes)', ({ id, scene }) => {
  const read = parseScene(readFileSync(new URL(`${id}.scene.json`, import.meta.url), 'utf8'));
  expect(read.ok && read.scene).toStrictEqual(scene);
  expect(JSON.stringify(read.ok && read.scene), 'in the same order').toBe(JSON.stringify(scene));
  expect(isParsedScene(scene)).toBe(true);
  expect(Object.isFrozen(Object.values(scene.materials)[0]!.baseColor)).toBe(true);
  expect(Object.getPrototypeOf(scene.shapes)).toBeNull();
});
