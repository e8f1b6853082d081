/**
 * What a scene model may say and no kernel draws yet: textures and colours of vertices. A picture without
 * them would be a wrong one, so that such a scene is refused; docs/gltf.md has the list.
 */
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material, Scene } from '../scene/scene.ts';
import { isClear } from './layer-values.ts';
import { UntraceableSceneError } from './refuse-meshes.ts';

/** Whether what stands there makes a difference to the picture that is missing. Of groups only textures are, see below. */
const UNDRAWN: { readonly [Key in keyof MaterialLayers]?: (material: Material & MaterialLayers) => boolean } = {
  baseColorTexture: () => true,
  metallicRoughnessTexture: () => true,
  normalTexture: () => true,
  emissionTexture: ({ emission }) => emission.some((x) => x > 0),
  alphaMode: ({ alphaMode, opacity = 1, alphaCutoff = 0.5 }) =>
    alphaMode === 'mask' ? opacity < alphaCutoff : alphaMode === 'blend' && opacity < 1,
};

/** The groups that may have textures in them. Rays find out themselves how thick a volume is. */
const GROUPS = [
  'specularLobe',
  'transmission',
  'diffuseTransmission',
  'clearcoat',
  'sheen',
  'anisotropy',
  'iridescence',
] as const satisfies readonly (keyof MaterialLayers)[];

const isTexture = (key: string): boolean => key.toLowerCase().endsWith('texture');

/** Names of all that the material has and no kernel draws. */
export function undrawnOf(material: Material & MaterialLayers): string[] {
  const own = Object.entries(UNDRAWN)
    .filter(([key, counts]) => material[key as keyof MaterialLayers] !== undefined && counts(material))
    .map(([key]) => key);
  const inGroups = GROUPS.flatMap((group) =>
    Object.keys(material[group] ?? {}).flatMap((key) => (isTexture(key) ? [`${group}.${key}`] : [])),
  );
  return [...own, ...inGroups];
}

/** Throws when a shape has a material, or a mesh, of which something would be missing in the picture. */
export function refuseUndrawn({ shapes, materials, meshes = {} }: Scene): void {
  for (const shape of Object.values(shapes)) {
    const undrawn = undrawnOf(materials[shape.material]!);
    if (undrawn.length > 0)
      throw new UntraceableSceneError(
        `The material "${shape.material}" has ${undrawn.join(', ')}, which this version reads and does not draw yet.`,
      );
    if (shape.type === 'plane' && isClear(materials[shape.material]!))
      throw new UntraceableSceneError(
        `A plane is made of "${shape.material}", which light goes through, but a plane lets nothing through; please use a box or a quad.`,
      );
    if (shape.type === 'mesh' && meshes[shape.mesh]?.data?.colors)
      throw new UntraceableSceneError(
        `The mesh "${shape.mesh}" has colours at its vertices, which this version reads and does not draw yet.`,
      );
  }
}
