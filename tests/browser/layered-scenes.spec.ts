import type { Page } from '@playwright/test';
import type { Material, Scene, Shape, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { testMaterial, testScene } from '../fixtures/scenes.ts';
import { blocksOfBatches, WHOLE } from '../reference/blocks.ts';
import { pathFilms } from './films.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/** Whole paths through glTF's layers, where the exact answer is known. */
const SIZE = { width: 16, height: 16, batches: 8 };
const SEED = 310;
const RENDER = {
  integrator: 'path',
  maxReflections: 0,
  lightSamples: 1,
  maxDepth: -1,
  exposure: 0,
  toneMapping: 'none',
} as const;

const ball = (x: number, y: number, material: string): Shape => ({
  type: 'sphere',
  center: [x, y, 0],
  radius: 0.9,
  material,
});
const plastic = (part: Partial<Material>) => testMaterial({ type: 'metallicRoughness', roughness: 0, ...part });
const sky = (radiance: number) => {
  const color: Vec3 = [radiance, radiance, radiance];
  return { horizon: color, zenith: color };
};
/** From the front; `height` metres of the plane z = 0 fill the picture. */
const camera = (height: number) => ({
  eye: [0, 0, 20] as Vec3,
  target: [0, 0, 0] as Vec3,
  up: [0, 1, 0] as Vec3,
  verticalFov: (2 * Math.atan(height / 40) * 180) / Math.PI,
});

/** Mean radiance of the picture and its standard error, red, green, blue. */
async function measure(harness: Page, backend: Backend, scene: Scene, samples: number) {
  const { mean, variance } = blocksOfBatches(
    await pathFilms(harness, backend, scene, { ...SIZE, samples, seed: SEED }),
    WHOLE,
  );
  return [0, 1, 2].map((c) => ({ mean: mean[c]!, error: Math.sqrt(variance[c]!) }));
}

const glass = plastic({ transmission: { weight: 1 }, volume: { thickness: 1 } });
/** Each sends on all light, wherever it comes from. */
const WHITE: Readonly<Record<string, Material>> = {
  wall: plastic({ transmission: { weight: 1 } }),
  glass,
  diamond: { ...glass, ior: 2.4, dispersion: 4 },
  leaf: plastic({
    specularLobe: { weight: 0, color: [1, 1, 1] },
    diffuseTransmission: { weight: 0.5, color: [1, 1, 1] },
  }),
  coated: plastic({ metallic: 1, clearcoat: { weight: 1, roughness: 0 } }),
  unlit: plastic({ unlit: true }),
};

const seeds = `seeds ${SEED} to ${SEED + SIZE.batches - 1}`;
for (const backend of backends) {
  test(`${backend}: white layered balls in white light are not to be seen (${seeds})`, async ({ harness }) => {
    const names = Object.keys(WHITE);
    const shapes = Object.fromEntries(names.map((name, i) => [name, ball(2 * (i % 3) - 2, 2 * Math.floor(i / 3) - 1, name)])); // biome-ignore format: one line
    const scene = testScene(shapes, {}, { camera: camera(6), materials: WHITE, render: RENDER, sky: sky(1) });
    for (const { mean, error } of await measure(harness, backend, scene, 64)) {
      expect.soft(error, 'noise').toBeLessThan(2e-3);
      expect.soft(Math.abs(mean - 1)).toBeLessThan(4.5 * error + 1e-5);
    }
  });

  test(`${backend}: light fades in a body by its true length, is dimmed by coats, and unlit is a colour (${seeds})`, async ({
    harness,
  }) => {
    const still = (material: Material, radiance: number) =>
      testScene({ ball: ball(0, 0, 'm') }, {}, { camera: camera(0.002), materials: { m: material }, render: RENDER, sky: sky(radiance) }); // biome-ignore format: one line
    // Of index 1 it bends nothing; the way through is 1.8 m.
    const smoke = { ...glass, ior: 1, attenuationColor: [0.5, 0.25, 1] as const, attenuationDistance: 0.9 };
    const expected: readonly (readonly [Material, number, Vec3])[] = [
      [smoke, 1, [0.25, 0.0625, 1]],
      [plastic({ metallic: 1, emission: [1, 2, 3], clearcoat: { weight: 0.5, roughness: 0 } }), 0, [0.98, 1.96, 2.94]],
      [plastic({ unlit: true, baseColor: [0.2, 0.4, 0.6], emission: [9, 9, 9] }), 5, [0.2, 0.4, 0.6]],
    ];
    for (const [material, radiance, color] of expected)
      (await measure(harness, backend, still(material, radiance), 2)).forEach(({ mean }, c) => {
        expect.soft(Math.abs(mean / color[c]! - 1), JSON.stringify(material)).toBeLessThan(1e-4);
      });
  });
}

// By one program that has all features: which each layer needs is layers.spec.ts' matter. textures.spec.ts looks textures up on both.
test('webgl2: textures multiply every number of the layers', async ({ harness }) => {
  const cases = await harness.evaluate((b) => window.harness.layerTextures(b), 'webgl2' as const);
  expect(cases.length).toBe(15);
  for (const { what, difference, effect } of cases) {
    // The same random numbers: films differ by rounding, where that does not choose another way for a path.
    expect.soft(difference, what).toBeLessThan(2e-3);
    expect.soft(effect, what).toBeGreaterThan(5 * 2e-3);
  }
});
