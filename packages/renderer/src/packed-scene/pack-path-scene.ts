/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import type { Moment } from '../scene/motion.ts';
import type { Color, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf } from './geometry-packer.ts';
import { emittersOf, MOST_EMITTERS } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { isPackedFrom, type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
import { refuseUndrawn } from './refuse-undrawn.ts';
import { type Lamp, surfaceValues } from './surface-values.ts';

/** A map is multiplied by the sky's colours: white where there is none, else by its scale. */
function skyOf({ horizon, zenith, image, map, scale = 1, rotation = 0 }: Sky) {
  if (!map) {
    if (lacksMap({ horizon, zenith, image })) throw new TypeError(`The sky's image "${image}" has not been loaded.`);
    return { horizon, zenith, environment: noEnvironment(), environmentTurn: 0 };
  }
  const factor: Color = [scale, scale, scale];
  const turns = rotation / 360;
  const environmentTurn = Math.fround(turns - Math.floor(turns)) % 1;
  return { horizon: factor, zenith: factor, environment: packEnvironment(map), environmentTurn };
}

/** `moment`: the scene with its meshes, at the time that is to be seen. */
export function packPathScene(moment: Moment, eye: Vec3, options: PackOptions = {}): PackedScene {
  const { scene } = moment;
  const { reuse } = options;
  // Where nothing but meshes has moved the table holds what it should.
  const packed = reuse && isPackedFrom(reuse, scene, eye, options) ? reuse : packRows(scene, eye, options);
  const firstBody = packed.shapeEnds[3];
  return { ...packed, geometry: geometryOf(moment, firstBody, eye, reuse?.geometry ?? null) };
}

function packRows(scene: Scene, eye: Vec3, options: PackOptions): PackedScene {
  refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const packed = packScene(lamps.scene, eye, { ...options, leastRows: MOST_EMITTERS, meshes: true });
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
  const source = { ...packed.source, scene, surfaces: true };
  return { ...packed, source, ...skyOf(scene.sky), emitterCount: emitters.length };
}
