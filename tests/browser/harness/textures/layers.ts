/** Every texture that glTF's layers may have: a surface with it beside one whose numbers are multiplied already. */
import type { Camera, Light, Material, Scene } from '../../../../packages/renderer/src/scene/scene.ts';
import { flat, sheet } from '../../../fixtures/meshes/sheet.ts';
import { testMaterial, testScene } from '../../../fixtures/scenes.ts';
import type { GpuBackend } from '../parity.ts';
import { renderBy } from '../path.ts';
import { tracerOfAll } from '../tracers.ts';

export interface LayerTexture {
  readonly what: string;
  /** Root of the mean squared difference of the films, as a share of their mean. */
  readonly difference: number;
  /** How far the film is from one without the texture: 0 would mean that it does nothing. */
  readonly effect: number;
}

/** Of one texel; colours are sRGB. */
const TEXEL = [204, 102, 153, 51] as const;
const [R, G, B, A] = TEXEL.map((byte) => byte / 255) as [number, number, number, number];
const linear = (x: number): number => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4);
const COLOR = [linear(R), linear(G), linear(B)] as const;
const use = { texture: 'one' };
const times = ([r, g, b]: readonly [number, number, number]) => [r * COLOR[0], g * COLOR[1], b * COLOR[2]] as const;

const bent = { texture: 'one', normalScale: 0.7 };

type Part = Partial<Material>;
const SMOOTH = { weight: 1, roughness: 0 };
const BLACK: Part = { baseColor: [0, 0, 0], specularLobe: { weight: 0, color: [1, 1, 1] } };
/** With a texture, and what that comes to; and what it must not, if that is not the same without a texture. */
const CASES: Readonly<Record<string, readonly [textured: Part, plain: Part, other?: Part]>> = {
  'metal and roughness': [
    { metallic: 0.9, roughness: 0.8, metallicRoughnessTexture: use },
    { metallic: 0.9 * B, roughness: 0.8 * G },
  ],
  'specular weight': [
    { specularLobe: { weight: 0.9, color: [9, 9, 9], weightTexture: use } },
    { specularLobe: { weight: 0.9 * A, color: [9, 9, 9] } },
  ],
  'specular colour': [
    { specularLobe: { weight: 1, color: [9, 6, 9], colorTexture: use } },
    { specularLobe: { weight: 1, color: times([9, 6, 9]) } },
  ],
  transmission: [{ transmission: { weight: 0.9, weightTexture: use } }, { transmission: { weight: 0.9 * R } }],
  'diffuse transmission': [
    { diffuseTransmission: { weight: 0.9, color: [1, 1, 1], weightTexture: use } },
    { diffuseTransmission: { weight: 0.9 * A, color: [1, 1, 1] } },
  ],
  'colour of diffuse transmission': [
    { diffuseTransmission: { weight: 0.9, color: [1, 0.5, 1], colorTexture: use } },
    { diffuseTransmission: { weight: 0.9, color: times([1, 0.5, 1]) } },
  ],
  clearcoat: [
    { clearcoat: { weight: 1, roughness: 0.3, weightTexture: use } },
    { clearcoat: { weight: R, roughness: 0.3 } },
  ],
  'roughness of clearcoat': [
    { clearcoat: { weight: 1, roughness: 0.9, roughnessTexture: use } },
    { clearcoat: { weight: 1, roughness: 0.9 * G } },
  ],
  // What lies under these coats sends nothing back; a mirror's samples know no azimuth.
  'normals of clearcoat': [
    { ...BLACK, clearcoat: { ...SMOOTH, normalTexture: bent } },
    { ...BLACK, clearcoat: { ...SMOOTH, normalTexture: bent }, normalTexture: bent },
  ],
  'normals of a base, which leave its clearcoat as it is': [
    { ...BLACK, clearcoat: SMOOTH, normalTexture: bent },
    { ...BLACK, clearcoat: SMOOTH },
    { ...BLACK, clearcoat: { ...SMOOTH, normalTexture: bent }, normalTexture: bent },
  ],
  'colour of sheen': [
    { sheen: { color: [1, 0.8, 1], roughness: 0.6, colorTexture: use } },
    { sheen: { color: times([1, 0.8, 1]), roughness: 0.6 } },
  ],
  'roughness of sheen': [
    { sheen: { color: [1, 1, 1], roughness: 1, roughnessTexture: use } },
    { sheen: { color: [1, 1, 1], roughness: A } },
  ],
  anisotropy: [
    { metallic: 1, anisotropy: { strength: 0.9, rotation: 30, texture: use } },
    {
      metallic: 1,
      anisotropy: { strength: 0.9 * B, rotation: 30 + (Math.atan2(2 * G - 1, 2 * R - 1) * 180) / Math.PI },
    },
  ],
  iridescence: [
    { iridescence: { weight: 1, ior: 1.8, thicknessMinimum: 100, thicknessMaximum: 300, weightTexture: use } },
    { iridescence: { weight: R, ior: 1.8, thicknessMinimum: 100, thicknessMaximum: 300 } },
  ],
  'thickness of the film': [
    { iridescence: { weight: 1, ior: 1.8, thicknessMinimum: 100, thicknessMaximum: 900, thicknessTexture: use } },
    { iridescence: { weight: 1, ior: 1.8, thicknessMinimum: 0, thicknessMaximum: 100 * (1 - G) + 900 * G } },
  ],
};

