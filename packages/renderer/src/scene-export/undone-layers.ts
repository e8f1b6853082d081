/** What a material has beyond its base, in words: for formats that have no such things. */
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material } from '../scene/scene.ts';

const TEXTURES = 'textures';
/** Null: it makes no difference by itself. */
const WORDS: { readonly [Key in keyof MaterialLayers]-?: string | null | ((m: Material) => string | null) } = {
  baseColorTexture: TEXTURES,
  metallicRoughnessTexture: TEXTURES,
  normalTexture: TEXTURES,
  emissionTexture: ({ emission }) => (emission.some((x) => x > 0) ? TEXTURES : null),
  occlusionTexture: null,
  opacity: null,
  alphaMode: ({ alphaMode }) => (alphaMode === 'mask' || alphaMode === 'blend' ? 'opacity' : null),
  alphaCutoff: null,
  doubleSided: ({ doubleSided }) => (doubleSided === false ? 'materials of one side' : null),
  unlit: ({ unlit }) => (unlit ? 'materials without light ("unlit")' : null),
  emissionStrength: null,
  dispersion: ({ dispersion = 0 }) => (dispersion > 0 ? 'dispersion' : null),
  specularLobe: 'specular lobe',
  transmission: ({ transmission }) => (transmission!.weight > 0 ? 'transmission' : null),
  volume: null,
  diffuseTransmission: ({ diffuseTransmission }) => (diffuseTransmission!.weight > 0 ? 'diffuse transmission' : null),
  clearcoat: ({ clearcoat }) => (clearcoat!.weight > 0 ? 'clearcoat' : null),
  sheen: ({ sheen }) => (sheen!.color.some((x) => x > 0) ? 'sheen' : null),
  anisotropy: ({ anisotropy }) => (anisotropy!.strength > 0 ? 'anisotropy' : null),
  iridescence: ({ iridescence }) => (iridescence!.weight > 0 ? 'iridescence' : null),
};

/** What the material has of these, each once. */
export function lacksLayers(material: Material): string[] {
  const words = Object.entries(WORDS).flatMap(([key, say]) => {
    if (material[key as keyof MaterialLayers] === undefined) return [];
    const said = typeof say === 'function' ? say(material) : say;
    return said === null ? [] : [said];
  });
  return [...new Set(words)];
}
