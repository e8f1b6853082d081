/** How much room a scene takes. */
import { AFFINE_LENGTH, type Numbers } from './affine.ts';
import { sceneAt } from './animation.ts';
import { type Bounds, boundsOf, cornersOf } from './bounds.ts';
import { deform, isDeformable, jointMatrices, makeDeformed } from './deform.ts';
import type { Mesh } from './mesh.ts';
import { nodeTransforms, worldOf } from './node-transforms.ts';
import { meshMatrices, meshShapes, placedShape } from './placed.ts';
import type { MeshShape, Scene, Shape, Vec3 } from './scene.ts';
import { add, rotate } from './vec3.ts';

/** Calls `visit` with points whose hull holds everything of the scene that has an end: vertices of meshes, corners of the rest. */
export type PointVisitor = (x: number, y: number, z: number) => void;

/** The box around all shapes at a time, bent and morphed as they are then; null when nothing has an end. Planes and lights do not count. */
export function boundsAt(scene: Scene, time: number): Bounds | null {
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  visitPoints(scene, time, (x, y, z) => {
    if (x < min[0]) min[0] = x;
    if (y < min[1]) min[1] = y;
    if (z < min[2]) min[2] = z;
    if (x > max[0]) max[0] = x;
    if (y > max[1]) max[1] = y;
    if (z > max[2]) max[2] = z;
  });
  return min[0] <= max[0] ? { min, max } : null;
}

/** Meshes of so many instances are visited by the corners of their boxes alone. */
const MOST_EXACT_INSTANCES = 16;

export function visitPoints(scene: Scene, time: number, visit: PointVisitor): void {
  const now = sceneAt(scene, time);
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  for (const [name, shape] of Object.entries(now.shapes as Readonly<Record<string, Shape | MeshShape>>)) {
    if (shape.type === 'mesh') continue;
    const placed = shape.node === undefined ? shape : placedShape(shape, worldOf(transforms, world, shape.node), name);
    for (const [x, y, z] of corners(placed)) visit(x, y, z);
  }
  visitMeshes(scene, time, ({ positions, indices, matrices }) => visitMesh(positions, indices, matrices, visit));
}

/** A mesh as it is at a time: vertices in its own space, and where each of its instances lies in the world, 12 numbers each (`Affine`). */
export interface PosedMesh {
  readonly shape: MeshShape;
  readonly positions: Float32Array;
  readonly indices: Uint32Array;
  readonly matrices: Float64Array;
}

export function visitMeshes(scene: Scene, time: number, visit: (mesh: PosedMesh) => void): void {
  const now = sceneAt(scene, time);
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  for (const [, shape] of meshShapes(now)) {
    const mesh = now.meshes?.[shape.mesh]?.data;
    if (mesh === undefined) continue;
    const skin = shape.skin === undefined ? undefined : now.skins?.[shape.skin];
    const joints = skin && mesh.skin ? jointMatrices(skin, transforms, world) : undefined;
    const weights = shape.node === undefined ? undefined : now.nodes?.[shape.node]?.weights;
    const positions = isDeformable(mesh) ? bent(mesh, { joints, weights }) : mesh.positions;
    visit({ shape, positions, indices: mesh.indices, matrices: meshMatrices(shape, worldOf(transforms, world, shape.node)) }); // biome-ignore format: one line
  }
}

function bent(
  mesh: Mesh,
  pose: { joints?: Float32Array | undefined; weights?: readonly number[] | undefined },
): Float32Array {
  const { positions, indices, skin, morphTargets } = mesh;
  const bare: Mesh = { positions, indices, skin, morphTargets };
  const out = makeDeformed(bare);
  deform(bare, { joints: pose.joints, weights: pose.weights }, out);
  return out.positions;
}

/** Only vertices that a triangle uses. */
function visitMesh(positions: Float32Array, indices: Uint32Array, matrices: Float64Array, visit: PointVisitor): void {
  const used = new Uint8Array(positions.length / 3);
  for (let i = 0; i < indices.length; i++) used[indices[i]!] = 1;
  const many = matrices.length / AFFINE_LENGTH > MOST_EXACT_INSTANCES;
  const points = many ? Float32Array.from(cornersOf(boundsOf(positions, used)).flat()) : positions;
  for (let m = 0; m < matrices.length; m += AFFINE_LENGTH)
    for (let p = 0; p < points.length; p += 3)
      if (points !== positions || used[p / 3])
        visitPlaced(matrices, m, points[p]!, points[p + 1]!, points[p + 2]!, visit);
}

function visitPlaced(m: Numbers, at: number, x: number, y: number, z: number, visit: PointVisitor): void {
  visit(
    m[at]! * x + m[at + 1]! * y + m[at + 2]! * z + m[at + 3]!,
    m[at + 4]! * x + m[at + 5]! * y + m[at + 6]! * z + m[at + 7]!,
    m[at + 8]! * x + m[at + 9]! * y + m[at + 10]! * z + m[at + 11]!,
  );
}

function corners(shape: Shape | MeshShape): Vec3[] {
  const signs = [-1, 1] as const;
  const cube = signs.flatMap((x) => signs.flatMap((y) => signs.map((z): Vec3 => [x, y, z])));
  switch (shape.type) {
    case 'sphere':
      return cube.map(([x, y, z]) => add(shape.center, [x * shape.radius, y * shape.radius, z * shape.radius]));
    case 'box': {
      const [a, b, c] = shape.size;
      return cube.map(([x, y, z]) =>
        add(shape.center, rotate([(x * a) / 2, (y * b) / 2, (z * c) / 2], shape.rotation)),
      );
    }
    case 'quad':
      return [
        shape.corner,
        add(shape.corner, shape.u),
        add(shape.corner, shape.v),
        add(add(shape.corner, shape.u), shape.v),
      ];
    default:
      return [];
  }
}
