/** The textures of an MTL material → those of ours: images as they are, and images that have to be made of them. */
import type { Color, Material } from '../../scene/scene.ts';
import type { Texture, TextureUse } from '../../scene/textures.ts';
import type { ImageNumbers, MadeImage } from './made-images.ts';
import type { MtlSource } from './mtl-source.ts';
import { CLAMPED, isPlacedAlike, type MtlTexture, textureUse } from './mtl-textures.ts';

/** Names for what materials of one file use. */
export class MapNames {
  /** By name: images that are made of others. */
  readonly images: Record<string, MadeImage> = Object.create(null);
  /** By name, where the name of an image does not say it all. */
  readonly textures: Record<string, Texture> = Object.create(null);
  readonly #known = new Map<string, string>();
  readonly #prefix: string;

  /** `file`: the name of the MTL file. */
  constructor(file: string) {
    this.#prefix = file.slice(-150);
  }

  /** Of a picture of colours. */
  color(map: MtlTexture): TextureUse {
    if (map.base === 0 && map.gain === 1) return this.#use(map.file, map);
    const channel = (c: 'r' | 'g' | 'b'): ImageNumbers => ({ file: map.file, channel: c, base: map.base, gain: map.gain }); // biome-ignore format: one row
    return this.made({ kind: 'channels', red: channel('r'), green: channel('g'), blue: channel('b') }, map);
  }
  plain(map: MtlTexture): TextureUse {
    return this.#use(map.file, map);
  }
  /** `placed`: like this map. */
  made(image: MadeImage, placed: MtlTexture): TextureUse {
    const key = JSON.stringify(image);
    const name = this.#known.get(key) ?? `${this.#prefix}: ${this.#known.size + 1}`;
    this.#known.set(key, name);
    this.images[name] = image;
    return this.#use(name, placed);
  }
  #use(image: string, map: MtlTexture): TextureUse {
    if (!map.clamp && !Object.hasOwn(this.images, image)) return textureUse(image, map);
    const name = map.clamp ? `${image.slice(-180)}, clamped` : image;
    this.textures[name] = { image, ...(map.clamp && CLAMPED) };
    return textureUse(name, map);
  }
}

/** A highlight's exponent where the file has a map of it and no number, as programs write it for what is very smooth. */
const EXPONENT = 1000;

/** `plain`: the material without them. Only what `plain` and numbers do not say. */
export function mapsOf(
  source: MtlSource,
  plain: Partial<Material>,
  hasHighlight: boolean,
  names: MapNames,
): Partial<Material> {
  return {
    ...colors(source, names),
    ...roughnessAndMetallic(source, plain, names),
    ...highlight(source, plain, hasHighlight, names),
    ...bumps(source, names),
    ...cloth(source, plain, names),
    ...coat(source, names),
  };
}

/** Colours and opacity lie in one image. Of opacity alone the colours are white. */
function colors(source: MtlSource, names: MapNames): Partial<Material> {
  const [picture, holes] = [source.texture('map_Kd'), source.texture('map_d')];
  if (!holes) return picture ? { baseColorTexture: names.color(picture) } : {};
  const alphaMode = 'blend' as const;
  const isPlain = holes.channel === undefined && holes.base === 0 && holes.gain === 1;
  if (picture?.file === holes.file && isPlain) return { baseColorTexture: names.color(picture), alphaMode };
  const alpha = numbers(holes, 'opacity');
  if (!picture) return { baseColorTexture: names.made({ kind: 'channels', alpha }, holes), alphaMode };
  if (!isPlacedAlike(picture, holes)) {
    source.leave('map_d (it lies in another way than map_Kd)');
    return { baseColorTexture: names.color(picture) };
  }
  const channel = (c: 'r' | 'g' | 'b') => numbers({ ...picture, channel: c }, c);
  const image = { kind: 'channels', red: channel('r'), green: channel('g'), blue: channel('b'), alpha } as const;
  return { baseColorTexture: names.made(image, picture), alphaMode };
}

