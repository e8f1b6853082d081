import type { Page } from '@playwright/test';
import { IDENTITY, transformPoint } from '../../packages/renderer/src/scene/affine.ts';
import type { Mesh } from '../../packages/renderer/src/scene/mesh.ts';
import { meshMatrices } from '../../packages/renderer/src/scene/placed.ts';
import type {
  Camera,
  Light,
  Material,
  MeshShape,
  Quad,
  Scene,
  Shape,
  Vec3,
} from '../../packages/renderer/src/scene/scene.ts';
import { dot, length, normalize, scale, subtract } from '../../packages/renderer/src/scene/vec3.ts';
import { polygonIrradiance } from '../fixtures/lights/closed-forms.ts';
import { meshLamp, unevenSquare } from '../fixtures/lights/mesh-cases.ts';
import { triangleMesh } from '../fixtures/meshes/solids.ts';
import { between, inCube, seededRandom } from '../fixtures/random.ts';
import { testMaterial, testScene } from '../fixtures/scenes.ts';
import { blocksOfBatches, type Cut, type Film, WHOLE } from '../reference/blocks.ts';
import { pathFilms } from './films.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/** Light by meshes and by many lights at once, in whole pictures. */
const SEED = 300;
const BATCHES = 16;
const seeds = `seeds ${SEED} to ${SEED + BATCHES - 1}`;

const floor: Quad = { type: 'quad', corner: [-50, 0, 50], u: [100, 0, 0], v: [0, 0, -100], material: 'white' };
const materials = { white: testMaterial(), glow: testMaterial({ baseColor: [0, 0, 0], emission: [9, 6, 3] }) };
const DIRECT = { integrator: 'path', maxReflections: 0, lightSamples: 1, maxDepth: 2, exposure: 0, toneMapping: 'none' } as const; // biome-ignore format: settings

/** From low above the floor; all pixels within a millimetre. */
const lookingAt = ([x, y, z]: Vec3): Camera => ({
  eye: [x + 0.3, y + 0.6, z - 0.2],
  target: [x, y, z],
  up: [0.1, 0.2, 1],
  verticalFov: 0.05,
});

const films = (harness: Page, backend: Backend, scene: Scene, side: number, samples: number) =>
  pathFilms(harness, backend, scene, { width: side, height: side, samples, batches: BATCHES, seed: SEED });

/** Red of the whole picture, and its standard error. */
async function red(harness: Page, backend: Backend, scene: Scene, samples: number) {
  const { mean, variance } = blocksOfBatches(await films(harness, backend, scene, 16, samples), WHOLE);
  return { mean: mean[0]!, error: Math.sqrt(variance[0]!) };
}

const QUARTERS: Cut = { columns: 4, rows: 4 };
/** z of each block and channel. */
function differences(ours: readonly Film[], others: readonly Film[]): number[] {
  const [a, b] = [blocksOfBatches(ours, QUARTERS), blocksOfBatches(others, QUARTERS)];
  return Array.from(a.mean, (mean, k) => (mean - b.mean[k]!) / Math.sqrt(a.variance[k]! + b.variance[k]!));
}

/** A lamp in front of a wall, over a floor with a ball on it: there is light everywhere. */
const roomWith = (lamp: Shape, mesh?: Mesh): Scene =>
  testScene(
    {
      floor,
      wall: { type: 'quad', corner: [-50, 0, -2], u: [100, 0, 0], v: [0, 100, 0], material: 'white' },
      lamp,
      ball: { type: 'sphere', center: [0.6, 0.5, 0], radius: 0.5, material: 'white' },
    },
    {},
    {
      materials,
      camera: { eye: [0, 1.5, 4], target: [0, 1.2, 0], up: [0, 1, 0], verticalFov: 50 },
      render: { ...DIRECT, maxDepth: 4 },
      ...(mesh && { meshes: { lamp: { data: mesh } } }),
    },
  );

/** Linear greys and alphas of 4 × 4 texels; most of them are dark. */
const FIELDS = { greys: [0, 0, 255, 0, 0, 60, 0, 0, 0, 0, 0, 200, 120, 0, 0, 0], alphas: [255, 0, 255, 255, 128, 90, 255, 0, 255, 255, 60, 220, 255, 128, 0, 255] }; // biome-ignore format: rows of four
const linear = (byte: number): number =>
  byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;

