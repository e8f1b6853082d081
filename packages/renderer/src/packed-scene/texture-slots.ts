/** What materials use textures for: which of their properties, and how the image is meant. */

import { isLayered } from '../scene/layered.ts';
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Mesh } from '../scene/mesh.ts';
import type { Material } from '../scene/scene.ts';
import type { NormalTextureUse, TextureUse } from '../scene/textures.ts';
import { TEXTURE_SLOTS } from './layout.ts';

/** What a material uses one texture for. `isColor`: its image is sRGB. */
export interface Slot {
  readonly slot: number;
  readonly isColor: boolean;
  readonly use: TextureUse & Pick<NormalTextureUse, 'normalScale'>;
}

/** Those that make a difference to light. That of the image whose alpha is opacity comes first. */
export function slotsOf(material: Material & MaterialLayers): readonly Slot[] {
  const { baseColorTexture, emissionTexture, metallicRoughnessTexture, normalTexture, unlit = false } = material;
  const { baseColorSlot, emissionSlot, metallicRoughnessSlot, normalSlot } = TEXTURE_SLOTS;
  // An unlit surface is black and sends its base colour out: surface-values.ts.
  if (unlit) return slot(baseColorTexture, emissionSlot, true);
  const glows = material.emission.some((x) => x > 0);
  return [
    ...slot(baseColorTexture, baseColorSlot, true),
    ...slot(glows ? emissionTexture : undefined, emissionSlot, true),
    ...slot(metallicRoughnessTexture, metallicRoughnessSlot, false),
    ...slot(normalTexture, normalSlot, false),
    ...(isLayered(material) ? layerSlots(material) : []),
  ];
}

/** How thick a volume is, rays find out. */
function layerSlots(material: Material & MaterialLayers): Slot[] {
  const { specularLobe, transmission, diffuseTransmission, clearcoat, sheen, anisotropy, iridescence } = material;
  return [
    ...slot(specularLobe?.weightTexture, TEXTURE_SLOTS.specularWeightSlot, false),
    ...slot(specularLobe?.colorTexture, TEXTURE_SLOTS.specularColorSlot, true),
    ...slot(transmission?.weightTexture, TEXTURE_SLOTS.transmissionSlot, false),
    ...slot(diffuseTransmission?.weightTexture, TEXTURE_SLOTS.beyondSlot, false),
    ...slot(diffuseTransmission?.colorTexture, TEXTURE_SLOTS.beyondColorSlot, true),
    ...slot(clearcoat?.weightTexture, TEXTURE_SLOTS.coatSlot, false),
    ...slot(clearcoat?.roughnessTexture, TEXTURE_SLOTS.coatRoughnessSlot, false),
    ...slot(clearcoat?.normalTexture, TEXTURE_SLOTS.coatNormalSlot, false),
    ...slot(sheen?.colorTexture, TEXTURE_SLOTS.sheenColorSlot, true),
    ...slot(sheen?.roughnessTexture, TEXTURE_SLOTS.sheenRoughnessSlot, false),
    ...slot(anisotropy?.texture, TEXTURE_SLOTS.anisotropySlot, false),
    ...slot(iridescence?.weightTexture, TEXTURE_SLOTS.filmSlot, false),
    ...slot(iridescence?.thicknessTexture, TEXTURE_SLOTS.filmThicknessSlot, false),
  ];
}

const slot = (use: TextureUse | undefined, number: number, isColor: boolean): Slot[] =>
  use ? [{ slot: number, isColor, use }] : [];

/** Whether the material may not be there at some places of this mesh, going by opacity. */
export function mayBeMissing(material: Material & MaterialLayers, mesh: Mesh | undefined): boolean {
  const { alphaMode = 'opaque', opacity = 1, alphaCutoff = 0.5, baseColorTexture } = material;
  if (alphaMode === 'opaque') return false;
  const least = alphaMode === 'mask' ? alphaCutoff : 1;
  return opacity < least || baseColorTexture !== undefined || mesh?.colors !== undefined;
}

/**
 * Whether triangles of this material are not there from behind, as glTF has it for those that are not double-sided. Where light goes into
 * the material the back is where it comes out again.
 */
export const isOneSided = ({
  doubleSided = true,
  transmission,
  diffuseTransmission,
}: Material & MaterialLayers): boolean =>
  !doubleSided &&
  !(transmission && transmission.weight > 0) &&
  !(diffuseTransmission && diffuseTransmission.weight > 0);
