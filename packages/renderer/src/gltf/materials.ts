/** Materials of a file: glTF 2.0's, and the extensions that belong to them. Numbers beyond their range are told and cut. */
import type { Anisotropy, Clearcoat, DiffuseTransmission, Iridescence, MaterialLayers, Sheen, SpecularLobe, Transmission, Volume } from '../scene/material-layers.ts'; // biome-ignore format: one list
import { MATTE } from '../scene/materials.ts';
import type { Color, Material } from '../scene/scene.ts';
import type { TextureUse } from '../scene/textures.ts';
import { extensionOf, type MaterialJson } from './json.ts';
import type { Path } from './problems.ts';
import { type Reading, within } from './reading.ts';
import { specularGlossiness } from './specular-glossiness.ts';
import type { Making, TextureInfo, TextureReader } from './textures.ts';

const BRIGHTEST = 1e6;
const degrees = (radians: number): number => (radians * 180) / Math.PI;

/** Everything that glTF's default material says, and what Mirrorball's has beyond it. */
const BASE: Omit<Material, keyof MaterialLayers> = { ...MATTE, type: 'metallicRoughness', metallic: 1 };

type Fields = Readonly<Record<string, number | number[] | TextureInfo | undefined>>;

/** One material or extension whose fields are looked up by their names. */
export class FieldReader {
  readonly #reading: Reading;
  readonly #textures: TextureReader;
  readonly #fields: Fields;
  readonly #path: Path;

  constructor(reading: Reading, textures: TextureReader, fields: object, path: Path) {
    this.#reading = reading;
    this.#textures = textures;
    this.#fields = fields as Fields;
    this.#path = path;
  }

