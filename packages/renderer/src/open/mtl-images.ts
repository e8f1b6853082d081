/** The textures that an .mtl file names: the files of their images, and meshes that can have them. */
import { loadTangentMaker, withTangents } from '../gltf/mesh/tangents.ts';
import type { MeshContent } from '../mesh-file/mesh-file.ts';
import type { Material } from '../scene/scene.ts';
import type { TextureUse } from '../scene/textures.ts';
import { quote, sentence } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';

type Parts = MeshContent['parts'];
type Materials = Readonly<Record<string, Partial<Material>>>;

const USES = ['baseColorTexture', 'emissionTexture', 'normalTexture'] as const;
type Use = (typeof USES)[number];

export interface Textured {
  /** Those with normal maps have tangents. */
  readonly parts: Parts;
  /** Without the textures that cannot be had. */
  readonly materials: Materials;
  /** Images by the names that materials have for them. */
  readonly files: ReadonlyMap<string, Uint8Array>;
  readonly notes: readonly string[];
}

/** An image that is not there is no reason to show nothing: that is told, and the material is without it. */
export async function withTextures(parts: Parts, given: Materials, readFile?: ReadFile): Promise<Textured> {
  const materials: Record<string, Partial<Material>> = Object.assign(Object.create(null), given);
  const files = new Map<string, Uint8Array>();
  const missing = new Set<string>();
  const notes: string[] = [];
  const made = [];
  for (const part of parts) {
    const material = materials[part.name];
    const kept = material && part.mesh.uvs === undefined ? withoutTextures(part.name, material, notes) : material;
    if (kept) materials[part.name] = await withFiles(kept, files, missing, notes, readFile);
    const map = materials[part.name]?.normalTexture;
    made.push(map ? { ...part, mesh: withTangents(part.mesh, map, await loadTangentMaker()) } : part);
  }
  return { parts: made, materials, files, notes };
}

function withoutTextures(name: string, material: Partial<Material>, notes: string[]): Partial<Material> {
  if (!USES.some((use) => material[use])) return material;
  notes.push(`The material ${quote(name)} has textures, and its triangles have no texture coordinates.`);
  return without(material, USES);
}

/** A lamp whose picture is not there is none: it would shine where the picture is dark. */
function without(material: Partial<Material>, uses: readonly Use[]): Partial<Material> {
  const lost: readonly string[] = uses.includes('emissionTexture') ? [...uses, 'emission'] : uses;
  return Object.fromEntries(Object.entries(material).filter(([key]) => !lost.includes(key)));
}

async function withFiles(
  material: Partial<Material>,
  files: Map<string, Uint8Array>,
  missing: Set<string>,
  notes: string[],
  readFile?: ReadFile,
): Promise<Partial<Material>> {
  const lost: Use[] = [];
  for (const use of USES) {
    const name = (material[use] as TextureUse | undefined)?.texture;
    if (name === undefined || files.has(name)) continue;
    if (missing.has(name) || !(await find(name, files, notes, readFile))) lost.push(use);
    if (lost.includes(use)) missing.add(name);
  }
  return lost.length > 0 ? without(material, lost) : material;
}

async function find(
  name: string,
  files: Map<string, Uint8Array>,
  notes: string[],
  readFile?: ReadFile,
): Promise<boolean> {
  try {
    if (!readFile) throw new Error('it has not been given');
    files.set(name, await readFile(name));
    return true;
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    notes.push(`The image ${quote(name)} cannot be read, so that what it covers is plain: ${sentence(reason)}`);
    return false;
  }
}
