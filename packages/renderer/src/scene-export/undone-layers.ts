/** What a material has beyond its base, in words: for formats that have no such things. */
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material } from '../scene/scene.ts';

/** Null: it makes no difference by itself. */
const WORDS: { readonly [Key in keyof MaterialLayers]-?: string | null | ((m: Material) => string | null) } = {
  baseColorTexture: null,
  metallicRoughnessTexture: null,
  normalTexture: null,
  emissionTexture: null,
  occlusionTexture: null,
  opacity: null,
  alphaMode: null,
  alphaCutoff: null,
  doubleSided: null,
  unlit: null,
  emissionStrength: null,
  dispersion: ({ dispersion = 0 }) => (dispersion > 0 ? 'dispersion' : null),
  specularLobe: null,
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
