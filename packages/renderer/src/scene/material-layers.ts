/**
 * What a material of type `metallicRoughness` may have beyond its base, after glTF 2.0 and the Khronos extensions to it. All of it is
 * optional plain data; a group that is left out is not there. How the groups lie on each other is glTF's: clearcoat over sheen over the
 * base, in which transmission and diffuse transmission replace parts of the diffuse body (KHR_materials_clearcoat, "Layering"; the texts
 * are at github.com/KhronosGroup/glTF/tree/main/extensions/2.0/Khronos).
 *
 * A texture multiplies the number or colour beside which it stands; the letters say which of its channels.
 */
import type { NormalTextureUse, TextureUse } from './textures.ts';

type Color = readonly [r: number, g: number, b: number];

export interface MaterialLayers {
  /** RGB (sRGB) times `baseColor`, A times `opacity`. */
  readonly baseColorTexture?: TextureUse;
  /** G times `roughness`, B times `metallic`. */
  readonly metallicRoughnessTexture?: TextureUse;
  readonly normalTexture?: NormalTextureUse;
  /** RGB (sRGB) times `emission`. */
  readonly emissionTexture?: TextureUse;
  /** Kept for who writes the scene again. Paths find out for themselves how much light reaches a corner. */
  readonly occlusionTexture?: TextureUse;

  /** Share of light that the surface takes part in; the rest goes straight on. Counts unless `alphaMode` is `opaque`. Default: 1. */
  readonly opacity?: number;
  /** glTF 2.0, 3.9.4. `mask`: there where opacity ≥ `alphaCutoff`, else not. `blend`: there by chance, as often as `opacity` says. Default: `opaque`. */
  readonly alphaMode?: 'opaque' | 'mask' | 'blend';
  /** Default: 0.5. */
  readonly alphaCutoff?: number;
  /** false: seen from behind it is not there, glTF's own default. Default: true, as all shapes of Mirrorball. */
  readonly doubleSided?: boolean;
  /** KHR_materials_unlit: the eye gets `baseColor` whatever the light, and nothing else counts. Default: false. */
  readonly unlit?: boolean;
  /** Factor on `emission` (KHR_materials_emissive_strength), 0 or more. Default: 1. */
  readonly emissionStrength?: number;
  /** KHR_materials_dispersion: 20 / Abbe number; the index runs over n ∓ (ior − 1) · 0.025 · dispersion for red and blue. Default: 0. */
  readonly dispersion?: number;

  readonly specularLobe?: SpecularLobe;
  readonly transmission?: Transmission;
  readonly volume?: Volume;
  readonly diffuseTransmission?: DiffuseTransmission;
  readonly clearcoat?: Clearcoat;
  readonly sheen?: Sheen;
  readonly anisotropy?: Anisotropy;
  readonly iridescence?: Iridescence;
}

/**
 * KHR_materials_specular: how much what is no metal reflects. F₀ = min(((ior − 1) / (ior + 1))² · color, 1) · weight, F₉₀ = weight.
 * (`Material.specular` is another thing, the highlight of the classic integrator.)
 */
export interface SpecularLobe {
  /** Default of the file format: 1. Texture: A. */
  readonly weight: number;
  /** May exceed 1. Default of the file format: white. Texture: RGB, sRGB. */
  readonly color: Color;
  readonly weightTexture?: TextureUse;
  readonly colorTexture?: TextureUse;
}

/**
 * KHR_materials_transmission: this share of the diffuse body is a rough refracting boundary instead, tinted by `baseColor`. Without
 * `volume` the wall is thin: light goes on without being bent.
 */
export interface Transmission {
  /** 0 … 1. Texture: R. */
  readonly weight: number;
  readonly weightTexture?: TextureUse;
}

/**
 * KHR_materials_volume: the mesh bounds a solid of `Material.ior`, in which light fades by `attenuationColor` and `attenuationDistance`
 * of the material (Beer and Lambert; glTF's endless distance is 0 here, as everywhere in Mirrorball).
 */
export interface Volume {
  /** 0: thin walls after all. Above 0: a solid; how thick, rays find out. Texture: G. */
  readonly thickness: number;
  readonly thicknessTexture?: TextureUse;
}

/** KHR_materials_diffuse_transmission: this share of the diffuse light leaves on the other side, Lambert's cosine there, times `color`. */
export interface DiffuseTransmission {
  /** 0 … 1. Texture: A. */
  readonly weight: number;
  /** Texture: RGB, sRGB. */
  readonly color: Color;
  readonly weightTexture?: TextureUse;
  readonly colorTexture?: TextureUse;
}

/** KHR_materials_clearcoat: a GGX layer of index 1.5 (F₀ 0.04) on top; what it reflects does not reach what lies under it. */
export interface Clearcoat {
  /** 0 … 1. Texture: R. */
  readonly weight: number;
  /** α = roughness². Texture: G. */
  readonly roughness: number;
  readonly weightTexture?: TextureUse;
  readonly roughnessTexture?: TextureUse;
  /** The coat has the mesh's own normals unless it has this; the base's normal map does not bend it. */
  readonly normalTexture?: NormalTextureUse;
}

/**
 * KHR_materials_sheen: cloth. D = (2 + 1/α) sin^(1/α) θ / 2π with α = roughness² (Estevez and Kulla 2017), Charlie's Λ; the base under it
 * is scaled by 1 − max(color) · max(E(o), E(i)).
 */
export interface Sheen {
  /** Texture: RGB, sRGB. */
  readonly color: Color;
  /** Texture: A. */
  readonly roughness: number;
  readonly colorTexture?: TextureUse;
  readonly roughnessTexture?: TextureUse;
}

/** KHR_materials_anisotropy: α along the direction is lerp(roughness², 1, strength²), across it roughness². */
export interface Anisotropy {
  /** 0 … 1. Texture: B. */
  readonly strength: number;
  /** Degrees from the tangent counter-clockwise. Texture: RG, a direction as in normal maps, which is turned by this. */
  readonly rotation: number;
  readonly texture?: TextureUse;
}

/** KHR_materials_iridescence: a thin film over the base; its Fresnel term after Belcour and Barla 2017. */
export interface Iridescence {
  /** 0 … 1. Texture: R. */
  readonly weight: number;
  /** Index of the film, 1 or more. */
  readonly ior: number;
  /** Nanometres; where there is a texture, its G runs from minimum to maximum, else it is the maximum. */
  readonly thicknessMinimum: number;
  readonly thicknessMaximum: number;
  readonly weightTexture?: TextureUse;
  readonly thicknessTexture?: TextureUse;
}

/** What a material has where it says nothing. */
export const LAYER_DEFAULTS = {
  opacity: 1,
  alphaMode: 'opaque',
  alphaCutoff: 0.5,
  doubleSided: true,
  unlit: false,
  emissionStrength: 1,
  dispersion: 0,
} as const satisfies Partial<MaterialLayers>;
