/** The textures that .mtl files name: their images, as files have them or made of these, and meshes that can have them. */
import type { ImageDecoder } from '../gltf/images/decoder.ts';
import type { ImageHead } from '../gltf/images/image-head.ts';
import { loadTangentMaker, withTangents } from '../gltf/mesh/tangents.ts';
import type * as meshFiles from '../mesh-file/mesh-file.ts';
import { SCENE_LIMITS } from '../scene/limits.ts';
import type { Material } from '../scene/scene.ts';
import type { ImagePixels, Texture, TextureUse } from '../scene/textures.ts';
import { usesIn } from '../scene-file/complete-names.ts';
import { headOf } from '../scene-file/load-images.ts';
import { quote, sentence } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';

type Parts = meshFiles.MeshContent['parts'];
type MadeImage = meshFiles.MadeImage;
/** Comes with the readers of meshes, which are loaded when they are needed. */
export type ImageMaker = Pick<typeof meshFiles, 'makeImage' | 'sizeOf' | 'sourcesOf'>;
type GivenMaterial = Partial<Material>;

/** What .mtl files say, all of them together. */
export interface GivenMaterials {
  readonly materials: Readonly<Record<string, GivenMaterial>>;
  readonly textures: Readonly<Record<string, Texture>>;
  readonly images: Readonly<Record<string, MadeImage>>;
}
export interface Textured {
  /** Those with normal maps have tangents. */
  readonly parts: Parts;
  /** Without the textures that cannot be had. */
  readonly materials: Readonly<Record<string, GivenMaterial>>;
  /** Only those that materials name. */
  readonly textures: Readonly<Record<string, Texture>>;
  readonly images: Readonly<Record<string, ImagePixels>>;
  readonly notes: readonly string[];
}

/** An image that is not there is no reason to show nothing: that is told, and the material is without it. */
export async function withTextures(
  parts: Parts,
  given: GivenMaterials,
  maker: ImageMaker,
  decoder: ImageDecoder,
  readFile?: ReadFile,
): Promise<Textured> {
  const notes: string[] = [];
  const materials: Record<string, GivenMaterial> = Object.assign(Object.create(null), given.materials);
  for (const { name, mesh } of parts)
    if (materials[name] && mesh.uvs === undefined) materials[name] = withoutTextures(name, materials[name], notes);
  const used = parts.flatMap(({ name }) => (materials[name] ? [materials[name]] : []));
  const wanted = new Set(used.flatMap((material) => usesOf(material).map(({ texture }) => imageOf(texture, given))));
  const files = await decodeAll(wanted, given.images, maker, decoder, notes, readFile);
  const images: Record<string, ImagePixels> = Object.create(null);
  for (const name of wanted) {
    const image = imageFrom(name, given.images[name], files, maker);
    if (image) images[name] = image;
  }
  for (const { name } of parts)
    if (materials[name]) materials[name] = kept(materials[name], ({ texture }) => imageOf(texture, given) in images);
  const textures = Object.fromEntries(Object.entries(given.textures).filter(([, { image }]) => image in images));
  return { parts: await withNormals(parts, materials), materials, textures, images, notes };
}

const usesOf = (material: GivenMaterial): TextureUse[] => usesIn({ it: material as Material });
const imageOf = (texture: string, { textures }: GivenMaterials): string => textures[texture]?.image ?? texture;

function imageFrom(
  name: string,
  made: MadeImage | undefined,
  files: ReadonlyMap<string, ImagePixels>,
  { makeImage, sourcesOf }: ImageMaker,
): ImagePixels | undefined {
  if (made === undefined) return files.get(name);
  return sourcesOf(made).every((file) => files.has(file)) ? makeImage(made, files) : undefined;
}

function withoutTextures(name: string, material: GivenMaterial, notes: string[]): GivenMaterial {
  if (usesOf(material).length === 0) return material;
  notes.push(`The material ${quote(name)} has textures, and its triangles have no texture coordinates.`);
  return kept(material, () => false);
}

