import type { Page } from '@playwright/test';
import { evaluateBsdf } from '../../packages/renderer/src/reference/bsdf/bsdf.ts';
import { radianceOfMap } from '../../packages/renderer/src/reference/light/environment.ts';
import { type EnvironmentMap, environmentDirection } from '../../packages/renderer/src/scene/environment.ts';
import type { Camera, Color, Material, Quad, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { dot, normalize, subtract } from '../../packages/renderer/src/scene/vec3.ts';
import { whiteMetal } from '../fixtures/bsdf-cases.ts';
import { ENVIRONMENTS, mapOf } from '../fixtures/lights/environments.ts';
import { testMaterial, testScene } from '../fixtures/scenes.ts';
import { blocksOfBatches, WHOLE } from '../reference/blocks.ts';
import { pathFilms } from './films.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/**
 * Surfaces under a map of the sky, where the answer is a closed form or a sum over all directions: the path integrator's two ways to
 * find light, weighted against one another, must give the integral of each. Pixels all look at one point.
 */
const BATCHES = 8;
const SEED = 170;
const seeds = `seeds ${SEED} to ${SEED + BATCHES - 1}`;
const SIZE = { width: 16, height: 16, batches: BATCHES, seed: SEED };
const render = { maxReflections: 0, lightSamples: 1, maxDepth: 2, exposure: 0, toneMapping: 'none' } as const;

interface Case {
  readonly name: string;
  readonly map: EnvironmentMap;
  readonly rotation?: number;
  readonly material?: Partial<Material>;
  /** The quad's outward normal. */
  readonly normal: Vec3;
  /** From the quad to the eye. */
  readonly toEye: Vec3;
  readonly exact: Color;
  readonly samples: number;
}

/** Of a lobe max(d · axis, 0)² a surface that faces its axis gets 2π / (2 + 2), and one at a right angle to it π / 8. */
function lobe(axis: Vec3): EnvironmentMap {
  const [width, height] = [256, 128];
  return mapOf(width, height, (i, j) => {
    const l = Math.max(dot(environmentDirection((i + 0.5) / width, (j + 0.5) / height), axis), 0) ** 2;
    return [l, 2 * l, 0];
  });
}

/** Midpoints of a grid so fine that its error is far below that of the pictures. */
function overDirections(map: EnvironmentMap, rotation: number, f: (direction: Vec3) => number): Color {
  const [columns, rows] = [map.width * Math.ceil(400 / map.width), map.height * Math.ceil(400 / map.height)];
  const sum: [number, number, number] = [0, 0, 0];
  for (let j = 0; j < rows; j++)
    for (let i = 0; i < columns; i++) {
      const direction = environmentDirection((i + 0.5) / columns, (j + 0.5) / rows);
      const weight = f(direction);
      if (weight === 0) continue;
      const sine = Math.hypot(direction[0], direction[2]);
      radianceOfMap(map, direction, rotation).forEach((l, c) => {
        sum[c] = sum[c]! + l * weight * sine;
      });
    }
  const size = (2 * Math.PI ** 2) / (columns * rows);
  return [sum[0] * size, sum[1] * size, sum[2] * size];
}

const UP: Vec3 = [0, 1, 0];
const LOW: Vec3 = [0.3, 1, -0.2];
const tilted: Vec3 = [0.8, 0.6, 0];

function matte(name: string, map: EnvironmentMap, rotation: number): Case {
  const exact = overDirections(map, rotation, (d) => Math.max(d[1], 0) / Math.PI);
  return { name, map, rotation, normal: UP, toEye: LOW, exact, samples: 32 };
}

/** Rough metal, seen in the plane of X and Y: in its frame that is the plane of x and z. */
function metal(name: string, map: EnvironmentMap, rotation: number, alpha: number): Case {
  const local = ([x, y, z]: Vec3): Vec3 => [x, -z, y];
  const surface = whiteMetal(alpha);
  const exact = overDirections(map, rotation, (d) => evaluateBsdf(surface, local(tilted), local(d)).value[0]);
  const material = { type: 'conductor', baseColor: [1, 1, 1], roughness: Math.sqrt(alpha) } as const;
  return { name, map, rotation, material, normal: UP, toEye: tilted, exact, samples: 64 };
}

const east = lobe([1, 0, 0]);
const bright = ENVIRONMENTS['one bright texel']!;
const CASES: readonly Case[] = [
  { name: 'a white furnace', map: mapOf(3, 2, () => [1, 1, 1]), normal: UP, toEye: LOW, exact: [1, 1, 1], samples: 32 },
  { name: 'a lobe from the side', map: east, normal: UP, toEye: LOW, exact: [1 / 8, 1 / 4, 0], samples: 32 },
  { name: 'a lobe from ahead', map: east, normal: [1, 0, 0], toEye: [1, 0.3, 0.2], exact: [0.5, 1, 0], samples: 32 },
  {
    name: 'a lobe from +X that is turned by 90° and comes from −Z',
    map: east,
    rotation: 90,
    normal: [0, 0, -1],
    toEye: [0.2, 0.3, -1],
    exact: [0.5, 1, 0],
    samples: 32,
  },
  { name: 'a lobe from behind', map: east, normal: [-1, 0, 0], toEye: [-1, 0.2, 0.3], exact: [0, 0, 0], samples: 1 },
  matte('one bright texel', bright, 0),
  matte('many texels, turned', ENVIRONMENTS['sixteen by eight']!, -33),
  metal('rough metal under one bright texel', bright, 20, 0.25),
  metal('glossy metal under many texels', ENVIRONMENTS['seven by five']!, 130, 0.05),
];

async function measure(harness: Page, backend: Backend, one: Case) {
  const { map, rotation, material, normal, toEye, samples } = one;
  const along: Vec3 = normal[1] === 1 ? [0, 0, 1] : [0, 1, 0];
  const across = [
    along[1] * normal[2] - along[2] * normal[1],
    along[2] * normal[0] - along[0] * normal[2],
    along[0] * normal[1] - along[1] * normal[0],
  ] as const;
  const [u, v] = [across, along].map((side) => side.map((x) => 4 * x) as unknown as Vec3) as [Vec3, Vec3];
  const corner = subtract([0, 0, 0], [(u[0] + v[0]) / 2, (u[1] + v[1]) / 2, (u[2] + v[2]) / 2]);
  const floor: Quad = { type: 'quad', corner, u, v, material: 'white' };
  const camera: Camera = { eye: normalize(toEye), target: [0, 0, 0], up: along, verticalFov: 0.04 };
  const sky = { horizon: [0, 0, 0], zenith: [0, 0, 0], map, scale: 2, rotation } as const;
  const materials = { white: testMaterial(material) };
  const scene = testScene({ floor }, {}, { camera, sky, materials, render: { integrator: 'path', ...render } });
  const { mean, variance } = blocksOfBatches(await pathFilms(harness, backend, scene, { ...SIZE, samples }), WHOLE);
  return [0, 1, 2].map((c) => ({ mean: mean[c]! / 2, error: Math.sqrt(variance[c]!) / 2 }));
}

for (const backend of backends)
  test(`${backend}: surfaces under maps of the sky shine as they must, within 0.4 % (${seeds})`, async ({
    harness,
  }) => {
    for (const one of CASES)
      for (const [c, { mean, error }] of (await measure(harness, backend, one)).entries()) {
        const exact = one.exact[c]!;
        const what = `${one.name}, channel ${c}: ${mean} ± ${error}, not ${exact}`;
        expect.soft(error, `${what}: noise`).toBeLessThan(0.0013 * exact + 1e-7);
        expect.soft(Math.abs(mean - exact), what).toBeLessThan(0.004 * exact + 1e-7);
      }
  });
