/** Where the name of a mesh, a texture or an image is wanted, the name of its file will do: what was not written down is made here. */

import { MESH_ENDINGS, type MeshSource } from '../scene/mesh.ts';
import type { Material, Shape } from '../scene/scene.ts';
import { IMAGE_ENDINGS, type ImageSource, type Texture, type TextureUse } from '../scene/textures.ts';
import type { Sections } from './check-scene.ts';
import { filePattern } from './values.ts';

const IMAGE_FILE = filePattern(IMAGE_ENDINGS);
const MESH_FILE = filePattern(MESH_ENDINGS);

export function completeNames(scene: Sections): Sections {
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
