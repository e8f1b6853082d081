/** A file of triangles alone → a scene in a studio, each of its materials as its .mtl file has it. */

import type { ImageDecoder } from '../gltf/images/decoder.ts';
import type { MeshContent } from '../mesh-file/mesh-file.ts';
import { frameScene } from '../scene/framing.ts';
import type { MeshSource } from '../scene/mesh.ts';
import { MODEL_RENDER, studioSky } from '../scene/model-view.ts';
import type { Material, Scene } from '../scene/scene.ts';
import { loadFiles } from '../scene-file/load-files.ts';
import { parseScene } from '../scene-file/parse-scene.ts';
import { type Problem, ProblemList, quote, sentence } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';
import { withMeshes } from '../scene-file/trusted-scenes.ts';
import { withParts } from '../scene-file/with-parts.ts';
import { nameOf } from './file-set.ts';
import { withTextures } from './mtl-images.ts';

export type MeshScene =
  | { readonly ok: true; readonly scene: Scene; readonly notes: readonly string[] }
  | { readonly ok: false; readonly problems: readonly Problem[] };

/** What a part has whose material nobody describes: a light grey that shows form. */
const PLAIN: Partial<Material> = { type: 'metallicRoughness', baseColor: [0.6, 0.6, 0.6], roughness: 0.6 };

/** `readFile`: for .mtl files and images, from the file's own folder on. Never rejects. */
export async function meshScene(
  bytes: Uint8Array,
  file: string,
  readFile?: ReadFile,
  decoder?: ImageDecoder,
): Promise<MeshScene> {
  const { readMeshFile } = await import('../mesh-file/mesh-file.ts');
  const content = readMeshFile(bytes, file);
  if (!content.ok) {
    const problems = content.problems.map(({ line, byte, found, allowed, message }) => {
      const path = line !== undefined ? `line ${line}` : byte !== undefined ? `byte ${byte}` : '';
      return { path, found, allowed, message };
    });
    return { ok: false, problems };
  }
  const { materials, notes, problems } = await readMaterials(content, readFile);
  if (!problems.isEmpty) return { ok: false, problems: problems.list() };
  const textured = await withTextures(content.parts, materials, readFile);
  const scene = sceneOf({ ...content, parts: textured.parts }, file, textured.materials, [...content.notes, ...notes, ...textured.notes]); // biome-ignore format: one expression
  if (!scene.ok || textured.files.size === 0) return scene;
  const loaded = await loadFiles(scene.scene, async (name) => textured.files.get(name)!, { decoder });
  return loaded.ok ? { ...loaded, notes: [...scene.notes, ...loaded.notes] } : loaded;
}

interface Materials {
  readonly materials: Readonly<Record<string, Partial<Material>>>;
  readonly notes: readonly string[];
  readonly problems: ProblemList;
}

/** A file of materials that is not there is no reason to show nothing: it is told, and its parts are plain. */
async function readMaterials({ materialFiles }: MeshContent, readFile?: ReadFile): Promise<Materials> {
  const materials: Record<string, Partial<Material>> = Object.create(null);
  const notes: string[] = [];
  const problems = new ProblemList();
  for (const name of materialFiles) {
    let bytes: Uint8Array;
    try {
      if (!readFile) throw new Error('it has not been given');
      bytes = await readFile(name);
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      notes.push(
        `The file of materials ${quote(name)} cannot be read, so that what it describes is grey: ${sentence(reason)}`,
      );
      continue;
    }
    const { readMtl } = await import('../mesh-file/mesh-file.ts');
    const read = readMtl(bytes, name);
    if (read.ok) {
      Object.assign(materials, read.materials);
      notes.push(...read.notes);
    } else
      for (const { line, found, allowed, message } of read.problems)
        problems.add([name, ...(line === undefined ? [] : [`line ${line}`])], found, allowed, message);
  }
  return { materials, notes, problems };
}

function sceneOf(content: MeshContent, file: string, given: Materials['materials'], notes: string[]): MeshScene {
  const name = plainName(nameOf(file).replace(/\.[^.]*$/, '')) || 'model';
  const materials: Record<string, Partial<Material>> = Object.create(null);
  const shapes: Record<string, object> = Object.create(null);
  const meshes: Record<string, MeshSource> = Object.create(null);
  content.parts.forEach((part, i) => {
    const key = unused(plainName(part.name) || `part ${i + 1}`, shapes);
    const known = given[part.name];
    if (part.name !== '' && known === undefined && content.materialFiles.length > 0)
      notes.push(`No file describes the material ${quote(part.name)}; it is grey.`);
    materials[key] = known ?? PLAIN;
    shapes[key] = { type: 'mesh', mesh: key, material: key };
    meshes[key] = { data: part.mesh };
  });
  // What a text may hold goes through the reader of scene files; content is added after it.
  const parsed = parseScene({
    version: 1,
    name,
    camera: { eye: [0, 0, 5], target: [0, 0, 0] },
    materials,
    meshes: Object.fromEntries(Object.keys(meshes).map((key) => [key, { file: 'model.ply' }])),
    shapes,
    render: MODEL_RENDER,
  });
  if (!parsed.ok) return parsed;
  const whole = withMeshes(parsed.scene, meshes);
  const camera = frameScene(whole) ?? whole.camera;
  return { ok: true, scene: withParts(whole, { camera, sky: studioSky() }), notes };
}

/** As scene files may have it. */
const plainName = (name: string): string =>
  name
    .replace(/[\p{Cc}\p{Cf}\p{Cs}\p{Zl}\p{Zp}]+/gu, ' ')
    .trim()
    .slice(0, 190)
    .trim();

function unused(name: string, taken: object): string {
  let free = name;
  for (let n = 2; free in taken; n++) free = `${name} ${n}`;
  return free;
}
