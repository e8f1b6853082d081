/**
 * KHR_materials_pbrSpecularGlossiness, archived, and in many old files: a diffuse colour, the colour F₀ of what is reflected, and how glossy it
 * is. Such a material is a dielectric whose specular lobe has this F₀: 0.04 · color (KHR_materials_specular). Where an image says how glossy
 * it is, another image is made of it that says how rough; and one of the diffuse colours, dimmed by what is reflected.
 */
import type { Color, Material } from '../scene/scene.ts';
import type { ImagePixels } from '../scene/textures.ts';
import type { FieldReader } from './materials.ts';
import type { Making } from './textures.ts';

/** What a dielectric of index 1.5 reflects of light that comes straight. */
const PLAIN_F0 = 0.04;
type Read = Pick<Material, 'baseColor' | 'metallic' | 'roughness' | 'specularLobe'> & Partial<Material>;

export function specularGlossiness(from: FieldReader): Read {
  const baseColor = from.color('diffuseFactor', [1, 1, 1]);
  const opacity = from.alpha('diffuseFactor');
  const specular = from.color('specularFactor', [1, 1, 1]);
  const glossiness = from.number('glossinessFactor', 1, 0, 1);
  const toColor = specular.map((f) => f / PLAIN_F0) as unknown as Color;
  const shared = { metallic: 0, ior: 1.5, ...(opacity !== 1 && { opacity }) };
  const colored = from.texture('specularGlossinessTexture', 'colorTexture');
  if (!colored.colorTexture) {
    const dimmed = baseColor.map((x) => x * (1 - Math.max(...specular))) as unknown as Color;
    return {
      ...shared,
      baseColor: dimmed,
      roughness: 1 - glossiness,
      specularLobe: { weight: 1, color: toColor },
      ...from.texture('diffuseTexture', 'baseColorTexture'),
    };
  }
  const rough: Making = { word: 'roughness', key: [glossiness], make: (gloss) => roughnessImage(gloss, glossiness) };
  const dimmed: Making = {
    word: 'diffuse',
    key: specular,
    make: (gloss, colors) => dimmedImage(gloss, specular, colors),
  };
  return {
    ...shared,
    baseColor,
    roughness: 1,
    specularLobe: { weight: 1, color: toColor, ...colored },
    ...from.madeTexture('specularGlossinessTexture', 'metallicRoughnessTexture', rough),
    ...(from.liesAlike('specularGlossinessTexture', 'diffuseTexture')
      ? from.madeTexture('specularGlossinessTexture', 'baseColorTexture', dimmed, 'diffuseTexture')
      : undimmed(from)),
  };
}

/** Two images that lie on the mesh in different ways make no third. */
function undimmed(from: FieldReader) {
  from.tell(
    'diffuseTexture',
    "The diffuse texture of a specular-glossiness material lies otherwise than the texture of what is reflected, and is dimmed by Fresnel's term alone.",
  );
  return from.texture('diffuseTexture', 'baseColorTexture');
}

const like = ({ width, height }: ImagePixels, rgba: Uint8Array): ImagePixels => ({ width, height, rgba });

/** Glossiness in alpha → roughness in green, metal nowhere. */
export function roughnessImage(gloss: ImagePixels, glossiness: number): ImagePixels {
  const rgba = new Uint8Array(gloss.rgba.length);
  for (let at = 0; at < rgba.length; at += 4) {
    rgba[at + 1] = Math.round(255 - glossiness * gloss.rgba[at + 3]!);
    rgba[at + 3] = 255;
  }
  return like(gloss, rgba);
}

/** IEC 61966-2-1. */
const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => {
  const c = byte / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});
const byteOf = (c: number): number => Math.round(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055));
const STEPS = 2 ** 16 - 1;
let srgb: Uint8Array | null = null;

/** c_diff = diffuse · (1 − max(specular)), in sRGB; as large as the larger of both images. Without `colors` of white. */
export function dimmedImage(gloss: ImagePixels, specular: Color, colors: ImagePixels = gloss): ImagePixels {
  srgb ??= Uint8Array.from({ length: STEPS + 1 }, (_, step) => byteOf(step / STEPS));
  const isWhite = colors === gloss;
  const [width, height] = [Math.max(gloss.width, colors.width), Math.max(gloss.height, colors.height)];
  const rgba = new Uint8Array(4 * width * height);
  const place = (image: ImagePixels, x: number, y: number): number =>
    4 * (Math.floor((y * image.height) / height) * image.width + Math.floor((x * image.width) / width));
  for (let y = 0, at = 0; y < height; y++)
    for (let x = 0; x < width; x++, at += 4) {
      const [s, d] = [place(gloss, x, y), place(colors, x, y)];
      let most = 0;
      for (let c = 0; c < 3; c++) most = Math.max(most, specular[c as 0 | 1 | 2] * LINEAR[gloss.rgba[s + c]!]!);
      for (let c = 0; c < 3; c++) {
        const full = isWhite ? 1 : LINEAR[colors.rgba[d + c]!]!;
        rgba[at + c] = srgb[Math.round(STEPS * full * (1 - most))]!;
      }
      rgba[at + 3] = isWhite ? 255 : colors.rgba[d + 3]!;
    }
  return { width, height, rgba };
}
