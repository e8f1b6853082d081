/** Which number a shape and its material have in films of what the camera sees first, and what the numbers stand for. */
import { lampsAsShapes } from '../../scene/lamps.ts';
import { formatPointer } from '../../scene/pointer.ts';
import type { Integrator, Scene } from '../../scene/scene.ts';
import { sceneSeenBy } from '../../scene/seen-by.ts';

/** The number of what is met → what it is, as a JSON Pointer into the scene file; 0, nothing, is null. */
export interface AovIds {
  readonly primitives: readonly (string | null)[];
  readonly materials: readonly (string | null)[];
  /** The number of a shape → that of its material. */
  readonly materialOf: readonly number[];
}

/** 1 is the first in the scene file; lamps come last. */
export function aovIds(scene: Scene, integrator: Integrator): AovIds {
  const { scene: seen, lightOfShape } = lampsAsShapes(sceneSeenBy(integrator, scene));
  // A lamp's material has the lamp's own name.
  const pointer = (group: string) => (name: string) => {
    const light = lightOfShape.get(name);
    return light === undefined ? formatPointer([group, name]) : formatPointer(['lights', light]);
  };
  const materialNames = Object.keys(seen.materials);
  const numbers = new Map(materialNames.map((name, index) => [name, index + 1]));
  return {
    primitives: [null, ...Object.keys(seen.shapes).map(pointer('shapes'))],
    materials: [null, ...materialNames.map(pointer('materials'))],
    materialOf: [0, ...Object.values(seen.shapes).map(({ material }) => numbers.get(material)!)],
  };
}
