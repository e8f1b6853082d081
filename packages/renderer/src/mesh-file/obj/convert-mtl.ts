/**
 * An MTL material → one of ours, as a scene file has it, defaults left out. The two models differ; docs/mesh-files.md tells what becomes
 * of what.
 */
import type { Color, Material } from '../../scene/scene.ts';
import { type MapNames, mapsOf } from './convert-maps.ts';
import { MtlSource } from './mtl-source.ts';
import type { MtlMaterial, Rgb } from './mtl-statements.ts';

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
const share = (x: number): number => between(x, 0, 1);
const shares = ([r, g, b]: Rgb): Color => [share(r), share(g), share(b)];
const isGrey = ([r, g, b]: Rgb): boolean => r === g && g === b;

/** The exponent of a highlight is 2 / roughness⁴ − 2 in docs/classic.md, here the other way round. */
const roughnessOfExponent = (exponent: number): number => (2 / (Math.max(exponent, 0) + 2)) ** (1 / 4);

export function convertMtl(mtl: MtlMaterial, names: MapNames): ConvertedMaterial {
  const source = new MtlSource(mtl);
  const illumination = source.number('illum') ?? HIGHLIGHT;
  const holes = source.has('map_d');
  const opacity = source.number('d') ?? 1;
  const isGlass = GLASS.includes(illumination) || (opacity <= TRANSPARENT && !holes);
  // To some programs it is transparency, to others opacity; between 0 and 1 there is something to tell.
  const tr = source.number('Tr') ?? 0;
  if (!isGlass && tr > 0 && tr < 1) source.leave('Tr');
  const shining = light(source, isGlass ? null : names);
  const material = isGlass ? glass(source) : covered(surface(source, illumination), source, opacity, illumination, names); // biome-ignore format: one choice
  return { material: { ...material, ...shining }, unused: source.unused() };
}

/** `names`: null where a texture counts for nothing. Who names a picture of light and no colour wants it as it is. */
function light(source: MtlSource, names: MapNames | null): Partial<Material> {
  const picture = names === null ? undefined : source.texture('map_Ke');
  const given = source.color('Ke')?.map((x) => between(x, 0, BRIGHTEST)) as Rgb | undefined;
  const emission = given ?? (picture ? ([1, 1, 1] as const) : undefined);
  if (!emission || Math.max(...emission) <= 0) return {};
  if (!picture) return { emission };
  return { type: 'metallicRoughness', emission, emissionTexture: names!.color(picture) };
}

/** With opacity, layers and textures. Only glTF's material has these; a matte one is a rough one then. */
function covered(
  plain: Partial<Material>,
  source: MtlSource,
  opacity: number,
  illumination: number,
  names: MapNames,
): Partial<Material> {
  const maps = mapsOf(source, plain, illumination >= HIGHLIGHT, names);
  const more = { ...layers(source, plain, maps), ...maps };
  // What opacity lies in the map alone is not made less by a zero beside it.
  const share = opacity > 0 ? between(opacity, 0, 1) : 1;
  const seen = opacity < 1 || maps.alphaMode ? { alphaMode: 'blend' as const, opacity: share } : {};
  if (Object.keys(more).length === 0) return { ...plain, ...seen };
  return { roughness: 1, ...plain, type: 'metallicRoughness', ...more, ...seen };
}

/** The groups of glTF's layers that numbers ask for; `maps` has those with textures. */
function layers(source: MtlSource, plain: Partial<Material>, maps: Partial<Material>): Partial<Material> {
  const [sheen, coat, coatRoughness] = [source.number('Ps') ?? 0, source.number('Pc') ?? 0, source.number('Pcr') ?? 0];
  const [aniso, turn] = [source.number('aniso') ?? 0, source.number('anisor') ?? 0];
  // Without textures nothing else would show a strength along or across: below 0 it is drawn out the other way.
  const rotation = between(turn, -1000, 1000) * 360 + (aniso < 0 ? 90 : 0);
  const white = share(sheen);
  return {
    ...(sheen > 0 && !maps.sheen && { sheen: { color: [white, white, white] as Color, roughness: plain.roughness ?? 0.5 } }), // biome-ignore format: one group
    ...(coat > 0 && !maps.clearcoat && { clearcoat: { weight: share(coat), roughness: share(coatRoughness) } }),
    ...(aniso !== 0 && { anisotropy: { strength: share(Math.abs(aniso)), rotation } }),
  };
}

function glass(source: MtlSource): Partial<Material> {
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
    ...(roughness === undefined ? {} : { roughness: share(roughness) }),
  };
}

function surface(source: MtlSource, illumination: number): Partial<Material> {
  const baseColor = shares(source.color('Kd') ?? [0.8, 0.8, 0.8]);
  const [metallic, given, exponent] = [source.number('Pm'), source.number('Pr'), source.number('Ns')];
  const highlight = source.color('Ks') ?? (source.has('map_Ks') ? [1, 1, 1] : [0, 0, 0]);
  const strength = share(Math.max(...highlight));
  // An index of refraction and what light takes on its way through say nothing of an opaque surface here.
  source.number('Ni');
  source.color('Tf');
  const roughness = given ?? (exponent === undefined ? undefined : roughnessOfExponent(exponent));
  const rough = roughness === undefined ? {} : { roughness: share(roughness) };
  const isPhysical = metallic !== undefined || given !== undefined || source.has('map_Pr') || source.has('map_Pm');
  if (!isPhysical && illumination === MIRROR && strength > 0) {
    if (!isGrey(highlight as Rgb)) source.leave('Ks');
    return { baseColor, reflectivity: strength, ...rough };
  }
  // A highlight's hue: F₀ of a plastic times this.
  const hue = highlight.map((x) => Math.max(x, 0) / Math.max(...highlight)) as Rgb;
  const colored = illumination >= HIGHLIGHT && strength > 0 && !isGrey(hue);
  const lobe = colored ? { specularLobe: { weight: 1, color: hue as Color } } : {};
  if (isPhysical)
    return { type: 'metallicRoughness', baseColor, metallic: share(metallic ?? (source.has('map_Pm') ? 1 : 0)), ...rough, ...lobe }; // biome-ignore format: one material
  // A plastic's highlight; how strong it is only the classic integrator can be told.
  if (illumination >= HIGHLIGHT && strength > 0)
    return { type: 'metallicRoughness', baseColor, specular: strength, ...rough, ...lobe };
  return { baseColor };
}