/** A square meter whose second coordinates run over it: of its picture, turned by 90° and moved by a texel, one and a half are on it. */
const fieldMesh = (): Mesh => {
  const square = unevenSquare(12);
  const at = (i: number) => square.positions[3 * (i >> 1) + (i % 2)]!;
  const uv = Float32Array.from({ length: (2 * square.positions.length) / 3 }, (_, i) => at(i));
  return { ...square, uvs: [new Float32Array(uv.length), uv] };
};
const use = { texture: 'fields', uvSet: 1, offset: [0.25, 1], rotation: 90, scale: [1, 1.5] } as const;

/** What of the lamp there is at a place of the square, and what of that shines. */
const fieldAt = (x: number, y: number) => {
  const wrap = (u: number) => u - Math.floor(u);
  const texel = 4 * Math.floor(4 * wrap(1 - x)) + Math.floor(4 * wrap(0.25 + 1.5 * y));
  return { light: linear(FIELDS.greys[texel]!), alpha: FIELDS.alphas[texel]! / 255 };
};

const fieldScene = (material: Partial<Material>, at: Vec3): Scene => ({
  ...testScene(
    { floor, lamp: meshLamp({ translation: [-0.5, 1.5, 0.5], rotation: [-90, 0, 0] }) },
    {},
    {
      camera: lookingAt(at),
      materials: { ...materials, glow: testMaterial({ baseColor: [0, 0, 0], ...material }) },
      render: DIRECT,
      meshes: { lamp: { data: fieldMesh() } } as unknown as NonNullable<Scene['meshes']>,
    },
  ),
  images: { fields: { data: { width: 4, height: 4, rgba: Uint8Array.from(FIELDS.greys.flatMap((grey, k) => [grey, grey, grey, FIELDS.alphas[k]!])) } } }, // biome-ignore format: an image
  textures: { fields: { image: 'fields', filter: 'nearest' } },
});

/** Radiance of the white floor below fields of 1/24 m, each as bright as its middle: texels end where they do. */
function underFields(at: Vec3, share: (alpha: number) => number): number {
  const side = 24;
  let sum = 0;
  for (let j = 0; j < side; j++)
    for (let i = 0; i < side; i++) {
      const { light, alpha } = fieldAt((i + 0.5) / side, (j + 0.5) / side);
      if (light * share(alpha) === 0) continue;
      // The lamp's y runs to −z.
      const corner = (x: number, y: number): Vec3 => subtract([-0.5 + (i + x) / side, 1.5, 0.5 - (j + y) / side], at);
      const irradiance = polygonIrradiance([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)], [0, 1, 0]);
      sum += (light * share(alpha) * Math.abs(irradiance)) / Math.PI;
    }
  return sum;
}

