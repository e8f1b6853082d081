/** What textures make of a mesh's surface. */
import type { MaterialLayers } from '../../scene/material-layers.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { Color, Material, Scene, Vec3 } from '../../scene/scene.ts';
import { lookUp, type PreparedTexture, prepareTexture, type Texel } from '../texture.ts';
import type { MeshHit } from './tree.ts';

export interface MeshTextures {
  readonly baseColor: PreparedTexture | null;
  readonly emission: PreparedTexture | null;
  readonly normal: PreparedTexture | null;
}

export function prepareTextures(scene: Scene, material: Material & MaterialLayers): MeshTextures {
  const { baseColorTexture, emissionTexture, normalTexture } = material;
  return {
    baseColor: baseColorTexture ? prepareTexture(scene, baseColorTexture, true) : null,
    emission: emissionTexture ? prepareTexture(scene, emissionTexture, true) : null,
    normal: normalTexture ? prepareTexture(scene, normalTexture, false) : null,
  };
}

/** The texture where the mesh was hit; null: white. */
export function texelOf(mesh: Mesh, { triangle, weights }: MeshHit, texture: PreparedTexture | null): Texel {
  if (texture === null) return [1, 1, 1, 1];
  const uv = mesh.uvs?.[texture.use.uvSet ?? 0];
  const blend = (axis: 0 | 1) =>
    [0, 1, 2].reduce((sum, k) => sum + weights[k]! * (uv?.[2 * mesh.indices[3 * triangle + k]! + axis] ?? 0), 0);
  return lookUp(texture, [blend(0), blend(1)]);
}

export const timesTexel = ([r, g, b]: Color, texel: Texel): Color => [r * texel[0], g * texel[1], b * texel[2]];

/** What a normal map says, in the frame of tangent, bitangent and normal; of any length. */
export function bumpOf(mesh: Mesh, hit: MeshHit, texture: PreparedTexture): Vec3 {
  const [x, y, z] = texelOf(mesh, hit, texture);
  const { normalScale = 1 } = texture.use;
  return [(2 * x - 1) * normalScale, (2 * y - 1) * normalScale, 2 * z - 1];
}
