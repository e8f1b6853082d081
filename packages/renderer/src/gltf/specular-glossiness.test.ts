/** KHR_materials_pbrSpecularGlossiness, by the formulas of its text. */
import { expect, test } from 'vitest';
import { directionOf } from '../../../../tests/fixtures/bsdf-cases.ts';
import { type Draft, triangleFile } from '../../../../tests/fixtures/gltf.ts';
import { evaluateLayered } from '../../../../tests/fixtures/layers/layered-bsdf.ts';
import { layered } from '../../../../tests/fixtures/layers/layered-material.ts';
import { fromInterleaved } from '../export/float-picture.ts';
import { writePng } from '../export/png.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { add, dot, normalize } from '../scene/vec3.ts';
import { pngDecoder } from './images/decoder.ts';
import { importGltf } from './index.ts';

const NAME = 'KHR_materials_pbrSpecularGlossiness';
const linear = (byte: number): number =>
  byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4;

/** Of 2 × 1 pixels, as shares of a byte. */
const png = (...rgba: number[]): Uint8Array => writePng(fromInterleaved(2, 1, ['R', 'G', 'B', 'A'], rgba));
const IMAGES = {
  diffuse: png(1, 0.5, 0, 1, 0.2, 0.2, 0.2, 0.5),
  gloss: png(0.04, 0.04, 0.04, 0.25, 0.5, 0.1, 0.3, 1),
};

async function imported(glossy: Draft, rest: Draft = {}) {
  const file = triangleFile((f) => {
    const { attributes } = f.json.meshes[0].primitives[0];
    attributes.TEXCOORD_0 = f.floats('VEC2', 0, 0, 1, 0, 0, 1);
    f.json.meshes[0].primitives[0].material = f.add('materials', {
      name: 'm',
      extensions: { [NAME]: glossy },
      ...rest,
    });
    for (const [name, bytes] of Object.entries(IMAGES))
      f.add('textures', { source: f.add('images', { name, bufferView: f.view(bytes), mimeType: 'image/png' }) });
    f.json.extensionsUsed = [NAME];
    f.json.extensionsRequired = [NAME];
  });
  const result = await importGltf(file.glb(), { decoder: pngDecoder });
  if (!result.ok) throw new Error(result.problems.map(({ message }) => message).join('\n'));
  return { ...result, material: result.scene.materials.m! };
}
const pixelsOf = (scene: Scene, texture: string) => scene.images![scene.textures![texture]!.image]!.data!;

test('numbers become those of a dielectric whose specular lobe has this F₀; metal and roughness of the file do not count', async () => {
  const { material, report } = await imported(
    { diffuseFactor: [0.5, 1, 0.2, 0.3], specularFactor: [0.2, 0.5, 0.04], glossinessFactor: 0.7 },
    { pbrMetallicRoughness: { baseColorFactor: [1, 0, 0, 1], metallicFactor: 1 } },
  );
  expect(material).toMatchObject({ metallic: 0, ior: 1.5, opacity: 0.3 });
  expect(material.roughness).toBeCloseTo(0.3, 12);
  [0.25, 0.5, 0.1].forEach((x, c) => {
    expect(material.baseColor[c]).toBeCloseTo(x, 12);
  });
  [5, 12.5, 1].forEach((x, c) => {
    expect(material.specularLobe!.color[c]).toBeCloseTo(x, 12);
  });
  expect(report.entries).toEqual([]);
});

test('an empty extension is a white mirror, as its text has it', async () => {
  expect((await imported({})).material).toMatchObject({ baseColor: [0, 0, 0], roughness: 0, specularLobe: { weight: 1, color: [25, 25, 25] } }); // biome-ignore format: one line
});

