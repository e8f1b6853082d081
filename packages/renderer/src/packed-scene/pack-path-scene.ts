/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import { isLayered } from '../scene/layered.ts';
import type { Moment } from '../scene/motion.ts';
import { meshShapes } from '../scene/placed.ts';
import type { Color, Material, MeshShape, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf, texturesOf } from './geometry-packer.ts';
import { layerValues } from './layer-values.ts';
import { COVER } from './layout.ts';
import { emittersOf, MOST_EMITTERS } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { isPackedFrom, type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
import { refuseUndrawn } from './refuse-undrawn.ts';
import { type Lamp, surfaceValues } from './surface-values.ts';
import { isOneSided, mayBeMissing } from './texture-slots.ts';

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

/** Materials in use that have layers, each once. */
function layeredMaterials({ shapes, materials }: Scene): Material[] {
  const used = new Set(Object.values(shapes).map(({ material }) => materials[material]!));
  return [...used].filter(isLayered);
}

/** `moment`: the scene with its meshes, at the time that is to be seen. */
export function packPathScene(moment: Moment, eye: Vec3, options: PackOptions = {}): PackedScene {
  const { scene } = moment;
  const { reuse } = options;
  // Where nothing but meshes has moved the table holds what it should.
  const packed = reuse && isPackedFrom(reuse, scene, eye, options) ? reuse : packRows(scene, eye, options);
  return { ...packed, geometry: geometryOf(moment, packed.bodies!, eye, reuse?.geometry ?? null) };
}

function packRows(scene: Scene, eye: Vec3, options: PackOptions): PackedScene {
  refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const layered = layeredMaterials(lamps.scene);
  const moreRows = layered.length;
  const packed = packScene(lamps.scene, eye, { ...options, leastRows: MOST_EMITTERS, moreRows, meshes: true });
  const { table, shapeNames } = packed;
  const layerRows = new Map(layered.map((material, index) => [material, packed.rows - moreRows + index]));
  for (const [material, row] of layerRows) writeRow(table, 'Layers', row, layerValues(material));
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const { emitters, emitterOfShape } = emittersOf(lamps, eye, (name) => rows.get(name)!);
  const lampOf = (name: string): Lamp | null => {
    const emitter = emitterOfShape.get(name);
    return emitter === undefined ? null : { emitter, oneSided: emitters[emitter]!.oneSided === 1 };
  };
  const { shapes } = lamps.scene;
  const materialOf = (name: string) => lamps.scene.materials[shapes[name]!.material]!;
  const onMeshes = shapeNames.filter((name) => shapes[name]!.type === 'mesh').map(materialOf);
  const { textures, rowOf } = texturesOf(scene, onMeshes);
  const coverOf = ({ mesh }: MeshShape, material: Material) =>
    (mayBeMissing(material, scene.meshes?.[mesh]?.data) ? rowOf.get(material)! : 0) +
    (isOneSided(material) ? COVER.isOneSided : 0);
  shapeNames.forEach((name, row) => {
    const material = materialOf(name);
    writeRow(
      table,
      'Surface',
      row,
      surfaceValues(material, lampOf(name), rowOf.get(material), layerRows.get(material)),
    );
  });
  emitters.forEach((values, row) => {
    writeRow(table, 'Emitter', row, values);
  });
  const covers = meshShapes(lamps.scene).map(([name, shape]) => coverOf(shape, materialOf(name)));
  return {
    ...packed,
    ...skyOf(scene.sky),
    source: { ...packed.source, scene, surfaces: true },
    bodies: { first: packed.shapeEnds[3], covers },
    textures,
    emitterCount: emitters.length,
  };
}
