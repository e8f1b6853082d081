/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import type { Color, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf } from './geometry-packer.ts';
import { isLayered, layerValues } from './layer-values.ts';
import { emittersOf, MOST_EMITTERS } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
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

/** Names of materials in use that have layers. */
function layeredMaterials({ shapes, materials }: Scene): string[] {
  const used = new Set(Object.values(shapes).map(({ material }) => material));
  return [...used].filter((name) => isLayered(materials[name]!));
}

export function packPathScene(scene: Scene, eye: Vec3, options: PackOptions = {}): PackedScene {
  refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const layered = layeredMaterials(lamps.scene);
  const moreRows = layered.length;
  const packed = packScene(lamps.scene, eye, { ...options, leastRows: MOST_EMITTERS, moreRows, meshes: true });
  const { table, shapeNames } = packed;
  const layerRows = new Map(layered.map((name, index) => [name, packed.rows - moreRows + index]));
  for (const [name, row] of layerRows) writeRow(table, 'Layers', row, layerValues(lamps.scene.materials[name]!));
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const { emitters, emitterOfShape } = emittersOf(lamps, eye, (name) => rows.get(name)!);
  const lampOf = (name: string): Lamp | null => {
    const emitter = emitterOfShape.get(name);
    return emitter === undefined ? null : { emitter, oneSided: emitters[emitter]!.oneSided === 1 };
  };
  shapeNames.forEach((name, row) => {
    const { material } = lamps.scene.shapes[name]!;
    const values = surfaceValues(lamps.scene.materials[material]!, lampOf(name), layerRows.get(material));
    writeRow(table, 'Surface', row, values);
  });
  emitters.forEach((values, row) => {
    writeRow(table, 'Emitter', row, values);
  });
  const meshes = Object.entries(lamps.scene.shapes).flatMap(([name, shape]) =>
    shape.type === 'mesh' ? [{ shape, row: rows.get(name)! }] : [],
  );
  const geometry = geometryOf(lamps.scene, meshes, eye);
  return { ...packed, ...skyOf(scene.sky), geometry, emitterCount: emitters.length };
}
