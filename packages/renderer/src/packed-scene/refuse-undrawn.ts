/**
 * What a scene model may say and no kernel draws yet: some layers of glTF's materials, and textures on other shapes than meshes. A picture
 * without them would be a wrong one, so that such a scene is refused; docs/gltf.md has the list.
 */
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material, Scene, Shape } from '../scene/scene.ts';
import { UntraceableSceneError } from './refuse-meshes.ts';
import { mayBeMissing } from './texture-slots.ts';

type Layered = Material & MaterialLayers;
type Layer = keyof MaterialLayers;
/** Whether what stands there makes a difference to the picture. */
type Counts<Key extends Layer = Layer> = { readonly [K in Key]?: (material: Layered) => boolean };

/** On any shape. */
const UNDRAWN: Counts = {
  dispersion: ({ dispersion = 0 }) => dispersion > 0,
  specularLobe: () => true,
  transmission: ({ transmission }) => transmission!.weight > 0,
  // Volumes count with transmission only.
  diffuseTransmission: ({ diffuseTransmission }) => diffuseTransmission!.weight > 0,
  clearcoat: ({ clearcoat }) => clearcoat!.weight > 0,
  sheen: ({ sheen }) => sheen!.color.some((x) => x > 0),
  anisotropy: ({ anisotropy }) => anisotropy!.strength > 0,
  iridescence: ({ iridescence }) => iridescence!.weight > 0,
};

/** On shapes that a formula describes, which have no texture coordinates and are there on both sides of all places. */
const UNDRAWN_BUT_ON_MESHES: Counts = {
  alphaMode: (material) => mayBeMissing(material, undefined),
  baseColorTexture: () => true,
  metallicRoughnessTexture: ({ unlit = false }) => !unlit,
  normalTexture: ({ unlit = false }) => !unlit,
  emissionTexture: ({ emission, unlit = false }) => !unlit && emission.some((x) => x > 0),
};

const found = (undrawn: Counts, material: Layered): string[] =>
  Object.entries(undrawn)
    .filter(([key, counts]) => material[key as Layer] !== undefined && counts(material))
    .map(([key]) => key);

/** Names of all that the material has and no kernel draws. */
export const undrawnOf = (material: Layered): string[] => found(UNDRAWN, material);

/** Throws when a shape has a material, or a mesh, of which something would be missing in the picture. */
export function refuseUndrawn(scene: Scene): void {
  for (const [name, shape] of Object.entries(scene.shapes)) {
    const material = scene.materials[shape.material]!;
    const undrawn = undrawnOf(material);
    if (undrawn.length > 0)
      throw new UntraceableSceneError(
        `The material "${shape.material}" has ${undrawn.join(', ')}, which this version reads and does not draw yet.`,
      );
    if (shape.type === 'mesh') refuseFramelessMap(scene, shape, material);
    else refuseOnFormula(name, shape, material);
  }
}

function refuseOnFormula(name: string, { type, material: materialName }: Shape, material: Layered): void {
  const undrawn = found(UNDRAWN_BUT_ON_MESHES, material);
  if (undrawn.length > 0)
    throw new UntraceableSceneError(
      `The material "${materialName}" has ${undrawn.join(', ')}, and the shape "${name}" is a ${type}: only meshes have textures and opacity.`,
    );
}

/** A normal map's directions are those of a frame of tangents. Meshes of glTF files have one, or get one when they are read. */
function refuseFramelessMap({ meshes = {} }: Scene, shape: Shape & { type: 'mesh' }, material: Layered): void {
  const { data } = meshes[shape.mesh]!;
  if (material.normalTexture && !material.unlit && data && !data.tangents)
    throw new UntraceableSceneError(
      `The material "${shape.material}" has normalTexture, and the mesh "${shape.mesh}" has no tangents, which its directions count from.`,
    );
}
