/** What the layers of a material come to. Only `metallicRoughness` has a use for them. */
import type { MaterialLayers, SpecularLobe } from './material-layers.ts';
import type { Material } from './scene.ts';

type Layered = Material & MaterialLayers;

/** The index of glTF's base, of which the kernels' metallicRoughness is made. */
const PLAIN_INDEX = 1.5;

/** Whether the material is more than its base. */
export function isLayered(m: Layered): boolean {
  if (m.type !== 'metallicRoughness' || m.unlit) return false;
  const lobe = m.specularLobe;
  return (
    m.ior !== PLAIN_INDEX ||
    (lobe !== undefined && (lobe.weight !== 1 || lobe.color.some((x) => x !== 1) || isTextured(lobe))) ||
    isClear(m) ||
    (m.clearcoat?.weight ?? 0) > 0 ||
    (m.sheen?.color.some((x) => x > 0) ?? false) ||
    (m.anisotropy?.strength ?? 0) > 0 ||
    (m.iridescence?.weight ?? 0) > 0
  );
}

/** Whether light goes through by glTF's extensions; metal lets none. */
export function isClear(m: Layered): boolean {
  if (m.type !== 'metallicRoughness' || m.unlit || (m.metallic === 1 && !m.metallicRoughnessTexture)) return false;
  return (m.transmission?.weight ?? 0) > 0 || (m.diffuseTransmission?.weight ?? 0) > 0;
}

/** Whether the shape bounds a body through which light travels: KHR_materials_volume. */
export const isSolid = (m: Layered): boolean => isClear(m) && (m.volume?.thickness ?? 0) > 0;

const isTextured = ({ weightTexture, colorTexture }: SpecularLobe): boolean =>
  weightTexture !== undefined || colorTexture !== undefined;

/** Whether what it sends out goes through a coat first. */
export const hasCoat = (m: Layered): boolean => isLayered(m) && (m.clearcoat?.weight ?? 0) > 0;

/** Whether fibres stand on it. */
export const hasSheen = (m: Layered): boolean => isLayered(m) && (m.sheen?.color.some((x) => x > 0) ?? false);

/** Whether its facets are rougher along one direction. */
export const hasGrain = (m: Layered): boolean => isLayered(m) && (m.anisotropy?.strength ?? 0) > 0;

/** Whether its coat is bent by another normal map than the base, or only one of both is. */
export const bendsCoatApart = (m: Layered): boolean =>
  hasCoat(m) && JSON.stringify(m.clearcoat?.normalTexture) !== JSON.stringify(m.normalTexture);
