import { expect, test } from 'vitest';
import { flat, sheet } from '../../../../../tests/fixtures/meshes/sheet.ts';
import { between, seededRandom } from '../../../../../tests/fixtures/random.ts';
import { testMaterial, testScene } from '../../../../../tests/fixtures/scenes.ts';
import type { Material, MeshShape, Scene, Vec3 } from '../../scene/scene.ts';
import { dot, normalize, reflect, scale } from '../../scene/vec3.ts';
import { closestHit, surfaceAt } from '../cast.ts';
import { prepareScene } from '../prepare.ts';
import { cameraRay } from '../ray.ts';
import { bentNormal } from './bent-normal.ts';

const wall: MeshShape = {
  type: 'mesh',
  mesh: 'wall',
  material: 'it',
  translation: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
};
/** Four columns: black and clear, then brighter and more opaque. */
const ramp = Uint8Array.from([0, 85, 170, 255].flatMap((x) => [x, x, x, x]));

function sceneOf(material: Partial<Material>): Scene {
  const { colors: _, ...data } = sheet(2, flat);
  return {
    ...testScene({ wall }, {}, { materials: { it: testMaterial(material) }, meshes: { wall: { data } } }),
    images: { ramp: { data: { width: 4, height: 1, rgba: ramp } } },
    textures: { ramp: { image: 'ramp', filter: 'nearest' } },
  };
}

/** Along −z, or along z from behind. */
function look(material: Partial<Material>, x: number, fromBehind = false) {
  const eye: Vec3 = [x, 0.1, fromBehind ? -3 : 3];
  const ray = cameraRay(eye, [0, 0, fromBehind ? 1 : -1]);
  const { t, shape, spot } = closestHit(prepareScene(sceneOf(material)), ray);
  return shape && surfaceAt(shape, ray, t, spot);
}

const baseColorTexture = { texture: 'ramp' };
const COLUMNS = [-0.75, -0.25, 0.25, 0.75];

test('base colours are those of the texture, linear', () => {
  const red = COLUMNS.map((x) => look({ baseColor: [0.5, 1, 1], baseColorTexture }, x)!.baseColor[0]);
  const linear = [0, 85, 170, 255].map(
    (byte) => 0.5 * (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4),
  );
  for (const [i, x] of red.entries()) expect(x).toBeCloseTo(linear[i]!, 12);
});

test('a mask is there from its cutoff on, what blends from one half on, and an opaque material everywhere', () => {
  const there = (material: Partial<Material>) =>
    COLUMNS.map((x) => look({ baseColorTexture, ...material }, x) !== null);
  expect(there({})).toEqual([true, true, true, true]);
  expect(there({ alphaMode: 'mask', alphaCutoff: 0.3 })).toEqual([false, true, true, true]);
  expect(there({ alphaMode: 'mask', alphaCutoff: 0.3, opacity: 0.5 })).toEqual([false, false, true, true]);
  expect(there({ alphaMode: 'blend' })).toEqual([false, false, true, true]);
});

test('from behind a material that is not double-sided is not there, unless light goes through', () => {
  const seen = (material: Partial<Material>) =>
    [look(material, 0.1), look(material, 0.1, true)].map((hit) => hit !== null);
  expect(seen({})).toEqual([true, true]);
  expect(seen({ doubleSided: false })).toEqual([true, false]);
  expect(seen({ doubleSided: false, transmission: { weight: 0.5 } })).toEqual([true, true]);
});

test('a bent normal lets the mirrored ray out, and others stay as they are (seed 9)', () => {
  const random = seededRandom(9);
  const up: Vec3 = [0, 0, 1];
  let bent = 0;
  for (let k = 0; k < 500; k++) {
    const direction = () => normalize([between(random, -1, 1), between(random, -1, 1), between(random, 0.001, 0.6)]);
    const [eye, normal] = [direction(), direction()];
    const result = bentNormal(up, eye, normal);
    const height = dot(reflect(scale(eye, -1), result), up);
    expect(height).toBeGreaterThan(Math.min(0.9 * eye[2], 0.01) - 1e-9);
    expect(dot(result, eye)).toBeGreaterThan(0);
    if (result === normal) continue;
    bent++;
    // It lies between the normal and the geometric one.
    expect(result[2]).toBeGreaterThan(normal[2]);
    expect(height).toBeLessThan(Math.min(0.9 * eye[2], 0.01) + 1e-6);
  }
  expect(bent).toBeGreaterThan(50);
});
