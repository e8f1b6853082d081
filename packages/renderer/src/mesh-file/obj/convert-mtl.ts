/**
 * An MTL material → one of ours, as a scene file has it, defaults left out. The two models differ; docs/mesh-files.md tells what becomes
 * of what.
 */
import type { Color, Material } from '../../scene/scene.ts';
import type { MtlMaterial, NumberWord, Rgb } from './mtl-statements.ts';
import { type MtlTexture, type TextureWord, textureUse } from './mtl-textures.ts';

export interface ConvertedMaterial {
  readonly material: Partial<Material>;
  /** Words of the file that nothing was made of. */
  readonly unused: readonly string[];
}

/** Ray traced transparency: 4 and 9 glass, 6 and 7 with refraction. */
const GLASS: readonly number[] = [4, 6, 7, 9];
/** 3: ray traced reflection, of the specular colour. */
const MIRROR = 3;
/** From 2 on there is a highlight. */
const HIGHLIGHT = 2;
/** Less of it than this is no surface but glass. */
const TRANSPARENT = 0.1;

const BRIGHTEST = 1e6;
const between = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
const shares = ([r, g, b]: Rgb): Color => [between(r, 0, 1), between(g, 0, 1), between(b, 0, 1)];
const isGrey = ([r, g, b]: Rgb): boolean => r === g && g === b;

/** The exponent of a highlight is 2 / roughness⁴ − 2 in docs/classic.md, here the other way round. */
const roughnessOfExponent = (exponent: number): number => (2 / (Math.max(exponent, 0) + 2)) ** (1 / 4);

/** `folder`: of the file, with a "/" at its end; names of textures count from there. */
export function convertMtl(mtl: MtlMaterial, folder = ''): ConvertedMaterial {
  const source = new Source(mtl);
  const illumination = source.number('illum') ?? HIGHLIGHT;
  const opacity = source.number('d') ?? 1;
  const isGlass = GLASS.includes(illumination) || opacity <= TRANSPARENT;
  // To some programs it is transparency, to others opacity; between 0 and 1 there is something to tell.
  const tr = source.number('Tr') ?? 0;
  if (!isGlass && tr > 0 && tr < 1) source.leave('Tr');
  const shining = light(source, isGlass ? null : folder);
  const material = isGlass ? glass(source) : covered(surface(source, illumination), source, opacity, folder);
  return { material: { ...material, ...shining }, unused: source.unused() };
}

/** `folder`: null where a texture counts for nothing. Who names a picture of light and no colour wants it as it is. */
function light(source: Source, folder: string | null): Partial<Material> {
  const picture = folder === null ? undefined : source.texture('map_Ke');
  const given = source.color('Ke')?.map((x) => between(x, 0, BRIGHTEST)) as Rgb | undefined;
  const emission = given ?? (picture ? ([1, 1, 1] as const) : undefined);
  if (!emission || Math.max(...emission) <= 0) return {};
  if (!picture) return { emission };
  return { type: 'metallicRoughness', emission, emissionTexture: textureUse(folder!, picture) };
}

/** With opacity and textures. Only glTF's material has these; a matte one is a rough one then. */
function covered(plain: Partial<Material>, source: Source, opacity: number, folder: string): Partial<Material> {
  const [picture, holes, bumps] = [source.texture('map_Kd'), source.texture('map_d'), source.texture('norm')];
  // Of a picture for opacity alone nothing is made; where it is that of the colours, its alpha is meant.
  const hasAlpha = picture !== undefined && holes?.file === picture.file;
  if (holes && !hasAlpha) source.leave('map_d');
  const seen = opacity < 1 || hasAlpha ? { alphaMode: 'blend' as const, opacity: between(opacity, 0, 1) } : {};
  if (!picture && !bumps) return { ...plain, ...seen };
  return {
    roughness: 1,
    ...plain,
    type: 'metallicRoughness',
    ...seen,
    ...(picture && { baseColorTexture: textureUse(folder, picture) }),
    ...(bumps && { normalTexture: { ...textureUse(folder, bumps), normalScale: bumps.strength } }),
  };
}

/** Keeps account of what was asked for. */
class Source {
  readonly #mtl: MtlMaterial;
  readonly #left: Set<string>;

  constructor(mtl: MtlMaterial) {
    this.#mtl = mtl;
    this.#left = new Set([...mtl.colors.keys(), ...mtl.numbers.keys(), ...mtl.textures.keys(), ...mtl.others]);
    // Light from everywhere, which an integrator works out or a light of a scene says.
    this.#left.delete('Ka');
  }
  color(word: 'Kd' | 'Ks' | 'Ke' | 'Tf'): Rgb | undefined {
    this.#left.delete(word);
    return this.#mtl.colors.get(word);
  }
  texture(word: TextureWord): MtlTexture | undefined {
    const texture = this.#mtl.textures.get(word);
    if (texture) this.#left.delete(word);
    for (const option of texture?.ignored ?? []) this.leave(`${word} ${option}`);
    return texture;
  }
  number(word: NumberWord): number | undefined {
    this.#left.delete(word);
    return this.#mtl.numbers.get(word);
  }
  /** Says that nothing was made of it after all. */
  leave(word: string): void {
    this.#left.add(word);
  }
  unused(): string[] {
    return [...this.#left];
  }
}

function glass(source: Source): Partial<Material> {
  const tint = source.color('Tf');
  const ior = source.number('Ni');
  const roughness = source.number('Pr');
  // What colours a surface colours no glass; and a highlight is what a smooth body has by itself.
  source.color('Kd');
  source.color('Ks');
  source.number('Ns');
  source.number('Pm');
  return {
    type: 'dielectric',
    baseColor: tint && Math.max(...tint) > 0 ? shares(tint) : [1, 1, 1],
    ...(ior === undefined ? {} : { ior: between(ior, 1, 4) }),
    ...(roughness === undefined ? {} : { roughness: between(roughness, 0, 1) }),
  };
}

function surface(source: Source, illumination: number): Partial<Material> {
  const baseColor = shares(source.color('Kd') ?? [0.8, 0.8, 0.8]);
  const [metallic, given, exponent] = [source.number('Pm'), source.number('Pr'), source.number('Ns')];
  const highlight = source.color('Ks') ?? [0, 0, 0];
  const strength = between(Math.max(...highlight), 0, 1);
  // An index of refraction says nothing of an opaque surface here.
  source.number('Ni');
  if (strength > 0 && !isGrey(highlight)) source.leave('Ks');
  const roughness = given ?? (exponent === undefined ? undefined : roughnessOfExponent(exponent));
  const rough = roughness === undefined ? {} : { roughness: between(roughness, 0, 1) };
  if (metallic !== undefined || given !== undefined)
    return { type: 'metallicRoughness', baseColor, metallic: between(metallic ?? 0, 0, 1), ...rough };
  if (illumination === MIRROR && strength > 0) return { baseColor, reflectivity: strength, ...rough };
  // A plastic's highlight; how strong it is only the classic integrator can be told.
  if (illumination >= HIGHLIGHT && strength > 0)
    return { type: 'metallicRoughness', baseColor, specular: strength, ...rough };
  return { baseColor };
}
