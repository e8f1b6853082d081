/** Scene → the scene table for the path integrator: visible lights are shapes, and what shines is an emitter, or several. */

import { lacksMap } from '../scene/environment.ts';
import { lampsAsShapes } from '../scene/lamps.ts';
import { isLayered } from '../scene/layered.ts';
import type { Moment } from '../scene/motion.ts';
import type { Color, Material, MeshShape, Scene, Sky, Vec3 } from '../scene/scene.ts';
import type { EmitterValues } from './emitter-values.ts';
import { geometryOf, layerValuesOf, lightTreeOf, texturesOf } from './geometry-packer.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { COVER } from './layout.ts';
import { treeNodes } from './light-tree-size.ts';
import { emittersOf, LISTED_EMITTERS, planEmitters, seenFrom } from './pack-emitters.ts';
import { noEnvironment, packEnvironment } from './pack-environment.ts';
import { isPackedFrom, type PackedScene, type PackOptions, packScene, writeRow } from './pack-scene.ts';
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

/** Materials in use that have layers, each once. */
function layeredMaterials({ shapes, materials }: Scene): Material[] {
  const used = new Set(Object.values(shapes).map(({ material }) => materials[material]!));
  return [...used].filter(isLayered);
}

/** Whether to pack it needs the part that packs meshes, layers and trees over many lights. */
export const needsPacker = (scene: Scene): boolean =>
  hasMeshes(scene) || planEmitters(scene).near > LISTED_EMITTERS || layeredMaterials(scene).length > 0;

/** `moment`: the scene with its meshes, at the time that is to be seen. */
export function packPathScene(moment: Moment, eye: Vec3, options: PackOptions = {}): PackedScene {
  const { scene } = moment;
  const { reuse } = options;
  // Where nothing but meshes has moved the table holds what it should.
  const still = reuse && isPackedFrom(reuse, scene, eye, options);
  const packed = still ? reuse : packRows(scene, eye, options);
  const geometry = geometryOf(moment, packed.bodies!, eye, reuse?.geometry ?? null, options);
  const lit = still && packed.glowing === geometry.emitters ? packed : withEmitters(packed, geometry.emitters, eye);
  return { ...lit, geometry };
}

function packRows(scene: Scene, eye: Vec3, options: PackOptions): PackedScene {
  const { reuse } = options;
  // The same scene again: then nothing but the eye has moved, which meshes are not made of.
  const before = reuse?.source.surfaces && reuse.source.scene === scene ? reuse : null;
  if (!before) refuseUndrawn(scene);
  const lamps = lampsAsShapes(scene);
  const { far, near, glows } = planEmitters(scene);
  const layered = layeredMaterials(lamps.scene);
  const packed = packScene(lamps.scene, eye, {
    ...options,
    keepMeshes: before !== null,
    leastRows: Math.max(far + near, 1),
    // The tree over lights, and behind it the layers.
    moreRows: (near > LISTED_EMITTERS ? treeNodes(near) : 0) + layered.length,
    meshes: true,
  });
  const { table, shapeNames, shapeEnds } = packed;
  const layerRows = new Map(layered.map((material, index) => [material, packed.rows - layered.length + index]));
  for (const [material, row] of layerRows) writeRow(table, 'Layers', row, layerValuesOf(material));
  const rows = new Map(shapeNames.map((name, row) => [name, row]));
  const lights = emittersOf(lamps, eye, (name) => rows.get(name)!);
  const firstOfMesh = placesOf(glows, lights.emitters.length);
  const lampOf = (name: string): Lamp | null => {
    const emitter = lights.emitterOfShape.get(name);
    if (emitter !== undefined) return { emitter, oneSided: lights.emitters[emitter]!.oneSided === 1 };
    return firstOfMesh.has(name) ? { emitter: firstOfMesh.get(name)!, oneSided: glows.get(name)!.oneSided } : null;
  };
  shapeNames.slice(0, shapeEnds[3]).forEach((name, row) => {
    const material = materialOf(lamps.scene, name);
    writeRow(table, 'Surface', row, surfaceValues(material, lampOf(name), 0, layerRows.get(material)));
  });
  const { bodies, textures } = before ?? packMeshSurfaces(lamps.scene, packed, { lampOf, glows, layerRows });
  return {
    ...packed,
    ...skyOf(scene.sky),
    source: { ...packed.source, scene, surfaces: true },
    bodies,
    lights,
    textures,
  };
}

/** Number of the first emitter of each, as mesh-lamps.ts has them one after the other. */
function placesOf(glows: ReadonlyMap<string, MeshGlow>, first: number): Map<string, number> {
  let place = first;
  return new Map(
    [...glows].map(([name, { instances, clusters }]) => {
      place += instances * clusters;
      return [name, place - instances * clusters];
    }),
  );
}

/** The rows of all emitters written, and the tree over them where they are too many to look at each. `glowing`: those of meshes. */
function withEmitters(packed: PackedScene, glowing: readonly EmitterValues[], eye: Vec3): PackedScene {
  const { table, lightTree, source } = packed;
  const { emitters: others, far } = packed.lights!;
  const emitters = [...others, ...glowing.map((values) => seenFrom(eye, values))];
  const tree = emitters.length - far > LISTED_EMITTERS ? lightTreeOf(emitters, far) : null;
  emitters.forEach((values, row) => {
    const leaf = tree && row >= far ? tree.leaves[row - far]! : -1;
    writeRow(table, 'Emitter', row, { ...values, leaf });
  });
  tree?.nodes.forEach((values, k) => {
    writeRow(table, 'LightNode', lightTree + k, values);
  });
  return {
    ...packed,
    source: { ...source },
    glowing,
    emitterCount: emitters.length,
    farEmitters: far,
    lightTreeDepth: tree?.depth ?? 0,
  };
}

const materialOf = ({ shapes, materials }: Scene, name: string): Material => materials[shapes[name]!.material]!;

/** What surfaces of meshes and of formulas have in common. */
interface Shared {
  readonly lampOf: (name: string) => Lamp | null;
  readonly glows: ReadonlyMap<string, MeshGlow>;
  readonly layerRows: ReadonlyMap<Material, number>;
}

/** What meshes are made of, and the textures that it names. */
function packMeshSurfaces(
  scene: Scene,
  { table, shapeNames, shapeEnds }: PackedScene,
  { lampOf, glows, layerRows }: Shared,
) {
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
    writeRow(
      table,
      'Surface',
      first + i,
      surfaceValues(material, lampOf(name), rowOf.get(material), layerRows.get(material)),
    );
  });
  return {
    bodies: { first, covers: names.map(coverOf), glows: names.map((name) => glows.get(name) ?? null) },
    textures,
  };
}