const camera: Camera = { eye: [0.3, -1.2, 2], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 20 };
const lamp: Light = {
  type: 'quad',
  corner: [-1, 1, 0.5],
  u: [2, 0, 0],
  v: [0, 0, 1.5],
  radiance: 8,
  color: [1, 0.9, 0.8],
  visible: true,
};
const RENDER = { integrator: 'path', maxDepth: 3, maxReflections: 0, lightSamples: 1, exposure: 0, toneMapping: 'none' } as const; // biome-ignore format: one line
const SIZE = { width: 24, height: 24, samples: 8, firstSample: 0, seed: 41 };

function sceneWith(part: Part): Scene {
  const cloth = testMaterial({ type: 'metallicRoughness', roughness: 0.5, baseColor: [0.4, 0.3, 0.2], ...part });
  const at = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
  const data = { ...sheet(1, flat), colors: undefined };
  return {
    ...testScene(
      { cloth: { type: 'mesh', mesh: 'sheet', material: 'cloth', ...at } },
      { lamp },
      {
        camera,
        materials: { cloth },
        meshes: { sheet: { data } } as unknown as NonNullable<Scene['meshes']>,
        render: RENDER,
        sky: { horizon: [0.2, 0.3, 0.4], zenith: [0.6, 0.5, 0.4] },
      },
    ),
    images: { one: { data: { width: 1, height: 1, rgba: Uint8Array.from(TEXEL) } } },
    textures: { one: { image: 'one' } },
  };
}

const withoutTextures = (part: Part): Part =>
  JSON.parse(JSON.stringify(part, (key, value) => (key.toLowerCase().endsWith('texture') ? undefined : value)));

function apart(a: Float32Array, b: Float32Array): number {
  const mean = a.reduce((sum, x) => sum + x, 0) / a.length;
  return Math.sqrt(a.reduce((sum, x, i) => sum + (x - b[i]!) ** 2, 0) / a.length) / mean;
}

export async function layerTextures(backend: GpuBackend): Promise<LayerTexture[]> {
  const tracer = await tracerOfAll(backend);
  const film = async (part: Part) => (await renderBy(tracer, sceneWith(part), SIZE)).sum;
  const results: LayerTexture[] = [];
  for (const [what, [textured, plain, other = withoutTextures(textured)]] of Object.entries(CASES)) {
    const own = await film(textured);
    const effect = apart(own, await film(other));
    results.push({ what, difference: apart(own, await film(plain)), effect });
  }
  return results;
}