/** What a texture's absence would make wrong: a lamp would shine where its picture is dark, and all would be metal or as smooth as can be. */
const FALLS_WITH: Readonly<Record<string, readonly (keyof Material)[]>> = {
  emissionTexture: ['emission'],
  metallicRoughnessTexture: ['metallic', 'roughness'],
  sheen: ['sheen'],
  clearcoat: ['clearcoat'],
};

/** The material with those of its textures that are to stay. */
function kept(material: GivenMaterial, stays: (use: TextureUse) => boolean): GivenMaterial {
  const lost = usesIn({ it: material as Material }).filter((use) => !stays(use));
  if (lost.length === 0) return material;
  const fallen = new Set(lost.flatMap(({ path }) => FALLS_WITH[path[1]!] ?? []));
  const without = (value: unknown): unknown => {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) return value;
    const entries = Object.entries(value).filter(([, part]) => !isUse(part) || stays(part));
    return Object.fromEntries(entries.map(([key, part]) => [key, without(part)]));
  };
  const entries = Object.entries(without(material) as object).filter(([key]) => !fallen.has(key as keyof Material));
  return Object.fromEntries(entries);
}

const isUse = (part: unknown): part is TextureUse => typeof (part as TextureUse | null)?.texture === 'string';

interface OpenedFile {
  readonly bytes: Uint8Array;
  readonly head: ImageHead;
}

/** Each file once, and none before it is known how much all of them are. Those that cannot be had are told. */
async function decodeAll(
  wanted: ReadonlySet<string>,
  made: GivenMaterials['images'],
  maker: ImageMaker,
  decoder: ImageDecoder,
  notes: string[],
  readFile?: ReadFile,
): Promise<Map<string, ImagePixels>> {
  const opened = new Map<string, OpenedFile>();
  const refuse = (file: string, error: unknown) => {
    const reason = error instanceof Error ? error.message : String(error);
    notes.push(`The image ${quote(file)} cannot be read, so that what it covers is plain: ${sentence(reason)}`);
  };
  for (const file of new Set([...wanted].flatMap((name) => (made[name] ? maker.sourcesOf(made[name]) : [name]))))
    try {
      if (!readFile) throw new Error('it has not been given');
      const bytes = await readFile(file);
      opened.set(file, { bytes, head: headOf(bytes, decoder) });
    } catch (error) {
      refuse(file, error);
    }
  dropBeyond(opened, wanted, made, maker, refuse);
  const images = new Map<string, ImagePixels>();
  for (const [file, { bytes, head }] of opened)
    try {
      images.set(file, await decoder.decode(bytes, head.type));
    } catch (error) {
      refuse(file, error);
    }
  return images;
}

/** Files of a few bytes may stand for pixels without end: what is more than a scene may have is left out, the last files first. */
function dropBeyond(
  opened: Map<string, OpenedFile>,
  wanted: ReadonlySet<string>,
  made: GivenMaterials['images'],
  { sizeOf, sourcesOf }: ImageMaker,
  refuse: (file: string, error: unknown) => void,
): void {
  const heads = () => new Map([...opened].map(([file, { head }]) => [file, head] as const));
  const total = (): number => {
    const sizes = [...heads().values()];
    for (const name of wanted)
      if (made[name] && sourcesOf(made[name]).every((file) => opened.has(file))) sizes.push(sizeOf(made[name], heads()) as ImageHead); // biome-ignore format: one condition
    return sizes.reduce((sum, { width, height }) => sum + 4 * width * height, 0);
  };
  for (const file of [...opened.keys()].reverse()) {
    if (total() <= SCENE_LIMITS.imageBytes) return;
    opened.delete(file);
    refuse(file, new Error(`with it the images would have more than ${SCENE_LIMITS.imageBytes} bytes`));
  }
}

async function withNormals(parts: Parts, materials: Textured['materials']): Promise<Parts> {
  const made = [];
  for (const part of parts) {
    const material = materials[part.name];
    const map = material?.normalTexture ?? (material?.anisotropy && part.mesh.uvs ? null : undefined);
    made.push(map === undefined ? part : { ...part, mesh: withTangents(part.mesh, map, await loadTangentMaker()) });
  }
  return made;
}
