/** The scene as renderers want it: nothing hangs on nodes, joints or weights any more. */

import { sceneAt } from './animation.ts';
import { deform, isDeformable, jointMatrices, makeDeformed } from './deform.ts';
import type { Mesh } from './mesh.ts';
import { type NodeTransforms, nodeTransforms } from './node-transforms.ts';
import { meshShapes, placedSceneAt } from './placed.ts';
import type { MeshShape, Scene } from './scene.ts';

/**
 * The scene at a time, with everything that nodes carry put into the world, and meshes in the form that joints and weights give them
 * then: such a mesh is a new one at every time. Throws as `placedSceneAt` does.
 */
export function posedSceneAt(scene: Scene, time: number): Scene {
  const placed = placedSceneAt(scene, time);
  if (scene.nodes === undefined) return placed;
  const bent = meshShapes(scene).filter(([, { mesh }]) => isBent(scene.meshes?.[mesh]?.data));
  if (bent.length === 0) return placed;
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  const now = sceneAt(scene, time);
  const shapes: Record<string, Scene['shapes'][string]> = Object.assign(Object.create(null), placed.shapes);
  const meshes = Object.assign(Object.create(null), placed.meshes) as Record<string, { data: Mesh }>;
  for (const [name, shape] of bent) {
    const mesh = unused(`${shape.mesh} of ${name}`, meshes);
    meshes[mesh] = { data: bentMesh(now, shape, scene.meshes![shape.mesh]!.data!, transforms, world) };
    shapes[name] = { ...shapes[name]!, mesh } as MeshShape;
  }
  return { ...placed, shapes, meshes };
}

const isBent = (mesh: Mesh | undefined): boolean => mesh !== undefined && isDeformable(mesh);

function bentMesh(now: Scene, shape: MeshShape, mesh: Mesh, transforms: NodeTransforms, world: Float64Array): Mesh {
  const { nodes = {}, skins = {} } = now;
  const weights = shape.node === undefined ? undefined : nodes[shape.node]?.weights;
  const skin = shape.skin === undefined ? undefined : skins[shape.skin];
  const out = makeDeformed(mesh);
  deform(mesh, { ...(weights && { weights }), ...(skin && { joints: jointMatrices(skin, transforms, world) }) }, out);
  const { skin: _, morphTargets: __, ...rest } = mesh;
  return { ...rest, ...out };
}

function unused(name: string, taken: object): string {
  let free = name;
  for (let n = 2; free in taken; n++) free = `${name} ${n}`;
  return free;
}
