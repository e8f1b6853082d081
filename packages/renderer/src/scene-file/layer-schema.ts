import * as v from 'valibot';
import { normalTextureUse, textureUse } from './texture-schema.ts';
import { choice, color, flag, number, object, share } from './values.ts';

/** What materials may have beyond their base, `MaterialLayers`. A group that is written down is there, so its weight is 1 by default. */

const weight = v.optional(share('the weight'), 1);
const white = v.optional(color('the colour', 1e6), [1, 1, 1]);
const group = <const Entries extends v.ObjectEntries>(what: string, entries: Entries) =>
  v.optional(object(`${what}: an object`, entries));
const thickness = (what: string) => number(`${what}, nanometres`, 0, 1e6);

export const layers = {
  baseColorTexture: textureUse,
  metallicRoughnessTexture: textureUse,
  normalTexture: normalTextureUse,
  emissionTexture: textureUse,
  occlusionTexture: textureUse,
  opacity: v.optional(share('how much of the light the surface takes part in')),
  alphaMode: v.optional(choice('what opacity means', ['opaque', 'mask', 'blend'])),
  alphaCutoff: v.optional(number('where a mask begins', 0, 1e6)),
  doubleSided: v.optional(flag('whether it is there when seen from behind')),
  unlit: v.optional(flag('whether it shows its colour whatever the light')),
  emissionStrength: v.optional(number('the factor on the emission', 0, 1e6)),
  dispersion: v.optional(number('the dispersion, 20 / Abbe number', 0, 1e3)),
  specularLobe: group('the reflection of what is no metal', {
    weight,
    color: white,
    weightTexture: textureUse,
    colorTexture: textureUse,
  }),
  transmission: group('light that goes through', { weight, weightTexture: textureUse }),
  volume: group('what lies inside', {
    thickness: v.optional(number('the thickness in metres, 0 = thin walls', 0, 1e9), 1),
    thicknessTexture: textureUse,
  }),
  diffuseTransmission: group('scattered light that goes through', {
    weight,
    color: white,
    weightTexture: textureUse,
    colorTexture: textureUse,
  }),
  clearcoat: group('a clear coat', {
    weight,
    roughness: v.optional(share('how rough it is'), 0),
    weightTexture: textureUse,
    roughnessTexture: textureUse,
    normalTexture: normalTextureUse,
  }),
  sheen: group('the sheen of cloth', {
    color: white,
    roughness: v.optional(share('how rough it is'), 0.5),
    colorTexture: textureUse,
    roughnessTexture: textureUse,
  }),
  anisotropy: group('highlights drawn out one way', {
    strength: v.optional(share('how much'), 1),
    rotation: v.optional(number('degrees from the tangent', -1e6, 1e6), 0),
    texture: textureUse,
  }),
  iridescence: group('a thin film', {
    weight,
    ior: v.optional(number('the index of the film', 1, 10), 1.3),
    thicknessMinimum: v.optional(thickness('the least thickness'), 100),
    thicknessMaximum: v.optional(thickness('the greatest thickness'), 400),
    weightTexture: textureUse,
    thicknessTexture: textureUse,
  }),
};
