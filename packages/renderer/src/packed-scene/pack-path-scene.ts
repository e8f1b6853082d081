/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter, or several. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import { meshShapes } from '../scene/placed.ts';
import type { Color, Material, MeshShape, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { geometryOf, lightTreeOf, texturesOf } from './geometry-packer.ts';
import { COVER } from './layout.ts';
import { treeNodes } from './light-tree-size.ts';
import { emittersOf, LISTED_EMITTERS, type PackedEmitters, planEmitters } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
import { hasMeshes } from './refuse-meshes.ts';
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
  const { shapes } = lamps.scene;
  const materialOf = (name: string) => lamps.scene.materials[shapes[name]!.material]!;
  const onMeshes = shapeNames.filter((name) => shapes[name]!.type === 'mesh').map(materialOf);
  const { textures, rowOf } = texturesOf(scene, onMeshes);
  const coverOf = ({ mesh }: MeshShape, material: Material) =>
    (mayBeMissing(material, scene.meshes?.[mesh]?.data) ? rowOf.get(material)! : 0) +
    (isOneSided(material) ? COVER.isOneSided : 0);
  const meshes = meshShapes(lamps.scene).map(([name, shape]) => ({
    shape,
    row: rows.get(name)!,
    cover: coverOf(shape, materialOf(name)),
    glow: glows.get(name) ?? null,
  }));
  const geometry = geometryOf(lamps.scene, meshes, eye);
  const glowing = new Map([...geometry.lamps].map(([row, emitters]) => [shapeNames[row]!, emitters]));
  const found = emittersOf(lamps, eye, (name) => rows.get(name)!, glowing);
  const lampOf = (name: string): Lamp | null => {
    const emitter = found.emitterOfShape.get(name);
    return emitter === undefined ? null : { emitter, oneSided: found.emitters[emitter]!.oneSided === 1 };
  };
  shapeNames.forEach((name, row) => {
    const material = materialOf(name);
    writeRow(table, 'Surface', row, surfaceValues(material, lampOf(name), rowOf.get(material)));
  });
  return {
    ...packed,
    ...skyOf(scene.sky),
    ...writeEmitters(packed, found),
    geometry,
    textures,
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
