/**
 * What a scene asks of the path kernel: the switches of shading/features.wesl. A program may have more than a scene needs; it then
 * draws the same picture more slowly.
 */
import { EMITTER_KIND } from '../../packed-scene/emitter-values.ts';
import { TEXTURE_SLOTS } from '../../packed-scene/layout.ts';
import { type EmitterPlan, LISTED_EMITTERS, planEmitters } from '../../packed-scene/pack-emitters.ts';
import { isOneSided, mayBeMissing, slotsOf } from '../../packed-scene/texture-slots.ts';
import type { RendererSettings } from '../../renderer-types.ts';
import { lampsAsShapes } from '../../scene/lamps.ts';
import { bendsCoatApart, hasCoat, hasGrain, hasSheen, isClear, isLayered } from '../../scene/layered.ts';
import { meshShapes } from '../../scene/placed.ts';
import type { Camera, Material, MeshShape, Scene, Shape, ShapeType } from '../../scene/scene.ts';
import type { Texture } from '../../scene/textures.ts';
import { FEATURES, type Feature } from '../../shading/features.ts';

/** What a film needs a program for. */
export interface PathDemand {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Pick<RendererSettings, 'pixelFilter'>;
}

/** What a scene asks for; one does not change. */
const known = new WeakMap<Scene, Partial<Record<Feature, boolean>>>();

export function pathFeatures({ scene, camera, settings }: PathDemand): ReadonlySet<Feature> {
  let ofScene = known.get(scene);
  if (!ofScene) known.set(scene, (ofScene = sceneFeatures(scene)));
  const needs: Partial<Record<Feature, boolean>> = {
    ...ofScene,
    hasLens: (camera.aperture ?? 0) > 0,
    hasOtherProjections: (camera.projection ?? 'perspective') !== 'perspective',
    hasFilter: settings.pixelFilter !== 'box',
  };
  return new Set(FEATURES.filter((feature) => needs[feature]));
}

function sceneFeatures(scene: Scene) {
  const lamps = lampsAsShapes(scene);
  const shapes = Object.values(lamps.scene.shapes);
  const materials = shapes.map((shape) => lamps.scene.materials[shape.material]!);
  return {
    ...shapeFeatures(shapes),
    ...lightFeatures(planEmitters(scene)),
    ...materialFeatures(materials),
    ...meshFeatures(lamps.scene, meshShapes(lamps.scene)),
    hasEnvironment: scene.sky.map !== undefined,
  };
}

function shapeFeatures(shapes: readonly Shape[]) {
  const has = (type: ShapeType) => shapes.some((shape) => shape.type === type);
  return {
    hasSpheres: has('sphere'),
    hasBoxes: has('box'),
    hasTurnedBoxes: shapes.some((shape) => shape.type === 'box' && shape.rotation.some((angle) => angle !== 0)),
    hasQuads: has('quad'),
    hasPlanes: has('plane'),
    hasMeshes: has('mesh'),
  };
}

function meshFeatures({ materials, meshes = {}, textures = {} }: Scene, shapes: readonly [string, MeshShape][]) {
  const all = shapes.map(([, { material, mesh }]) => [materials[material]!, meshes[mesh]?.data] as const);
  const hasColors = all.some(([, mesh]) => mesh?.colors !== undefined);
  const grain = all.some(([material]) => hasGrain(material));
  const slots = all.flatMap(([material]) => slotsOf(material));
  const bends: number[] = [TEXTURE_SLOTS.normalSlot, TEXTURE_SLOTS.coatNormalSlot];
  return {
    // What needs frames of tangents needs what lies at the vertices for textures.
    hasTextures: slots.length > 0 || hasColors || grain,
    hasNormalMaps: slots.some(({ slot }) => bends.includes(slot)) || grain,
    hasVertexMore: slots.some(({ use }) => use.uvSet === 1) || hasColors,
    hasOtherLookups: slots.some(({ use }) => isLookedUpOtherwise(textures[use.texture]!)),
    hasOneSided: all.some(([material]) => isOneSided(material)),
    hasCutouts: all.some(([material, mesh]) => mayBeMissing(material, mesh)),
  };
}

/** Than repeated and linearly. */
const isLookedUpOtherwise = ({ wrapU = 'repeat', wrapV = 'repeat', filter = 'linear' }: Texture) =>
  wrapU !== 'repeat' || wrapV !== 'repeat' || filter !== 'linear';

function lightFeatures({ kinds, far, near, glows }: EmitterPlan) {
  const has = (...wanted: number[]) => wanted.some((kind) => kinds.has(kind));
  return {
    hasSphereLights: has(EMITTER_KIND.sphere),
    hasQuadLights: has(EMITTER_KIND.quad),
    hasBoxLights: has(EMITTER_KIND.box),
    hasPointLights: has(EMITTER_KIND.point, EMITTER_KIND.spot),
    hasSuns: has(EMITTER_KIND.directional),
    hasSky: has(EMITTER_KIND.sky),
    hasManyLights: far + near > 1,
    hasMeshLamps: has(EMITTER_KIND.mesh),
    hasLightTree: near > LISTED_EMITTERS,
    hasVariedLamps: [...glows.values()].some(({ texture, mayBeMissing }) => texture !== null || mayBeMissing),
  };
}

function materialFeatures(materials: readonly Material[]) {
  const has = (type: Material['type']) => materials.some((material) => material.type === type);
  return {
    hasMirrorLayers: materials.some(({ reflectivity }) => reflectivity > 0),
    hasMetallicRoughness: has('metallicRoughness'),
    hasConductors: has('conductor'),
    hasGlass: has('dielectric'),
    hasCompensation: materials.some(({ energyCompensation }) => energyCompensation),
    hasLayers: materials.some(isLayered),
    hasCoats: materials.some(hasCoat),
    hasSheen: materials.some(hasSheen),
    hasGrain: materials.some(hasGrain),
    hasTransmission: materials.some(isClear),
    hasCoatNormals: materials.some(bendsCoatApart),
    hasIridescence: materials.some((material) => isLayered(material) && (material.iridescence?.weight ?? 0) > 0),
  };
}