test('of textures are made: how rough, and the diffuse colour that reflection leaves', async () => {
  const { scene, material, report } = await imported({
    diffuseFactor: [0.9, 1, 1, 1],
    specularFactor: [1, 0.5, 1],
    glossinessFactor: 0.8,
    diffuseTexture: { index: 0 },
    specularGlossinessTexture: { index: 1 },
  });
  expect(report.entries).toEqual([]);
  expect(material).toMatchObject({ baseColor: [0.9, 1, 1], metallic: 0, roughness: 1, specularLobe: { color: [25, 12.5, 25] } }); // biome-ignore format: one line
  expect(scene.textures![material.specularLobe!.colorTexture!.texture]!.image).toBe('gloss');
  const rough = pixelsOf(scene, material.metallicRoughnessTexture!.texture);
  [0.25, 1].forEach((gloss, x) => {
    expect(Math.abs(rough.rgba[4 * x + 1]! / 255 - (1 - 0.8 * gloss))).toBeLessThan(1 / 255);
  });
  const dimmed = pixelsOf(scene, material.baseColorTexture!.texture).rgba;
  // The brightest of what is reflected, times its factor, is missing.
  const left = [1 - linear(0.04 * 255), 1 - linear(0.5 * 255)] as const;
  const expected = [1, linear(0.5 * 255), 0].map((x) => x * left[0]);
  expected.push(...[0, 1, 2].map(() => linear(0.2 * 255) * left[1]));
  [0, 1, 2, 4, 5, 6].forEach((at, k) => {
    expect(Math.abs(linear(dimmed[at]!) - expected[k]!)).toBeLessThan(0.006);
  });
  expect([dimmed[3], dimmed[7]]).toEqual([255, 128]);
});

test('textures that lie otherwise make no third, and that is told', async () => {
  const { scene, material, report } = await imported({
    diffuseTexture: { index: 0, extensions: { KHR_texture_transform: { scale: [2, 2] } } },
    specularGlossinessTexture: { index: 1 },
  });
  expect(report.entries.map(({ what, kind }) => `${kind} ${what}`)).toEqual(['changed diffuseTexture']);
  expect(scene.textures![material.baseColorTexture!.texture]!.image).toBe('diffuse');
});

test('what is drawn is the formula of the text', async () => {
  const [diffuse, f0, glossiness] = [[0.7, 0.3, 0.9], [0.3, 0.04, 0.6], 0.45] as const;
  const { material } = await imported({ diffuseFactor: [...diffuse, 1], specularFactor: f0, glossinessFactor: glossiness }); // biome-ignore format: one line
  const m = layered({ baseColor: material.baseColor, roughness: material.roughness, ior: material.ior, specular: material.specularLobe!.weight, specularColor: material.specularLobe!.color }); // biome-ignore format: one line
  const alpha2 = (1 - glossiness) ** 4;
  const lambda = (z: number) => (Math.sqrt(1 + (alpha2 * (1 - z * z)) / (z * z)) - 1) / 2;
  for (const [a, b] of [
    [directionOf(0.9, 0), directionOf(0.3, 2)],
    [directionOf(0.2, 1), directionOf(0.7, 4)],
    [directionOf(0.05, 1), directionOf(0.1, 4.1)],
  ] as [Vec3, Vec3][]) {
    // biome-ignore format: directions
    const h = normalize(add(a, b));
    const d = alpha2 / (Math.PI * (h[2] ** 2 * (alpha2 - 1) + 1) ** 2);
    const gloss = d / ((1 + lambda(a[2]) + lambda(b[2])) * 4 * a[2] * b[2]);
    const fresnel = (f: number) => f + (1 - f) * (1 - dot(a, h)) ** 5;
    const drawn = evaluateLayered(m, a, b, 0, () => 0);
    f0.forEach((f, c) => {
      // The text leaves open how three colours share what is left; the greatest of them takes, so that nothing is made.
      const body = (diffuse[c]! * (1 - Math.max(...f0)) * (1 - fresnel(Math.max(...f0)))) / Math.PI;
      expect(Math.abs(drawn[c]! - (body + fresnel(f) * gloss) * b[2])).toBeLessThan(1e-9 + 1e-9 * drawn[c]!);
    });
  }
});