  number(key: string, otherwise: number, least: number, most: number): number {
    const value = (this.#fields[key] as number | undefined) ?? otherwise;
    return within(this.#reading, value, least, most, [...this.#path, key]);
  }

  color(key: string, otherwise: Color, most = 1): Color {
    const value = (this.#fields[key] as number[] | undefined) ?? otherwise;
    return value
      .slice(0, 3)
      .map((channel, i) => within(this.#reading, channel, 0, most, [...this.#path, key, i])) as unknown as Color;
  }

  texture<Key extends string>(key: string, as: Key): { readonly [K in Key]?: TextureUse } {
    const use = this.#textures.use(this.#fields[key] as TextureInfo | undefined, [...this.#path, key]);
    return (use === undefined ? {} : { [as]: use }) as { readonly [K in Key]?: TextureUse };
  }

  /** The fourth number of a colour: opacity. */
  alpha(key: string): number {
    const alpha = (this.#fields[key] as number[] | undefined)?.[3] ?? 1;
    return within(this.#reading, alpha, 0, 1, [...this.#path, key, 3]);
  }

  /** Of an image that is made of that texture's, and of the other's where there is one. */
  madeTexture<Key extends string>(
    key: string,
    as: Key,
    making: Making,
    other = '',
  ): { readonly [K in Key]?: TextureUse } {
    const info = (name: string) => this.#fields[name] as TextureInfo | undefined;
    const use = this.#textures.useMade(info(key)!, [...this.#path, key], making, info(other));
    return (use === undefined ? {} : { [as]: use }) as { readonly [K in Key]?: TextureUse };
  }

  /** Whether two textures lie on the mesh in the same way, or there is no second one. */
  liesAlike(key: string, other: string): boolean {
    const infos = [key, other].map((name) => this.#fields[name] as TextureInfo | undefined);
    return this.#textures.lieAlike(infos[0]!, infos[1]);
  }

  /** What could not be taken as it stands. */
  tell(key: string, message: string): void {
    this.#reading.report.add('changed', key, [...this.#path, key], message);
  }

  normalTexture(key: string): { readonly normalTexture?: TextureUse } {
    const use = this.#textures.useNormal(this.#fields[key] as TextureInfo | undefined, [...this.#path, key]);
    return use === undefined ? {} : { normalTexture: use };
  }
}

/** glTF's material for primitives that name none. */
export const defaultMaterial = (): Material => ({ ...BASE, doubleSided: false });

export function readMaterial(reading: Reading, textures: TextureReader, json: MaterialJson, index: number): Material {
  const path = ['materials', index];
  const fields = (part: object, ...keys: string[]) => new FieldReader(reading, textures, part, [...path, ...keys]);
  const own = fields(json);
  const extension = (name: string) => {
    const found = extensionOf<object>(json, name);
    return found && fields(found, 'extensions', name);
  };
  // Where there is specular and glossiness, metal and roughness are for who does not know these. Unlit is neither.
  const isUnlit = extension('KHR_materials_unlit') !== undefined;
  const glossy = isUnlit ? undefined : extension('KHR_materials_pbrSpecularGlossiness');
  const metallicRoughness = glossy ? {} : (json.pbrMetallicRoughness ?? {});
  const pbr = fields(metallicRoughness, 'pbrMetallicRoughness');
  const alpha = metallicRoughness.baseColorFactor?.[3] ?? 1;
  const base: Material = {
    ...BASE,
    baseColor: pbr.color('baseColorFactor', [1, 1, 1]),
    metallic: pbr.number('metallicFactor', 1, 0, 1),
    roughness: pbr.number('roughnessFactor', 1, 0, 1),
    emission: own.color('emissiveFactor', [0, 0, 0], BRIGHTEST),
    ...pbr.texture('baseColorTexture', 'baseColorTexture'),
    ...pbr.texture('metallicRoughnessTexture', 'metallicRoughnessTexture'),
    ...own.normalTexture('normalTexture'),
    ...own.texture('emissiveTexture', 'emissionTexture'),
    ...own.texture('occlusionTexture', 'occlusionTexture'),
    ...(alpha !== 1 && {
      opacity: within(reading, alpha, 0, 1, [...path, 'pbrMetallicRoughness', 'baseColorFactor', 3]),
    }),
    ...alphaOf(json),
    doubleSided: json.doubleSided ?? false,
  };
  if (base.occlusionTexture)
    reading.report.add(
      'unused',
      'occlusionTexture',
      [...path, 'occlusionTexture'],
      'Occlusion textures are kept but not used: paths find out themselves how much light reaches a corner.',
    );
  const whole: Material = { ...base, ...layersOf(extension), ...(glossy && specularGlossiness(glossy)) };
  const coatMap = whole.clearcoat?.normalTexture;
  if (coatMap && base.normalTexture && (coatMap.uvSet ?? 0) !== (base.normalTexture.uvSet ?? 0))
    reading.report.add(
      'changed',
      'clearcoatNormalTexture',
      [...path, 'extensions', 'KHR_materials_clearcoat', 'clearcoatNormalTexture'],
      "A clear coat's normal map goes by other coordinates than its base's; both have the tangents of the base.",
    );
  return whole;
}

const MODES = { OPAQUE: 'opaque', MASK: 'mask', BLEND: 'blend' } as const;

function alphaOf({
  alphaMode = 'OPAQUE',
  alphaCutoff,
}: MaterialJson): Pick<MaterialLayers, 'alphaMode' | 'alphaCutoff'> {
  if (alphaMode === 'OPAQUE') return {};
  return { alphaMode: MODES[alphaMode], ...(alphaMode === 'MASK' && alphaCutoff !== undefined && { alphaCutoff }) };
}

type Extension = (name: string) => FieldReader | undefined;

function layersOf(extension: Extension): Partial<Material> {
  const strength = extension('KHR_materials_emissive_strength');
  const ior = extension('KHR_materials_ior');
  const dispersion = extension('KHR_materials_dispersion');
  return {
    ...(strength && { emissionStrength: strength.number('emissiveStrength', 1, 0, BRIGHTEST) }),
    ...(ior && { ior: iorOf(ior) }),
    ...(dispersion && { dispersion: dispersion.number('dispersion', 0, 0, 100) }),
    ...(extension('KHR_materials_unlit') && { unlit: true }),
    ...group('specularLobe', extension('KHR_materials_specular'), specularLobe),
    ...group('transmission', extension('KHR_materials_transmission'), transmission),
    ...volumeOf(extension('KHR_materials_volume')),
    ...group('diffuseTransmission', extension('KHR_materials_diffuse_transmission'), diffuseTransmission),
    ...group('clearcoat', extension('KHR_materials_clearcoat'), clearcoat),
    ...group('sheen', extension('KHR_materials_sheen'), sheen),
    ...group('anisotropy', extension('KHR_materials_anisotropy'), anisotropy),
    ...group('iridescence', extension('KHR_materials_iridescence'), iridescence),
  };
}

const group = <Key extends string, Group>(
  key: Key,
  from: FieldReader | undefined,
  make: (from: FieldReader) => Group,
) => (from === undefined ? {} : { [key]: make(from) }) as { readonly [K in Key]?: Group };

/** 0 stands for an endless index. */
function iorOf(from: FieldReader): number {
  const ior = from.number('ior', 1.5, 0, 4);
  return ior === 0 ? 0 : from.number('ior', 1.5, 1, 4);
}

const specularLobe = (from: FieldReader): SpecularLobe => ({
  weight: from.number('specularFactor', 1, 0, 1),
  color: from.color('specularColorFactor', [1, 1, 1], BRIGHTEST),
  ...from.texture('specularTexture', 'weightTexture'),
  ...from.texture('specularColorTexture', 'colorTexture'),
});

const transmission = (from: FieldReader): Transmission => ({
  weight: from.number('transmissionFactor', 0, 0, 1),
  ...from.texture('transmissionTexture', 'weightTexture'),
});

function volumeOf(from: FieldReader | undefined): {
  volume?: Volume;
  attenuationColor?: Color;
  attenuationDistance?: number;
} {
  if (from === undefined) return {};
  const distance = from.number('attenuationDistance', Number.POSITIVE_INFINITY, 0, Number.POSITIVE_INFINITY);
  return {
    volume: {
      thickness: from.number('thicknessFactor', 0, 0, 1e9),
      ...from.texture('thicknessTexture', 'thicknessTexture'),
    },
    attenuationColor: from.color('attenuationColor', [1, 1, 1]),
    // As good as endless; an infinite one is 0 here.
    attenuationDistance: distance > 1e9 ? 0 : distance,
  };
}

const diffuseTransmission = (from: FieldReader): DiffuseTransmission => ({
  weight: from.number('diffuseTransmissionFactor', 0, 0, 1),
  color: from.color('diffuseTransmissionColorFactor', [1, 1, 1]),
  ...from.texture('diffuseTransmissionTexture', 'weightTexture'),
  ...from.texture('diffuseTransmissionColorTexture', 'colorTexture'),
});

const clearcoat = (from: FieldReader): Clearcoat => ({
  weight: from.number('clearcoatFactor', 0, 0, 1),
  roughness: from.number('clearcoatRoughnessFactor', 0, 0, 1),
  ...from.texture('clearcoatTexture', 'weightTexture'),
  ...from.texture('clearcoatRoughnessTexture', 'roughnessTexture'),
  ...from.normalTexture('clearcoatNormalTexture'),
});

const sheen = (from: FieldReader): Sheen => ({
  color: from.color('sheenColorFactor', [0, 0, 0]),
  roughness: from.number('sheenRoughnessFactor', 0, 0, 1),
  ...from.texture('sheenColorTexture', 'colorTexture'),
  ...from.texture('sheenRoughnessTexture', 'roughnessTexture'),
});

const anisotropy = (from: FieldReader): Anisotropy => ({
  strength: from.number('anisotropyStrength', 0, 0, 1),
  rotation: degrees(from.number('anisotropyRotation', 0, -1e6, 1e6)),
  ...from.texture('anisotropyTexture', 'texture'),
});

const iridescence = (from: FieldReader): Iridescence => ({
  weight: from.number('iridescenceFactor', 0, 0, 1),
  ior: from.number('iridescenceIor', 1.3, 1, 10),
  thicknessMinimum: from.number('iridescenceThicknessMinimum', 100, 0, 1e6),
  thicknessMaximum: from.number('iridescenceThicknessMaximum', 400, 0, 1e6),
  ...from.texture('iridescenceTexture', 'weightTexture'),
  ...from.texture('iridescenceThicknessTexture', 'thicknessTexture'),
});

/** Texture uses of a material as the file has it, wherever they stand: what has an "index" is one. */
export function texturesNamedBy(json: MaterialJson): number[] {
  const found: number[] = [];
  const search = (value: unknown, deep: number): void => {
    if (typeof value !== 'object' || value === null || deep > 6) return;
    for (const [key, part] of Object.entries(value)) {
      if (key === 'extensions' || key === 'extras') continue;
      if (!key.endsWith('Texture')) search(part, deep + 1);
      else if (typeof (part as TextureInfo | null)?.index === 'number') found.push((part as TextureInfo).index);
    }
  };
  const { extras: _, extensions = {}, ...rest } = json;
  search(rest, 0);
  for (const name of Object.keys(extensions)) if (MATERIAL_EXTENSIONS.includes(name)) search(extensions[name], 1);
  return found;
}

export const MATERIAL_EXTENSIONS: readonly string[] = [
  'KHR_materials_emissive_strength',
  'KHR_materials_ior',
  'KHR_materials_specular',
  'KHR_materials_transmission',
  'KHR_materials_volume',
  'KHR_materials_clearcoat',
  'KHR_materials_sheen',
  'KHR_materials_anisotropy',
  'KHR_materials_iridescence',
  'KHR_materials_dispersion',
  'KHR_materials_diffuse_transmission',
  'KHR_materials_unlit',
  'KHR_materials_pbrSpecularGlossiness',
];

/** What a material's normals are bent by, with whose coordinates tangents must go; null when it needs none. */
export function tangentUse({
  normalTexture,
  clearcoat: coat,
  anisotropy: grain,
  unlit,
}: Material): TextureUse | 'any' | null {
  if (unlit) return null;
  if (normalTexture) return normalTexture;
  if (coat?.normalTexture) return coat.normalTexture;
  if (grain && grain.strength > 0) return grain.texture ?? 'any';
  return null;
}

/** Whether images of it hold directions, which count from tangents. */
export const hasDirections = ({ normalTexture, clearcoat, anisotropy, unlit }: Material): boolean =>
  !unlit && (normalTexture ?? clearcoat?.normalTexture ?? anisotropy?.texture) !== undefined;

export function withoutDirections({ normalTexture: _, clearcoat, anisotropy, ...material }: Material): Material {
  const { normalTexture: __, ...coat } = clearcoat ?? {};
  const { texture: ___, ...grain } = anisotropy ?? {};
  return {
    ...material,
    ...(clearcoat && { clearcoat: coat as typeof clearcoat }),
    ...(anisotropy && { anisotropy: grain as typeof anisotropy }),
  };
}
