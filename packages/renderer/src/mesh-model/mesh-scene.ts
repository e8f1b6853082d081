/** A file of triangles alone → a scene in a studio, each of its materials as its .mtl file has it. */

import { defaultDecoder, type ImageDecoder } from '../gltf/images/decoder.ts';
import type * as meshFile from '../mesh-file/mesh-file.ts';
import { endingOf, nameOf } from '../open/file-set.ts';
import { frameOf } from '../scene/framing.ts';
import type { MeshSource } from '../scene/mesh.ts';
import { MODEL_RENDER, roomLights, studioSky } from '../scene/model-view.ts';
import type { Material, Scene } from '../scene/scene.ts';
import { IMAGE_ENDINGS } from '../scene/textures.ts';
import { parseScene } from '../scene-file/parse-scene.ts';
import { type Problem, ProblemList, quote, sentence } from '../scene-file/problem.ts';
import type { ReadFile } from '../scene-file/read-file.ts';
import { withThings } from '../scene-file/trusted-scenes.ts';
import { withParts } from '../scene-file/with-parts.ts';
import { type GivenMaterials, type Textured, withTextures } from './material-images.ts';

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
  decoder: ImageDecoder = defaultDecoder(),
): Promise<MeshScene> {
  const meshFiles = await import('../mesh-file/mesh-file.ts');
  const content = meshFiles.readMeshFile(bytes, file);
  if (!content.ok) {
    const problems = content.problems.map(({ line, byte, found, allowed, message }) => {
      const path = line !== undefined ? `line ${line}` : byte !== undefined ? `byte ${byte}` : '';
      return { path, found, allowed, message };
    });
    return { ok: false, problems };
  }
  const { given, notes, problems } = await readMaterials(content, file, meshFiles.readMtl, readFile);
  if (!problems.isEmpty) return { ok: false, problems: problems.list() };
  const textured = await withTextures(content.parts, given, meshFiles, decoder, readFile);
  return sceneOf(content, file, textured, [...content.notes, ...notes]);
}

interface Materials {
  readonly given: GivenMaterials;
  readonly notes: readonly string[];
  readonly problems: ProblemList;
}

/**
 * A file of materials that is not there is no reason to show nothing: it is told, and its parts are plain. When none of the files that
 * are named can be had, one that is called like the model is taken: people rename files.
 */
async function readMaterials(
  { materialFiles, parts }: meshFile.MeshContent,
  file: string,
  readMtl: typeof meshFile.readMtl,
  readFile?: ReadFile,
): Promise<Materials> {
  const notes: string[] = [];
  const files = await materialsOf(materialFiles, readFile, notes);
  const own = `${nameOf(file).replace(/\.[^.]*$/, '')}.mtl`;
  const isWanted = files.length === 0 && parts.some(({ name }) => name !== '') && !materialFiles.includes(own);
  if (isWanted && readFile && /\.obj$/i.test(file)) {
    const found = await materialsOf([own], readFile, []);
    if (found.length > 0) notes.push(`The materials are those of ${quote(own)}, which is called like the model.`);
    files.push(...found);
  }
  const [materials, textures, images] = [Object.create(null), Object.create(null), Object.create(null)];
  const problems = new ProblemList();
  for (const { name, bytes } of files) {
    const read = readMtl(bytes, name);
    if (read.ok) {
      Object.assign(materials, read.materials);
      Object.assign(textures, read.textures);
      Object.assign(images, read.images);
      notes.push(...read.notes);
    } else
      for (const { line, found, allowed, message } of read.problems)
        problems.add([name, ...(line === undefined ? [] : [`line ${line}`])], found, allowed, message);
  }
  return { given: { materials, textures, images }, notes, problems };
}

interface NamedBytes {
  readonly name: string;
  readonly bytes: Uint8Array;
}

async function materialsOf(names: readonly string[], readFile: ReadFile | undefined, notes: string[]) {
  const files: NamedBytes[] = [];
  for (const name of names)
    try {
      if (!readFile) throw new Error('it has not been given');
      files.push({ name, bytes: await readFile(name) });
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      notes.push(
        `The file of materials ${quote(name)} cannot be read, so that what it describes is grey: ${sentence(reason)}`,
      );
    }
  return files;
}

function sceneOf(content: meshFile.MeshContent, file: string, textured: Textured, notes: string[]): MeshScene {
  const name = plainName(nameOf(file).replace(/\.[^.]*$/, '')) || 'model';
  const materials: Record<string, Partial<Material>> = Object.create(null);
  const shapes: Record<string, object> = Object.create(null);
  const meshes: Record<string, MeshSource> = Object.create(null);
  textured.parts.forEach((part, i) => {
    const key = unused(plainName(part.name) || `part ${i + 1}`, shapes);
    const known = textured.materials[part.name];
    if (part.name !== '' && known === undefined && content.materialFiles.length > 0)
      notes.push(`No file describes the material ${quote(part.name)}; it is grey.`);
    materials[key] = known ?? PLAIN;
    shapes[key] = { type: 'mesh', mesh: key, material: key };
    meshes[key] = { data: part.mesh };
  });
  const { textures, images } = textured;
  // What a text may hold goes through the reader of scene files; content is added after it.
  const parsed = parseScene({
    version: 1,
    name,
    camera: { eye: [0, 0, 5], target: [0, 0, 0] },
    materials,
    textures,
    images: mapped(images, () => ({ file: 'image.png' })),
    meshes: mapped(meshes, () => ({ file: 'model.ply' })),
    shapes,
    render: MODEL_RENDER,
  });
  if (!parsed.ok) return parsed;
  const pictures = mapped(images, (data, file) => ({ ...(isImageFile(file) && { file }), data }));
  const whole = withThings(parsed.scene, { meshes, ...(Object.keys(images).length > 0 && { images: pictures }) });
  const frame = frameOf(whole);
  const lit = withThings(whole, { lights: roomLights(frame?.room ?? null) });
  const scene = withParts(lit, { camera: frame?.camera ?? whole.camera, sky: studioSky() });
  return { ok: true, scene, notes: [...notes, ...textured.notes] };
}

const mapped = <From, To>(things: Readonly<Record<string, From>>, change: (thing: From, name: string) => To) =>
  Object.fromEntries(Object.entries(things).map(([name, thing]) => [name, change(thing, name)]));

const isImageFile = (name: string): boolean => (IMAGE_ENDINGS as readonly string[]).includes(endingOf(name));

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
