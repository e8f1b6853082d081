/** How much there is of a scene. */
import { AFFINE_LENGTH } from './affine.ts';
import { triangleCount, vertexCount } from './mesh.ts';
import { meshShapes } from './placed.ts';
import type { Scene } from './scene.ts';

export interface SceneCounts {
  /** Of all meshes, each counted once. */
  readonly triangles: number;
  readonly vertices: number;
  readonly meshes: number;
  /** Places at which meshes stand, instances and all. */
  readonly placements: number;
  readonly nodes: number;
  readonly materials: number;
  readonly textures: number;
  readonly images: number;
  readonly lights: number;
  readonly cameras: number;
  readonly clips: number;
  readonly skins: number;
}

/** Every mesh has its data. */
export function countsOf(scene: Scene): SceneCounts {
  const count = (things: object | undefined): number => Object.keys(things ?? {}).length;
  const meshes = Object.values(scene.meshes ?? {}).map(({ data }) => data!);
  return {
    triangles: meshes.reduce((sum, mesh) => sum + triangleCount(mesh), 0),
    vertices: meshes.reduce((sum, mesh) => sum + vertexCount(mesh), 0),
    meshes: meshes.length,
    placements: meshShapes(scene).reduce((sum, [, { instances }]) => sum + (instances ? instances.length / AFFINE_LENGTH : 1), 0), // biome-ignore format: one sum
    nodes: count(scene.nodes),
    materials: count(scene.materials),
    textures: count(scene.textures),
    images: count(scene.images),
    lights: count(scene.lights),
    cameras: count(scene.cameras),
    clips: count(scene.clips),
    skins: count(scene.skins),
  };
}
