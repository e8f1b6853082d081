/** Where the name of a mesh, a texture or an image is wanted, the name of its file will do: what was not written down is made here. */

import { MESH_ENDINGS, type MeshSource } from '../scene/mesh.ts';
import type { ModelSource } from '../scene/models.ts';
import type { Material, MeshShape, Shape } from '../scene/scene.ts';
import { IMAGE_ENDINGS, type ImageSource, type Texture, type TextureUse } from '../scene/textures.ts';
import type { Sections } from './check-scene.ts';
import { filePattern } from './values.ts';

const IMAGE_FILE = filePattern(IMAGE_ENDINGS);
const MESH_FILE = filePattern(MESH_ENDINGS);

export function completeNames(given: Sections): Sections {
  const scene = withOwnMaterials(given);
  const { meshes = {}, textures = {}, images = {}, materials, shapes } = scene;
  const newMeshes: Record<string, MeshSource> = {};
  for (const shape of Object.values(shapes as Readonly<Record<string, Shape | undefined>>))
    if (shape?.type === 'mesh' && !Object.hasOwn(meshes, shape.mesh) && MESH_FILE.test(shape.mesh))
      newMeshes[shape.mesh] = { file: shape.mesh, shading: 'auto' };
  const newTextures: Record<string, Texture> = {};
  const isImage = (name: unknown): name is string =>
    typeof name === 'string' && (Object.hasOwn(images, name) || IMAGE_FILE.test(name));
  for (const { texture } of usesIn(materials))
    if (!Object.hasOwn(textures, texture) && isImage(texture)) newTextures[texture] = { image: texture };
  const newImages: Record<string, ImageSource> = {};
  for (const texture of Object.values({ ...textures, ...newTextures }))
    if (isImage(texture?.image) && !Object.hasOwn(images, texture.image))
      newImages[texture.image] = { file: texture.image };
  return {
    ...scene,
    ...more('meshes', meshes, newMeshes),
    ...more('textures', textures, newTextures),
    ...more('images', images, newImages),
  };
}

/**
 * A shape that names a mesh file and no material is a model: all of the file, with the file's own materials. What a model cannot be (a
 * part, placed by a matrix, many times) stays, and lacks a material.
 */
function withOwnMaterials(scene: Sections): Sections {
  const { meshes = {}, models = {} } = scene;
  const shapes: Record<string, Shape> = Object.assign(Object.create(null), scene.shapes);
  const moved: Record<string, ModelSource> = {};
  const left = new Set<string>();
  for (const [name, shape] of Object.entries(shapes)) {
    const file = shape && !Object.hasOwn(models, name) ? ownFile(shape, meshes) : null;
    if (file === null) continue;
    const { mesh, translation, rotation, scale, node } = shape as MeshShape;
    moved[name] = { file, translation, rotation, scale, ...(node !== undefined && { node }) };
    delete shapes[name];
    left.add(mesh);
  }
  if (left.size === 0) return scene;
  for (const shape of Object.values(shapes)) if (shape?.type === 'mesh') left.delete(shape.mesh);
  const kept = Object.entries(meshes).filter(([name]) => !left.has(name));
  const { meshes: _, ...rest } = scene;
  const remaining = kept.length === 0 ? {} : { meshes: Object.assign(Object.create(null), Object.fromEntries(kept)) };
  return { ...rest, shapes, ...remaining, ...more('models', models, moved) } as Sections;
}

function ownFile(shape: Shape, meshes: Readonly<Record<string, MeshSource>>): string | null {
  if (shape.type !== 'mesh' || shape.material !== undefined || typeof shape.mesh !== 'string') return null;
  if (shape.matrix || shape.instances || shape.skin) return null;
  if (!Object.hasOwn(meshes, shape.mesh)) return MESH_FILE.test(shape.mesh) ? shape.mesh : null;
  const { file, part, shading } = meshes[shape.mesh] ?? {};
  return typeof file === 'string' && part === undefined && shading === 'auto' ? file : null;
}

const more = (section: string, old: object, made: object) =>
  Object.keys(made).length === 0 ? {} : { [section]: Object.assign(Object.create(null), old, made) };

/** Uses of textures, wherever they stand in materials, with where that is. */
export function usesIn(materials: Readonly<Record<string, Material>>): (TextureUse & { readonly path: string[] })[] {
  const found: (TextureUse & { readonly path: string[] })[] = [];
  const search = (value: unknown, path: string[]): void => {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) return;
    if (typeof (value as TextureUse).texture === 'string') found.push({ ...(value as TextureUse), path });
    else for (const [key, part] of Object.entries(value)) search(part, [...path, key]);
  };
  search(materials, []);
  return found;
}
