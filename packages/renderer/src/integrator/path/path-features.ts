/**
 * What a scene asks of the path kernel: the switches of shading/features.wesl. A program may have more than a scene needs; it then
 * draws the same picture more slowly.
 */

import { isLayered } from '../../packed-scene/layer-values.ts';
import { EMITTER_KIND, emittersOf } from '../../packed-scene/pack-emitters.ts';
import type { RendererSettings } from '../../renderer-types.ts';
import { lampsAsShapes } from '../../scene/lamps.ts';
import type { Camera, Material, Scene, Shape, ShapeType } from '../../scene/scene.ts';
import { FEATURES, type Feature } from '../../shading/features.ts';

/** What a film needs a program for. */
export interface PathDemand {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly settings: Pick<RendererSettings, 'pixelFilter'>;
}

export function pathFeatures({ scene, camera, settings }: PathDemand): ReadonlySet<Feature> {
  const lamps = lampsAsShapes(scene);
  const shapes = Object.values(lamps.scene.shapes);
  const materials = shapes.map((shape) => lamps.scene.materials[shape.material]!);
  const { emitters } = emittersOf(lamps, camera.eye, () => 0);
  const needs: Record<Feature, boolean> = {
    ...shapeFeatures(shapes),
    ...lightFeatures(emitters.map(({ kind }) => kind as number)),
    ...materialFeatures(materials),
    hasEnvironment: scene.sky.map !== undefined,
    hasLens: (camera.aperture ?? 0) > 0,
    hasOtherProjections: (camera.projection ?? 'perspective') !== 'perspective',
    hasFilter: settings.pixelFilter !== 'box',
  };
  return new Set(FEATURES.filter((feature) => needs[feature]));
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

function lightFeatures(kinds: readonly number[]) {
  const has = (...wanted: number[]) => kinds.some((kind) => wanted.includes(kind));
  return {
    hasSphereLights: has(EMITTER_KIND.sphere),
    hasQuadLights: has(EMITTER_KIND.quad),
    hasBoxLights: has(EMITTER_KIND.box),
    hasPointLights: has(EMITTER_KIND.point, EMITTER_KIND.spot),
    hasSuns: has(EMITTER_KIND.directional),
    hasSky: has(EMITTER_KIND.sky),
    hasManyLights: kinds.length > 1,
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
    hasIridescence: materials.some((material) => isLayered(material) && (material.iridescence?.weight ?? 0) > 0),
  };
}
