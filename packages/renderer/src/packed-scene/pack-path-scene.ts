/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import type { Moment } from '../scene/motion.ts';
import type { Color, Material, MeshShape, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf, texturesOf } from './geometry-packer.ts';
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

/** `moment`: the scene with its meshes, at the time that is to be seen. */
export function packPathScene(moment: Moment, eye: Vec3, options: PackOptions = {}): PackedScene {
  const { scene } = moment;
  const { reuse } = options;
  // Where nothing but meshes has moved the table holds what it should.
  const packed = reuse && isPackedFrom(reuse, scene, eye, options) ? reuse : packRows(scene, eye, options);
  return { ...packed, geometry: geometryOf(moment, packed.bodies!, eye, reuse?.geometry ?? null) };
}

function packRows(scene: Scene, eye: Vec3, options: PackOptions): PackedScene {
  const { reuse } = options;
  // The same scene again: then nothing but the eye has moved, which meshes are not made of.
  const before = reuse?.source.surfaces && reuse.source.scene === scene ? reuse : null;
  if (!before) refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const keepMeshes = before !== null;
  const packed = packScene(lamps.scene, eye, { ...options, keepMeshes, leastRows: MOST_EMITTERS, meshes: true });
  const { table, shapeNames, shapeEnds } = packed;
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const { emitters, emitterOfShape } = emittersOf(lamps, eye, (name) => rows.get(name)!);
  const lampOf = (name: string): Lamp | null => {
    const emitter = emitterOfShape.get(name);
    return emitter === undefined ? null : { emitter, oneSided: emitters[emitter]!.oneSided === 1 };
  };
  shapeNames.slice(0, shapeEnds[3]).forEach((name, row) => {
    writeRow(table, 'Surface', row, surfaceValues(materialOf(lamps.scene, name), lampOf(name)));
  });
  emitters.forEach((values, row) => {
    writeRow(table, 'Emitter', row, values);
  });
  return {
    ...packed,
    ...skyOf(scene.sky),
    source: { ...packed.source, scene, surfaces: true },
    ...(before ? { bodies: before.bodies, textures: before.textures } : packMeshSurfaces(lamps.scene, packed)),
    emitterCount: emitters.length,
  };
}

const materialOf = ({ shapes, materials }: Scene, name: string): Material => materials[shapes[name]!.material]!;

/** What meshes are made of, and the textures that it names. */
function packMeshSurfaces(scene: Scene, { table, shapeNames, shapeEnds }: PackedScene) {
  const first = shapeEnds[3];
  const names = shapeNames.slice(first);
  const { textures, rowOf } = texturesOf(
    scene,
    names.map((name) => materialOf(scene, name)),
  );
  const coverOf = (name: string): number => {
    const material = materialOf(scene, name);
    const mesh = scene.meshes?.[(scene.shapes[name] as MeshShape).mesh]?.data;
    return (mayBeMissing(material, mesh) ? rowOf.get(material)! : 0) + (isOneSided(material) ? COVER.isOneSided : 0);
  };
  names.forEach((name, i) => {
    const material = materialOf(scene, name);
    writeRow(table, 'Surface', first + i, surfaceValues(material, null, rowOf.get(material)));
  });
  return { bodies: { first, covers: names.map(coverOf) }, textures };
}
