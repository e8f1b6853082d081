/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter. */
import { lampsAsShapes } from '../scene/lamps.ts';
import type { Scene, Vec3 } from '../scene/scene.ts';
import { emittersOf, MOST_EMITTERS } from './pack-emitters.ts';
import { type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
import { type Lamp, surfaceValues } from './surface-values.ts';

export function packPathScene(scene: Scene, eye: Vec3, options: PackOptions = {}): PackedScene {
  const lamps = lampsAsShapes(scene);
  const packed = packScene(lamps.scene, eye, { ...options, leastRows: MOST_EMITTERS });
  const { table, shapeNames } = packed;
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const { emitters, emitterOfShape } = emittersOf(lamps, eye, (name) => rows.get(name)!);
  const lampOf = (name: string): Lamp | null => {
    const emitter = emitterOfShape.get(name);
    return emitter === undefined ? null : { emitter, oneSided: emitters[emitter]!.oneSided === 1 };
  };
  shapeNames.forEach((name, row) => {
    const material = lamps.scene.materials[lamps.scene.shapes[name]!.material]!;
    writeRow(table, 'Surface', row, surfaceValues(material, lampOf(name)));
  });
  emitters.forEach((values, row) => {
    writeRow(table, 'Emitter', row, values);
  });
  return { ...packed, emitterCount: emitters.length };
}
