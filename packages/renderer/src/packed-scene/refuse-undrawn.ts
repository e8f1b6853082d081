/**
 * What a scene model may say and no kernel draws: textures on other shapes than meshes, and such that need what a mesh has not. A picture
 * without them would be a wrong one, so that such a scene is refused.
 */

import { hasCoat, isClear, isLayered } from '../scene/layered.ts';
import type { MaterialLayers } from '../scene/material-layers.ts';
import type { Material, Scene, Shape } from '../scene/scene.ts';
import { UntraceableSceneError } from './refuse-meshes.ts';
import { mayBeMissing } from './texture-slots.ts';

type Layered = Material & MaterialLayers;
type Layer = keyof MaterialLayers;
/** Whether what stands there makes a difference to the picture. */
type Counts<Key extends Layer = Layer> = { readonly [K in Key]?: (material: Layered) => boolean };

/** The groups that may have textures in them that count. */
const LAYER_GROUPS = [
  'specularLobe',
  'transmission',
  'diffuseTransmission',
  'clearcoat',
  'sheen',
  'anisotropy',
  'iridescence',
] as const satisfies readonly Layer[];
const isTextured = (group: object): boolean => Object.keys(group).some((key) => key.toLowerCase().endsWith('texture'));

/** On shapes that a formula describes, which have no texture coordinates and are there on both sides of all places. */
const UNDRAWN_BUT_ON_MESHES: Counts = {
  alphaMode: (material) => mayBeMissing(material, undefined),
  baseColorTexture: () => true,
  metallicRoughnessTexture: ({ unlit = false }) => !unlit,
  normalTexture: ({ unlit = false }) => !unlit,
  emissionTexture: ({ emission, unlit = false }) => !unlit && emission.some((x) => x > 0),
  ...Object.fromEntries(
    LAYER_GROUPS.map((group) => [group, (material: Layered) => isLayered(material) && isTextured(material[group]!)]),
  ),
};

const found = (undrawn: Counts, material: Layered): string[] =>
  Object.entries(undrawn)
    .filter(([key, counts]) => material[key as Layer] !== undefined && counts(material))
    .map(([key]) => key);

/** Throws when a shape has a material, or a mesh, of which something would be missing in the picture. */
export function refuseUndrawn(scene: Scene): void {
  for (const [name, shape] of Object.entries(scene.shapes)) {
    const material = scene.materials[shape.material]!;
    if (shape.type === 'plane' && isClear(material))
      throw new UntraceableSceneError(
        `The plane "${name}" is made of "${shape.material}", which light goes through, but a plane lets nothing through; please use a box or a quad.`,
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

/** Directions in normal maps and in those of a grain count from a frame of tangents. Meshes of glTF files have one, or get one when they are read. */
function refuseFramelessMap({ meshes = {} }: Scene, shape: Shape & { type: 'mesh' }, material: Layered): void {
  const { data } = meshes[shape.mesh]!;
  const map = material.normalTexture
    ? 'normalTexture'
    : hasCoat(material) && material.clearcoat?.normalTexture
      ? 'clearcoat.normalTexture'
      : material.anisotropy?.texture
        ? 'anisotropy.texture'
        : null;
  if (map && !material.unlit && data && !data.tangents)
    throw new UntraceableSceneError(
      `The material "${shape.material}" has ${map}, and the mesh "${shape.mesh}" has no tangents, which its directions count from.`,
    );
}
