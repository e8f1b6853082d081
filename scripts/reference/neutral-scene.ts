/**
 * The form of a "neutral scene": one plain JSON file that several renderers read, so that their pictures can be compared.
 * World, camera, colours and units are as in our own scene file. Opaque materials are two-sided; dielectrics are solid
 * bodies in vacuum; lights are black where light falls on them, and stand in the way of other light.
 */
import * as v from 'valibot';

const real = v.pipe(v.number(), v.finite());
const triple = v.strictTuple([real, real, real]);
const row = v.strictTuple([real, real, real, real]);
/** Rows of a 4 × 4 matrix for column vectors. */
const transform = v.optional(v.strictTuple([row, row, row, row]));
const material = v.string();

/** Smith's masking of two directions: `separable` G₁(ωi) G₁(ωo), or `height_correlated` 1 / (1 + Λ(ωi) + Λ(ωo)). */
const masking = v.picklist(['separable', 'height_correlated']);

const diffuse = v.strictObject({ type: v.literal('diffuse'), albedo: triple });
const mirror = v.strictObject({ type: v.literal('mirror'), reflectance: triple });
/** `alpha` is GGX's own width everywhere, not a roughness. */
const roughConductor = v.strictObject({
  type: v.literal('rough_conductor'),
  distribution: v.picklist(['ggx', 'beckmann']),
  alpha: real,
  masking,
  reflectance: v.optional(triple),
  f0: v.optional(triple),
  eta: v.optional(triple),
  k: v.optional(triple),
});
const roughDielectric = v.strictObject({ type: v.literal('rough_dielectric'), ior: real, alpha: real, masking });
const gltf = v.strictObject({
  type: v.literal('gltf_metallic_roughness'),
  base_color: triple,
  metallic: real,
  roughness: real,
  form: v.picklist(['mix', 'simplified']),
});

const simpleMaterials = [
  diffuse,
  mirror,
  roughConductor,
  v.strictObject({ type: v.literal('dielectric'), ior: real }),
  roughDielectric,
  gltf,
  v.looseObject({ type: v.literal('mitsuba_principled') }),
] as const;
const simpleMaterial = v.variant('type', [...simpleMaterials]);
/** weight · b + (1 − weight) · a */
const blend = v.strictObject({ type: v.literal('blend'), weight: real, a: simpleMaterial, b: simpleMaterial });
const anyMaterial = v.variant('type', [...simpleMaterials, blend]);

/** A PLY file, by its name from the JSON's folder on; `smooth`: shaded by its vertices' normals, else flat. */
const meshFile = { file: v.string(), smooth: v.boolean() };
const primitive = v.variant('type', [
  v.strictObject({ type: v.literal('sphere'), center: triple, radius: real, material, transform }),
  v.strictObject({ type: v.literal('box'), min: triple, max: triple, material, transform }),
  v.strictObject({ type: v.literal('quad'), corner: triple, u: triple, v: triple, material, transform }),
  v.strictObject({ type: v.literal('mesh'), ...meshFile, material, transform }),
  v.strictObject({
    type: v.literal('instances'),
    meshes: v.record(v.string(), v.strictObject(meshFile)),
    items: v.array(v.strictObject({ mesh: v.string(), material, transform })),
  }),
]);

const light = v.variant('type', [
  v.strictObject({ type: v.literal('sphere'), center: triple, radius: real, radiance: triple }),
  v.strictObject({ type: v.literal('quad'), corner: triple, u: triple, v: triple, radiance: triple }),
  v.strictObject({ type: v.literal('point'), position: triple, intensity: triple }),
  v.strictObject({ type: v.literal('directional'), direction: triple, irradiance: triple }),
  v.strictObject({ type: v.literal('constant'), radiance: triple }),
  /** Latitude-longitude, as the sky's image of ours; the file's name counts from the JSON's folder. */
  v.strictObject({ type: v.literal('envmap'), file: v.string(), scale: v.optional(real, 1) }),
]);

export const neutralScene = v.strictObject({
  format: v.literal('neutral-scene'),
  version: v.literal(1),
  name: v.string(),
  description: v.optional(v.string(), ''),
  /** For people. */
  notes: v.optional(v.unknown()),
  image: v.strictObject({
    width: v.pipe(real, v.integer(), v.minValue(1)),
    height: v.pipe(real, v.integer(), v.minValue(1)),
    filter: v.string(),
    /** What the picture is multiplied by for people to look at. */
    view_exposure: v.pipe(real, v.gtValue(0)),
  }),
  max_depth: real,
  camera: v.strictObject({ eye: triple, target: triple, up: triple, vfov_deg: real, aspect: real }),
  materials: v.record(v.string(), anyMaterial),
  primitives: v.array(primitive),
  lights: v.array(light),
});

export type NeutralScene = v.InferOutput<typeof neutralScene>;
export type NeutralMaterial = v.InferOutput<typeof anyMaterial>;
export type NeutralPrimitive = v.InferOutput<typeof primitive>;
export type NeutralLight = v.InferOutput<typeof light>;
export type Matrix = NonNullable<v.InferOutput<typeof transform>>;
export type Triple = v.InferOutput<typeof triple>;