for (const backend of backends) {
  test(`${backend}: a lamp that a texture varies, with holes or without, gives Lambert's formula for its fields, with less noise than by chance (${seeds})`, async ({
    harness,
  }) => {
    const at: Vec3 = [0.2, 0, 0.1];
    const lamp = { emission: [1, 1, 1], emissionTexture: use } as const;
    const holes = { baseColorTexture: use };
    // Each kind of hole on one backend.
    const withHoles: readonly [Partial<Material>, (alpha: number) => number] =
      backend === 'webgpu'
        ? [{ ...lamp, ...holes, alphaMode: 'mask', alphaCutoff: 0.6 }, (alpha) => (alpha >= 0.6 ? 1 : 0)]
        : [{ ...lamp, ...holes, alphaMode: 'blend', opacity: 0.7 }, (alpha) => 0.7 * alpha];
    const cases = [[lamp, () => 1], withHoles] as const;
    let plain = 0;
    for (const [material, share] of cases) {
      const exact = underFields(at, share);
      const { mean, error } = await red(harness, backend, fieldScene(material, at), 8);
      plain ||= error;
      expect.soft(error / exact, 'noise').toBeLessThan(0.004);
      expect
        .soft(Math.abs(mean - exact), `${mean} for ${exact}, in standard errors of ${error}`)
        .toBeLessThan(3.5 * error);
    }
    if (backend === 'webgpu') return;
    // Unlit surfaces shine alike, and only rays find them.
    const found = await red(
      harness,
      backend,
      fieldScene({ unlit: true, baseColor: [1, 1, 1], baseColorTexture: use }, at),
      8,
    );
    expect(Math.abs(found.mean - underFields(at, () => 1))).toBeLessThan(3.5 * found.error);
    expect((found.error / plain) ** 2, 'variance by chance').toBeGreaterThan(10);
  });

  test(`${backend}: a quad that shines is the same as a mesh of 2 triangles, and of 2048 (${seeds})`, async ({
    harness,
  }) => {
    const quad: Shape = { type: 'quad', corner: [-0.5, 2, 0.5], u: [1, 0, 0], v: [0, 0, -1], material: 'glow' };
    const placed = meshLamp({ translation: [-0.5, 2, 0.5], rotation: [-90, 0, 0] });
    const asQuad = await films(harness, backend, roomWith(quad), 32, 8);
    for (const side of [1, 32]) {
      const asMesh = await films(harness, backend, roomWith(placed, unevenSquare(side)), 32, 8);
      const z = differences(asMesh, asQuad);
      const what = `${2 * side ** 2} triangles`;
      expect.soft(Math.sqrt(z.reduce((sum, x) => sum + x * x, 0) / z.length), `${what}: rms of z`).toBeLessThan(1.35);
      expect.soft(Math.max(...z.map(Math.abs)), `${what}: largest z`).toBeLessThan(5);
    }
  });

  test(`${backend}: instances that shine, one stretched and one mirrored, within 0.3 % of Lambert's formula (${seeds})`, async ({
    harness,
  }) => {
    const shapes: Record<string, MeshShape> = {
      plain: meshLamp({ translation: [-2, 1.5, 0], rotation: [80, 0, 20] }),
      stretched: meshLamp({ translation: [0, 2, -1], rotation: [70, 30, 0], scale: [2, 0.2, 1] }),
      mirrored: meshLamp({ translation: [2, 1.8, 0.3], rotation: [100, 10, 0], scale: [-1, 1.5, 1] }),
    };
    const at: Vec3 = [0.2, 0, 0.1];
    const scene = testScene({ floor, ...shapes }, {}, { camera: lookingAt(at), materials, render: DIRECT, meshes: { lamp: { data: triangleMesh() } } }); // biome-ignore format: a scene
    const corners: readonly Vec3[] = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]; // biome-ignore format: a triangle
    const irradiance = Object.values(shapes).reduce((sum, shape) => {
      const placement = meshMatrices(shape, IDENTITY);
      const seen = corners.map((corner) => subtract(transformPoint(placement, 0, corner), at));
      return sum + polygonIrradiance(seen, [0, 1, 0]);
    }, 0);
    const exact = (9 * irradiance) / Math.PI;
    const { mean, error } = await red(harness, backend, scene, 16);
    expect(error / exact, 'noise').toBeLessThan(0.001);
    expect(Math.abs(mean / exact - 1)).toBeLessThan(0.003);
  });

  test(`${backend}: 400 point and spot lights, and a sun, give what they give one by one (${seeds})`, async ({
    harness,
  }) => {
    const random = seededRandom(SEED);
    const at: Vec3 = [0.3, 0, -0.2];
    const lights: Record<string, Light> = {};
    let exact = 0;
    for (let k = 0; k < 400; k++) {
      const [x, , z] = inCube(random, 5);
      const position: Vec3 = [x, between(random, 0.7, 4), z];
      const intensity = 10 ** between(random, -1, 1);
      const toLight = subtract(position, at);
      const irradiance = (intensity * toLight[1]) / length(toLight) ** 3;
      if (k % 2 === 0) {
        lights[`light ${k}`] = { type: 'point', position, intensity, color: [1, 1, 1] };
        exact += irradiance / Math.PI;
        continue;
      }
      const direction = normalize([between(random, -0.7, 0.7), -1, between(random, -0.7, 0.7)]);
      lights[`light ${k}`] = { type: 'spot', position, direction, intensity, color: [1, 1, 1], innerAngle: 20, outerAngle: 50 }; // biome-ignore format: a light
      const cosine = -dot(normalize(toLight), direction);
      const [inner, outer] = [20, 50].map((degrees) => Math.cos((degrees * Math.PI) / 180)) as [number, number];
      exact += (irradiance * Math.min(Math.max((cosine - outer) / (inner - outer), 0), 1) ** 2) / Math.PI;
    }
    const direction = normalize([0.3, -1, 0.2]);
    lights.sun = { type: 'directional', direction: scale(direction, 2), irradiance: 2, color: [1, 1, 1], angle: 0 };
    exact += (-2 * direction[1]) / Math.PI;
    const scene = testScene({ floor }, lights, { camera: lookingAt(at), materials, render: DIRECT });
    const { mean, error } = await red(harness, backend, scene, 64);
    expect(error / exact, 'noise').toBeLessThan(0.005);
    expect(Math.abs(mean - exact)).toBeLessThan(3.5 * error);
  });
}
