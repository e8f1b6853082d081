/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter, or several. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes, oneSidedLamp } from '../scene/lamps.ts';
import type { Color, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf, lightTreeOf } from './geometry-packer.ts';
import { treeNodes } from './light-tree-size.ts';
import { emittersOf, LISTED_EMITTERS, type PackedEmitters, planEmitters } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
import { hasMeshes } from './refuse-meshes.ts';
import { refuseUndrawn } from './refuse-undrawn.ts';
import { surfaceValues } from './surface-values.ts';

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

/** Whether to pack it needs the part that packs meshes and trees over many lights. */
export const needsPacker = (scene: Scene): boolean => hasMeshes(scene) || planEmitters(scene).near > LISTED_EMITTERS; // biome-ignore format: one thought

export function packPathScene(scene: Scene, eye: Vec3, options: PackOptions = {}): PackedScene {
  refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const { far, near, glows } = planEmitters(scene);
  const packed = packScene(lamps.scene, eye, {
    ...options,
    leastRows: Math.max(far + near, 1),
    moreRows: near > LISTED_EMITTERS ? treeNodes(near) : 0,
    meshes: true,
  });
  const { table, shapeNames } = packed;
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const meshes = Object.entries(lamps.scene.shapes).flatMap(([name, shape]) =>
    shape.type === 'mesh' ? [{ shape, row: rows.get(name)!, glow: glows.get(name) ?? null }] : [],
  );
  const geometry = geometryOf(lamps.scene, meshes, eye);
  const glowing = new Map([...geometry.lamps].map(([row, emitters]) => [shapeNames[row]!, emitters]));
  const found = emittersOf(lamps, eye, (name) => rows.get(name)!, glowing);
  const tree = writeEmitters(packed, found);
  shapeNames.forEach((name, row) => {
    const shape = lamps.scene.shapes[name]!;
    const material = lamps.scene.materials[shape.material]!;
    const oneSided = lamps.lightOfShape.has(name) ? shape.type === 'quad' : oneSidedLamp(shape, material);
    writeRow(
      table,
      'Surface',
      row,
      surfaceValues(material, { emitter: found.emitterOfShape.get(name) ?? -1, oneSided }),
    );
  });
  return {
    ...packed,
    ...skyOf(scene.sky),
    ...tree,
    geometry,
    emitterCount: found.emitters.length,
    farEmitters: found.far,
  };
}

/** The emitters, and a tree over them where they are too many to look at each. */
function writeEmitters(
  { table, lightTree }: PackedScene,
  { emitters, far }: PackedEmitters,
): { lightTreeDepth: number } {
  const tree = emitters.length - far > LISTED_EMITTERS ? lightTreeOf(emitters, far) : null;
  emitters.forEach((values, row) => {
    const leaf = tree && row >= far ? tree.leaves[row - far]! : -1;
    writeRow(table, 'Emitter', row, { ...values, leaf });
  });
  tree?.nodes.forEach((values, k) => {
    writeRow(table, 'LightNode', lightTree + k, values);
  });
  return { lightTreeDepth: tree?.depth ?? 0 };
}
