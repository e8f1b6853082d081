/**
 * Whether a mesh is there where a ray meets it: glTF 2.0, 3.9.4. Here nothing is left to chance, as the kernels do for `blend`: what is at
 * least half opaque is there.
 */
import { isOneSided, mayBeMissing } from '../../packed-scene/texture-slots.ts';
import type { MaterialLayers } from '../../scene/material-layers.ts';
import type { Mesh } from '../../scene/mesh.ts';
import type { Material, Vec3 } from '../../scene/scene.ts';
import { cross, dot, subtract } from '../../scene/vec3.ts';
import type { PreparedTexture } from '../texture.ts';
import { texelOf } from './textured.ts';
import type { MeshHit } from './tree.ts';

/** Tells it of a hit by a ray in this direction, in the mesh's own space. */
export type Presence = (hit: MeshHit, direction: Vec3) => boolean;

/** null: it is there everywhere. */
export function presenceOf(
  mesh: Mesh,
  material: Material & MaterialLayers,
  baseColor: PreparedTexture | null,
): Presence | null {
  const oneSided = isOneSided(material);
  const doubted = mayBeMissing(material, mesh);
  if (!oneSided && !doubted) return null;
  const least = material.alphaMode === 'mask' ? (material.alphaCutoff ?? 0.5) : 0.5;
  return (hit, direction) => {
    if (oneSided && !(dot(normalOf(mesh, hit), direction) < 0)) return false;
    return !doubted || opacityAt(mesh, hit, material.opacity ?? 1, baseColor) >= least;
  };
}

/** Of any length. */
function normalOf({ positions, indices }: Mesh, { triangle }: MeshHit): Vec3 {
  const [a, b, c] = [0, 1, 2].map((k) => {
    const at = 3 * indices[3 * triangle + k]!;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!] as const;
  }) as [Vec3, Vec3, Vec3];
  return cross(subtract(b, a), subtract(c, a));
}

function opacityAt(mesh: Mesh, hit: MeshHit, opacity: number, baseColor: PreparedTexture | null): number {
  const { indices, colors } = mesh;
  const atVertices = colors
    ? hit.weights.reduce((sum, weight, k) => sum + weight * colors[4 * indices[3 * hit.triangle + k]! + 3]!, 0)
    : 1;
  return opacity * atVertices * texelOf(mesh, hit, baseColor)[3];
}
