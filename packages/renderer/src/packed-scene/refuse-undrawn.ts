/**
 * What a scene model may say and no kernel draws yet: textures, colours of vertices, and the layers of glTF's materials. A picture without
 * them would be a wrong one, so that such a scene is refused; docs/gltf.md has the list.
 */
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material, Scene } from '../scene/scene.ts';
import { UntraceableSceneError } from './refuse-meshes.ts';

/** Whether what stands there makes a difference to the picture. */
const UNDRAWN: { readonly [Key in keyof MaterialLayers]-?: ((material: Material & MaterialLayers) => boolean) | null } =
  {
    baseColorTexture: () => true,
    metallicRoughnessTexture: () => true,
    normalTexture: () => true,
    emissionTexture: ({ emission }) => emission.some((x) => x > 0),
    occlusionTexture: null,
    opacity: null,
    alphaMode: ({ alphaMode, opacity = 1, alphaCutoff = 0.5 }) =>
      alphaMode === 'mask' ? opacity < alphaCutoff : alphaMode === 'blend' && opacity < 1,
    alphaCutoff: null,
    // Drawn from both sides, as all shapes are.
    doubleSided: null,
    unlit: ({ unlit }) => unlit === true,
    emissionStrength: null,
    dispersion: ({ dispersion = 0 }) => dispersion > 0,
    specularLobe: () => true,
    transmission: ({ transmission }) => transmission!.weight > 0,
    // Counts with transmission only.
    volume: null,
    diffuseTransmission: ({ diffuseTransmission }) => diffuseTransmission!.weight > 0,
    clearcoat: ({ clearcoat }) => clearcoat!.weight > 0,
    sheen: ({ sheen }) => sheen!.color.some((x) => x > 0),
    anisotropy: ({ anisotropy }) => anisotropy!.strength > 0,
    iridescence: ({ iridescence }) => iridescence!.weight > 0,
  };

/** Names of all that the material has and no kernel draws. */
export function undrawnOf(material: Material & MaterialLayers): string[] {
  return Object.entries(UNDRAWN)
    .filter(([key, counts]) => material[key as keyof MaterialLayers] !== undefined && counts?.(material))
    .map(([key]) => key);
}

/** Throws when a shape has a material, or a mesh, of which something would be missing in the picture. */
export function refuseUndrawn({ shapes, materials, meshes = {} }: Scene): void {
  for (const shape of Object.values(shapes)) {
    const undrawn = undrawnOf(materials[shape.material]!);
    if (undrawn.length > 0)
      throw new UntraceableSceneError(
        `The material "${shape.material}" has ${undrawn.join(', ')}, which this version reads and does not draw yet.`,
      );
    if (shape.type === 'mesh' && meshes[shape.mesh]?.data?.colors)
      throw new UntraceableSceneError(
        `The mesh "${shape.mesh}" has colours at its vertices, which this version reads and does not draw yet.`,
      );
  }
}
