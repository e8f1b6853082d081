/** The JSON of the extensions that are read, by the place where they stand; README.md of each, Khronos' glTF repository. */
import { choice, type Form, flag, index, integer, list, map, number, numbers, object, text } from './form.ts';
import { normalTexture, textureInfo } from './texture-forms.ts';

const extensions = (known: Readonly<Record<string, Form>>): Form => object({}, known);

const meshopt = object(
  {
    buffer: index('buffers'),
    byteLength: integer(1),
    byteStride: integer(1, 256),
    count: integer(1),
    mode: choice('ATTRIBUTES', 'TRIANGLES', 'INDICES'),
  },
  { byteOffset: integer(0), filter: choice('NONE', 'OCTAHEDRAL', 'QUATERNION', 'EXPONENTIAL', 'COLOR') },
);
export const bufferViewExtensions = extensions({ EXT_meshopt_compression: meshopt });

const image = object({ source: index('images') });
export const textureExtensions = extensions({
  EXT_texture_webp: image,
  EXT_texture_avif: image,
  KHR_texture_basisu: object({}, { source: index('images') }),
});

export const materialExtensions = extensions({
  KHR_materials_emissive_strength: object({}, { emissiveStrength: number() }),
  KHR_materials_ior: object({}, { ior: number() }),
  KHR_materials_specular: object(
    {},
    {
      specularFactor: number(),
      specularTexture: textureInfo,
      specularColorFactor: numbers(3),
      specularColorTexture: textureInfo,
    },
  ),
  KHR_materials_transmission: object({}, { transmissionFactor: number(), transmissionTexture: textureInfo }),
  KHR_materials_volume: object(
    {},
    {
      thicknessFactor: number(),
      thicknessTexture: textureInfo,
      attenuationDistance: number(),
      attenuationColor: numbers(3),
    },
  ),
  KHR_materials_clearcoat: object(
    {},
    {
      clearcoatFactor: number(),
      clearcoatTexture: textureInfo,
      clearcoatRoughnessFactor: number(),
      clearcoatRoughnessTexture: textureInfo,
      clearcoatNormalTexture: normalTexture,
    },
  ),
  KHR_materials_pbrSpecularGlossiness: object(
    {},
    {
      diffuseFactor: numbers(4),
      diffuseTexture: textureInfo,
      specularFactor: numbers(3),
      glossinessFactor: number(),
      specularGlossinessTexture: textureInfo,
    },
  ),
  KHR_materials_sheen: object(
    {},
    {
      sheenColorFactor: numbers(3),
      sheenColorTexture: textureInfo,
      sheenRoughnessFactor: number(),
      sheenRoughnessTexture: textureInfo,
    },
  ),
  KHR_materials_anisotropy: object(
    {},
    { anisotropyStrength: number(), anisotropyRotation: number(), anisotropyTexture: textureInfo },
  ),
  KHR_materials_iridescence: object(
    {},
    {
      iridescenceFactor: number(),
      iridescenceTexture: textureInfo,
      iridescenceIor: number(),
      iridescenceThicknessMinimum: number(),
      iridescenceThicknessMaximum: number(),
      iridescenceThicknessTexture: textureInfo,
    },
  ),
  KHR_materials_dispersion: object({}, { dispersion: number() }),
  KHR_materials_diffuse_transmission: object(
    {},
    {
      diffuseTransmissionFactor: number(),
      diffuseTransmissionTexture: textureInfo,
      diffuseTransmissionColorFactor: numbers(3),
      diffuseTransmissionColorTexture: textureInfo,
    },
  ),
  KHR_materials_unlit: object({}),
});

const attributes = map(index('accessors'), 1);
const draco = object({ bufferView: index('bufferViews'), attributes: map(integer(0), 1) });
const mappings = list(object({ material: index('materials'), variants: list(index('variants')) }));
export const primitiveExtensions = extensions({
  KHR_draco_mesh_compression: draco,
  KHR_materials_variants: object({ mappings }),
});
export const meshExtensions = extensions({});

export const nodeExtensions = extensions({
  KHR_lights_punctual: object({ light: index('lights') }),
  EXT_mesh_gpu_instancing: object({ attributes }),
  KHR_node_visibility: object({}, { visible: flag }),
});

const light = object(
  { type: choice('directional', 'point', 'spot') },
  {
    name: text,
    color: numbers(3),
    intensity: number(),
    range: number(),
    spot: object({}, { innerConeAngle: number(), outerConeAngle: number() }),
  },
);
export const rootExtensions = extensions({
  KHR_lights_punctual: object({ lights: list(light) }),
  KHR_materials_variants: object({ variants: list(object({ name: text })) }),
});
