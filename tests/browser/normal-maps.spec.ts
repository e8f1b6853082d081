import type { Page } from '@playwright/test';
import { evaluateBsdf } from '../../packages/renderer/src/reference/bsdf/bsdf.ts';
import type { BsdfSurface } from '../../packages/renderer/src/reference/bsdf/surface.ts';
import { bentNormal } from '../../packages/renderer/src/reference/mesh/bent-normal.ts';
import type { Light, Material, Scene, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { cross, dot, normalize, scale } from '../../packages/renderer/src/scene/vec3.ts';
import { flat, sheet } from '../fixtures/meshes/sheet.ts';
import { testMaterial, testScene } from '../fixtures/scenes.ts';
import { pathFilm } from './films.ts';
import { type Backend, backends, expect, test } from './fixtures.ts';

/** Surfaces that a normal map bends: what they send back of light from everywhere, and that it goes both ways. */
const SEED = 320;
const UP: Vec3 = [0, 0, 1];
/** Tilted by 29° towards +x. */
const TEXEL = [190, 128, 240] as const;
const MAPPED = normalize(TEXEL.map((byte) => (2 * byte) / 255 - 1) as unknown as Vec3);
const at = (degrees: number, turn = 0): Vec3 => {
  const [sine, cosine] = [Math.sin((degrees * Math.PI) / 180), Math.cos((degrees * Math.PI) / 180)];
  return [sine * Math.cos(turn), sine * Math.sin(turn), cosine];
};

/** A sheet that is seen from that side, all pixels within a millimetre. */
function bentSheet(material: Partial<Material>, eye: Vec3, sky: number, lights: Record<string, Light> = {}): Scene {
  const shape = { type: 'mesh', mesh: 'sheet', material: 'bent', translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const; // biome-ignore format: one line
  return {
    ...testScene({ shape }, lights, {
      camera: { eye: scale(eye, 5), target: [0, 0, 0], up: [0, 1, 0], verticalFov: 0.01 },
      materials: { bent: testMaterial({ baseColor: [1, 1, 1], normalTexture: { texture: 'map' }, ...material }) },
      meshes: { sheet: { data: { ...sheet(1, flat), colors: undefined } } } as unknown as NonNullable<Scene['meshes']>,
      render: { integrator: 'path', maxDepth: 2, maxReflections: 0, lightSamples: 1, exposure: 0, toneMapping: 'none' },
      sky: { horizon: [sky, sky, sky], zenith: [sky, sky, sky] },
    }),
    images: { map: { data: { width: 1, height: 1, rgba: Uint8Array.of(...TEXEL, 255) } } },
    textures: { map: { image: 'map' } },
  };
}

/** Mean of red, and its standard error as if samples were independent. */
async function red(harness: Page, backend: Backend, scene: Scene, samples: number) {
  const { sum, sumOfSquares } = await pathFilm(harness, backend, scene, { width: 16, height: 16, samples, firstSample: 0, seed: SEED }); // biome-ignore format: one line
  const count = 256 * samples;
  const total = (film: ArrayLike<number>) =>
    Array.from(film).reduce((all, x, i) => (i % 3 === 0 ? all + x : all), 0) / count;
  const mean = total(sum);
  return { mean, error: Math.sqrt(Math.max(total(sumOfSquares) - mean * mean, 0) / count) };
}

const rough: Partial<Material> = { type: 'metallicRoughness', metallic: 1, roughness: 0.6 };
const METAL: BsdfSurface = { type: 'metallicRoughness', baseColor: [1, 1, 1], reflectivity: 0, metallic: 1, alpha: 0.36, ior: 1.5, eta: [0, 0, 0], k: [0, 0, 0], thin: false, energyCompensation: false, masking: 'correlated' }; // biome-ignore format: one line

/** What GGX about the bent normal sends to the geometric normal's side, by the midpoint rule. */
function roughAlbedo(normal: Vec3, eye: Vec3): number {
  const along = normalize(cross(normal, [0, 1, 0]));
  const local = (w: Vec3): Vec3 => [dot(w, along), dot(w, cross(normal, along)), dot(w, normal)];
  const n = 240;
  let sum = 0;
  for (let k = 0; k < n * n; k++) {
    const z = (Math.floor(k / n) + 0.5) / n;
    const wi = local(at((Math.acos(z) * 180) / Math.PI, ((k % n) + 0.5) * ((2 * Math.PI) / n)));
    if (wi[2] > 0) sum += evaluateBsdf(METAL, local(eye), wi).value[0];
  }
  return (sum * 2 * Math.PI) / (n * n);
}

for (const backend of backends) {
  test(`${backend}: white surfaces lose by a normal map what it sends below them, and make no light (seed ${SEED})`, async ({
    harness,
  }) => {
    // From the side that it is tilted to; from the other, where a mirrored ray would just go in; and so flat that it looks away.
    for (const degrees of [35, -35, -84]) {
      const eye = at(degrees);
      const normal = bentNormal(UP, eye, MAPPED);
      expect(dot(normal, MAPPED) < 1 - 1e-9, 'bent').toBe(degrees < 0);
      const cases: readonly (readonly [string, Partial<Material>, number])[] = [
        // Of a hemisphere about a tilted normal (1 − cos θ) / 2 of the cosine lie below the horizon.
        ['matte', {}, (1 + dot(normal, UP)) / 2],
        ['mirror', { ...rough, roughness: 0 }, 1],
        ['rough metal', rough, roughAlbedo(normal, eye)],
      ];
      for (const [name, material, exact] of cases) {
        const { mean, error } = await red(harness, backend, bentSheet(material, eye, 1), 32);
        const what = `${name} from ${degrees}°: ${mean} for ${exact}`;
        expect.soft(exact, what).toBeLessThan(1 + 1e-9);
        expect.soft(Math.abs(mean - exact), what).toBeLessThan(4.5 * error + 2e-4);
        expect.soft(mean, what).toBeLessThan(1 + 4.5 * error + 1e-5);
      }
    }
  });

  test(`${backend}: where nothing is bent back, light goes both ways through a normal map alike (seed ${SEED})`, async ({
    harness,
  }) => {
    const sun = (from: Vec3): Light => ({ type: 'directional', direction: scale(from, -1), irradiance: 1, color: [1, 1, 1], angle: 0 }); // biome-ignore format: one line
    const [a, b] = [at(40, 1), at(15, -2)];
    for (const w of [a, b]) expect(bentNormal(UP, w, MAPPED)).toEqual(MAPPED);
    const share = async (eye: Vec3, from: Vec3) => {
      const { mean } = await red(harness, backend, bentSheet(rough, eye, 0, { sun: sun(from) }), 1);
      return mean / dot(MAPPED, from);
    };
    const [there, back] = [await share(a, b), await share(b, a)];
    expect(there).toBeGreaterThan(0.05);
    expect(Math.abs(there / back - 1)).toBeLessThan(1e-3);
  });
}
