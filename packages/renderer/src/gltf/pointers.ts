/** KHR_animation_pointer: what of a scene stands for what of a file (the object model, glTF's repository, specification/2.0/ObjectModel.adoc). */

/** Some of the numbers of a value, times a factor, go to a property. */
export interface PointerTarget {
  /** From the thing on: "baseColor", or "clearcoat/weight". */
  readonly to: string;
  /** Which numbers of the file's value; left out: all. */
  readonly from?: readonly [start: number, count: number];
  readonly factor?: number;
}

const TURN = 180 / Math.PI;
const one = (to: string, factor?: number): readonly PointerTarget[] => [{ to, ...(factor && { factor }) }];

export const MATERIAL_FIELDS: Readonly<Record<string, readonly PointerTarget[]>> = {
  'pbrMetallicRoughness/baseColorFactor': [
    { to: 'baseColor', from: [0, 3] },
    { to: 'opacity', from: [3, 1] },
  ],
  'pbrMetallicRoughness/metallicFactor': one('metallic'),
  'pbrMetallicRoughness/roughnessFactor': one('roughness'),
  'normalTexture/scale': one('normalTexture/normalScale'),
  emissiveFactor: one('emission'),
  alphaCutoff: one('alphaCutoff'),
  ...extension('KHR_materials_emissive_strength', { emissiveStrength: 'emissionStrength' }),
  ...extension('KHR_materials_ior', { ior: 'ior' }),
  ...extension('KHR_materials_dispersion', { dispersion: 'dispersion' }),
  ...extension('KHR_materials_specular', {
    specularFactor: 'specularLobe/weight',
    specularColorFactor: 'specularLobe/color',
  }),
  ...extension('KHR_materials_transmission', { transmissionFactor: 'transmission/weight' }),
  ...extension('KHR_materials_volume', {
    thicknessFactor: 'volume/thickness',
    attenuationDistance: 'attenuationDistance',
    attenuationColor: 'attenuationColor',
  }),
  ...extension('KHR_materials_diffuse_transmission', {
    diffuseTransmissionFactor: 'diffuseTransmission/weight',
    diffuseTransmissionColorFactor: 'diffuseTransmission/color',
  }),
  ...extension('KHR_materials_clearcoat', {
    clearcoatFactor: 'clearcoat/weight',
    clearcoatRoughnessFactor: 'clearcoat/roughness',
    'clearcoatNormalTexture/scale': 'clearcoat/normalTexture/normalScale',
  }),
  ...extension('KHR_materials_sheen', { sheenColorFactor: 'sheen/color', sheenRoughnessFactor: 'sheen/roughness' }),
  ...extension('KHR_materials_anisotropy', { anisotropyStrength: 'anisotropy/strength' }),
  'extensions/KHR_materials_anisotropy/anisotropyRotation': one('anisotropy/rotation', TURN),
  ...extension('KHR_materials_iridescence', {
    iridescenceFactor: 'iridescence/weight',
    iridescenceIor: 'iridescence/ior',
    iridescenceThicknessMinimum: 'iridescence/thicknessMinimum',
    iridescenceThicknessMaximum: 'iridescence/thicknessMaximum',
  }),
};

function extension(name: string, fields: Readonly<Record<string, string>>): Record<string, readonly PointerTarget[]> {
  return Object.fromEntries(Object.entries(fields).map(([field, to]) => [`extensions/${name}/${field}`, one(to)]));
}

/** Where textures stand in a file and in a material of ours. Both tables serve the way out too (scene-export/glb/). */
export const TEXTURE_FIELDS: Readonly<Record<string, string>> = {
  'pbrMetallicRoughness/baseColorTexture': 'baseColorTexture',
  'pbrMetallicRoughness/metallicRoughnessTexture': 'metallicRoughnessTexture',
  normalTexture: 'normalTexture',
  emissiveTexture: 'emissionTexture',
  occlusionTexture: 'occlusionTexture',
  'extensions/KHR_materials_specular/specularTexture': 'specularLobe/weightTexture',
  'extensions/KHR_materials_specular/specularColorTexture': 'specularLobe/colorTexture',
  'extensions/KHR_materials_transmission/transmissionTexture': 'transmission/weightTexture',
  'extensions/KHR_materials_volume/thicknessTexture': 'volume/thicknessTexture',
  'extensions/KHR_materials_diffuse_transmission/diffuseTransmissionTexture': 'diffuseTransmission/weightTexture',
  'extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorTexture': 'diffuseTransmission/colorTexture',
  'extensions/KHR_materials_clearcoat/clearcoatTexture': 'clearcoat/weightTexture',
  'extensions/KHR_materials_clearcoat/clearcoatRoughnessTexture': 'clearcoat/roughnessTexture',
  'extensions/KHR_materials_clearcoat/clearcoatNormalTexture': 'clearcoat/normalTexture',
  'extensions/KHR_materials_sheen/sheenColorTexture': 'sheen/colorTexture',
  'extensions/KHR_materials_sheen/sheenRoughnessTexture': 'sheen/roughnessTexture',
  'extensions/KHR_materials_anisotropy/anisotropyTexture': 'anisotropy/texture',
  'extensions/KHR_materials_iridescence/iridescenceTexture': 'iridescence/weightTexture',
  'extensions/KHR_materials_iridescence/iridescenceThicknessTexture': 'iridescence/thicknessTexture',
};

/** Of a pointer into a material, behind "/materials/0/". */
export function materialTargets(rest: string): readonly PointerTarget[] | null {
  if (Object.hasOwn(MATERIAL_FIELDS, rest)) return MATERIAL_FIELDS[rest]!;
  const transform = /^(.+)\/extensions\/KHR_texture_transform\/(offset|rotation|scale)$/.exec(rest);
  const use = transform && Object.hasOwn(TEXTURE_FIELDS, transform[1]!) ? TEXTURE_FIELDS[transform[1]!]! : null;
  return use === null ? null : one(`${use}/${transform![2]}`, transform![2] === 'rotation' ? TURN : undefined);
}

/** Of a pointer into a camera, behind "/cameras/0/". */
export function cameraTargets(rest: string): readonly PointerTarget[] | null {
  if (rest === 'perspective/yfov') return one('verticalFov', TURN);
  return rest === 'orthographic/ymag' ? one('viewHeight', 2) : null;
}

/** Of a pointer into a light of KHR_lights_punctual, behind "/lights/0/". */
export function lightTargets(rest: string, type: string): readonly PointerTarget[] | null {
  if (rest === 'color') return one('color');
  if (rest === 'intensity') return one(type === 'directional' ? 'irradiance' : 'intensity');
  if (rest === 'spot/innerConeAngle') return one('innerAngle', TURN);
  return rest === 'spot/outerConeAngle' ? one('outerAngle', TURN) : null;
}

/** What stands for a property that a thing says nothing of, so that it can move. */
export const DEFAULTS: Readonly<Record<string, number | readonly number[]>> = {
  translation: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  scale: [1, 1, 1],
  opacity: 1,
  alphaCutoff: 0.5,
  normalScale: 1,
};
/** Of uses of textures, whose rotation is an angle. */
export const USE_DEFAULTS: Readonly<Record<string, number | readonly number[]>> = { offset: [0, 0], rotation: 0, scale: [1, 1], normalScale: 1 }; // biome-ignore format: short