const numbers = ({ file, channel, base, gain }: MtlTexture, otherwise: ImageNumbers['channel']): ImageNumbers => ({
  file,
  channel: channel ?? otherwise,
  base,
  gain,
});

/** Green and blue of one image. A map of exponents counts where there is none of roughness. */
function roughnessAndMetallic(source: MtlSource, plain: Partial<Material>, names: MapNames): Partial<Material> {
  const exponents = source.has('map_Pr') || plain.type !== 'metallicRoughness' ? undefined : source.texture('map_Ns');
  const rough = source.texture('map_Pr') ?? exponents;
  let metal = source.texture('map_Pm');
  if (rough && metal && !isPlacedAlike(rough, metal)) {
    source.leave('map_Pm (it lies in another way than map_Pr)');
    metal = undefined;
  }
  const placed = rough ?? metal;
  if (!placed) return {};
  const exponent = exponents && { exponent: source.number('Ns') ?? EXPONENT };
  const green = rough && { ...numbers(rough, 'l'), ...exponent };
  const blue = metal && numbers(metal, 'l');
  const image = { kind: 'channels', ...(green && { green }), ...(blue && { blue }) } as const;
  // The exponent is in the map already; without a number a map is taken as it is.
  const roughness = rough && (exponents || source.number('Pr') === undefined) ? { roughness: 1 } : {};
  return { ...roughness, metallicRoughnessTexture: names.made(image, placed) };
}

function highlight(
  source: MtlSource,
  { specularLobe }: Partial<Material>,
  hasHighlight: boolean,
  names: MapNames,
): Partial<Material> {
  const map = source.texture('map_Ks');
  const strength = Math.max(...(source.color('Ks') ?? [1]));
  if (!map || !hasHighlight || strength <= 0) return {};
  const color: Color = specularLobe?.color ?? [1, 1, 1];
  return { specularLobe: { weight: 1, color, colorTexture: names.color(map) } };
}

/** Of both a normal map and heights the first counts. */
function bumps(source: MtlSource, names: MapNames): Partial<Material> {
  const map = source.texture('norm');
  if (map) return { normalTexture: { ...names.plain(map), normalScale: limited(map.strength) } };
  const heights = source.texture('bump');
  if (!heights) return {};
  const { clamp, strength } = heights;
  const image = { kind: 'normals', heights: numbers(heights, 'l'), strength: limited(strength), clamp } as const;
  return { normalTexture: names.made(image, heights) };
}

const limited = (strength: number): number => Math.min(Math.max(strength, -1000), 1000);

const share = (x: number): number => Math.min(Math.max(x, 0), 1);

function cloth(source: MtlSource, plain: Partial<Material>, names: MapNames): Partial<Material> {
  const map = source.texture('map_Ps');
  const weight = share(source.number('Ps') ?? 1);
  if (!map || weight === 0) return {};
  const grey = { ...numbers(map, 'l'), asColor: true };
  const colorTexture = names.made({ kind: 'channels', red: grey, green: grey, blue: grey }, map);
  return { sheen: { color: [weight, weight, weight], roughness: plain.roughness ?? 0.5, colorTexture } };
}

function coat(source: MtlSource, names: MapNames): Partial<Material> {
  const [map, rough] = [source.texture('map_Pc'), source.texture('map_Pcr')];
  const weight = share(source.number('Pc') ?? (map ? 1 : 0));
  if ((!map && !rough) || weight === 0) return {};
  const use = (of: MtlTexture, channel: 'red' | 'green') =>
    names.made({ kind: 'channels', [channel]: numbers(of, 'l') }, of);
  return {
    clearcoat: {
      weight,
      roughness: share(source.number('Pcr') ?? (rough ? 1 : 0)),
      ...(map && { weightTexture: use(map, 'red') }),
      ...(rough && { roughnessTexture: use(rough, 'green') }),
    },
  };
}
