import { expect, test } from 'vitest';
import { triangleMesh } from '../../../../../tests/fixtures/meshes/solids.ts';
import { testMaterial, testScene } from '../../../../../tests/fixtures/scenes.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { Material } from '../../scene/scene.ts';
import type { Feature } from '../../shading/features.ts';
import { aovFeatures } from '../aov/aov.ts';
import { pathFeatures } from './path-features.ts';

const TEXTURES = ['hasTextures', 'hasNormalMaps', 'hasVertexMore', 'hasOtherLookups'] as const;

const placed = { translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;

function needsOf(part: Partial<Material>, mesh: Partial<Mesh> = {}): ReadonlySet<Feature> {
  const material = testMaterial({ type: 'metallicRoughness', ...part });
  const scene = {
    ...testScene({ thing: { ...placed, type: 'mesh', mesh: 'one', material: 'look' } }, {}, { materials: { look: material } }), // biome-ignore format: one row
    meshes: { one: { data: { ...triangleMesh(), ...mesh } } },
    textures: { plain: { image: 'i' }, edge: { image: 'i', wrapV: 'clamp' as const }, hard: { image: 'i', filter: 'nearest' as const } }, // biome-ignore format: one row
    images: { i: { data: { width: 1, height: 1, rgba: new Uint8Array(4) } } },
  };
  return pathFeatures({ scene, camera: scene.camera, settings: { pixelFilter: 'box' } });
}

const texturesOf = (needs: ReadonlySet<Feature>) => TEXTURES.filter((feature) => needs.has(feature));

test('a program looks up textures as the meshes ask for it, and no further', () => {
  const use = (texture: string, uvSet: 0 | 1 = 0) => ({ texture, uvSet });
  expect(texturesOf(needsOf({}))).toEqual([]);
  expect(texturesOf(needsOf({ baseColorTexture: use('plain') }))).toEqual(['hasTextures']);
  expect(texturesOf(needsOf({ normalTexture: use('plain') }))).toEqual(['hasTextures', 'hasNormalMaps']);
  expect(texturesOf(needsOf({ baseColorTexture: use('plain', 1) }))).toEqual(['hasTextures', 'hasVertexMore']);
  expect(texturesOf(needsOf({}, { colors: new Float32Array(12) }))).toEqual(['hasTextures', 'hasVertexMore']);
  for (const texture of ['edge', 'hard'])
    expect(texturesOf(needsOf({ metallicRoughnessTexture: use(texture) }))).toEqual(['hasTextures', 'hasOtherLookups']);
  expect(texturesOf(needsOf({ anisotropy: { strength: 1, rotation: 0 } }))).toEqual(['hasTextures', 'hasNormalMaps']);
  const coat = { weight: 1, roughness: 0, normalTexture: use('plain') };
  expect(texturesOf(needsOf({ clearcoat: coat }))).toEqual(['hasTextures', 'hasNormalMaps']);
});

const plain = { texture: 'plain' };
const specular = { weight: 1, color: [0.5, 1, 1] } as const;
const beyond = { weight: 0.5, color: [1, 0.5, 1] } as const;
const film = { weight: 1, ior: 1.8, thicknessMinimum: 100, thicknessMaximum: 300 };
const cloth = { color: [1, 1, 1], roughness: 0.5 } as const;
/** Each texture that a layer may have. */
const LAYERS: readonly ((texture: typeof plain | undefined) => Partial<Material>)[] = [
  (weightTexture) => ({ specularLobe: { ...specular, weightTexture } }),
  (colorTexture) => ({ specularLobe: { ...specular, colorTexture } }),
  (weightTexture) => ({ transmission: { weight: 0.9, weightTexture } }),
  (weightTexture) => ({ diffuseTransmission: { ...beyond, weightTexture } }),
  (colorTexture) => ({ diffuseTransmission: { ...beyond, colorTexture } }),
  (weightTexture) => ({ clearcoat: { weight: 1, roughness: 0.3, weightTexture } }),
  (roughnessTexture) => ({ clearcoat: { weight: 1, roughness: 0.3, roughnessTexture } }),
  (colorTexture) => ({ sheen: { ...cloth, colorTexture } }),
  (roughnessTexture) => ({ sheen: { ...cloth, roughnessTexture } }),
  (texture) => ({ anisotropy: { strength: 0.9, rotation: 30, texture } }),
  (weightTexture) => ({ iridescence: { ...film, weightTexture } }),
  (thicknessTexture) => ({ iridescence: { ...film, thicknessTexture } }),
];

test('a layer with a texture asks for what it asks for without one, and for textures', () => {
  for (const layer of LAYERS) {
    const without = needsOf(layer(undefined));
    expect(without).toContain('hasLayers');
    expect([...needsOf(layer(plain))].sort()).toEqual([...new Set([...without, 'hasTextures'])].sort());
  }
});

test('a program for AOVs of models has what is seen of them, whatever the camera', () => {
  const needs = needsOf({ normalTexture: { texture: 'plain' }, clearcoat: { weight: 1, roughness: 0 } });
  const features = aovFeatures(needs);
  for (const feature of ['hasMeshes', 'hasNormalMaps', 'hasLens', 'hasOtherProjections', 'hasFilter'] as const)
    expect(features).toContain(feature);
  for (const feature of ['hasCoats', 'hasLayers', 'hasSky', 'hasVertexMore', 'hasSpheres'] as const)
    expect(features).not.toContain(feature);
  expect(aovFeatures(needsOf({ transmission: { weight: 1 } }))).toContain('hasLayers');
  // Those without models share one.
  expect(aovFeatures(new Set(['hasSpheres']))).toEqual(aovFeatures(new Set(['hasBoxes', 'hasLens'])));
});
