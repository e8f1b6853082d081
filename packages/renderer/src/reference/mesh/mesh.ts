/** A placed mesh: where a ray meets it, and what its surface is like there. */
import { invertAffine, type Numbers, transformDirection, transformNormal, transformPoint } from '../../scene/affine.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { placementOf } from '../../scene/placed.ts';
import type { Color, MeshShape, Scene, Vec3 } from '../../scene/scene.ts';
import { add, cross, dot, negate, normalize, scale, subtract } from '../../scene/vec3.ts';
import type { PreparedMaterial } from '../prepare.ts';
import type { Ray } from '../ray.ts';
import { closestTriangle, type MeshHit, type MeshTree, treeOf } from './tree.ts';
import { meshRay } from './triangle.ts';

export interface PreparedMesh {
  readonly type: 'mesh';
  readonly mesh: Mesh;
  readonly tree: MeshTree;
  /** From the world to the mesh's own space. */
  readonly back: Numbers;
  readonly material: PreparedMaterial;
}

export function prepareMesh(shape: MeshShape, material: PreparedMaterial, { meshes = {} }: Scene): PreparedMesh {
  const mesh = meshes[shape.mesh]?.data;
  if (mesh === undefined) throw new TypeError(`The mesh "${shape.mesh}" has not been loaded.`);
  return { type: 'mesh', mesh, tree: treeOf(mesh), back: invertAffine(placementOf(shape))!, material };
}

/** The ray's rule of start: of the mesh that it leaves only the one triangle is left out, which is flat. */
export function intersectMesh(prepared: PreparedMesh, ray: Ray, most: number): MeshHit | null {
  const { mesh, tree, back } = prepared;
  const inside = meshRay(transformPoint(back, 0, ray.origin), transformDirection(back, 0, ray.direction));
  const leaving = ray.leaving === prepared ? ray.leavingTriangle : -1;
  return closestTriangle(mesh, tree, inside, ray.tMin, most, leaving);
}

type Three = [number, number, number];
const tripleAt = (numbers: Float32Array, k: number, stride = 3): Vec3 =>
  numbers.subarray(stride * k, stride * k + 3) as unknown as Vec3;

/** What the numbers at the three vertices are at the hit. */
function blended({ indices }: Mesh, { triangle, weights }: MeshHit, numbers: Float32Array, stride = 3): Vec3 {
  const corners = [0, 1, 2].map((k) => tripleAt(numbers, indices[3 * triangle + k]!, stride)) as [Vec3, Vec3, Vec3];
  const [a, b, c] = corners.map((corner, k) => scale(corner, weights[k]!)) as [Vec3, Vec3, Vec3];
  return add(add(a, b), c);
}

/** The unit geometric normal to the side from which the triangle's vertices go counter-clockwise. */
export function triangleNormal({ mesh, back }: PreparedMesh, { triangle }: MeshHit): Vec3 {
  const { positions, indices } = mesh;
  const [a, b, c] = [0, 1, 2].map((k) => tripleAt(positions, indices[3 * triangle + k]!)) as [Vec3, Vec3, Vec3];
  return normalize(transformNormal(back, 0, cross(subtract(b, a), subtract(c, a))));
}

/** The unit normal that light is shaded with, on the side of `geometricNormal`. */
export function shadingNormal({ mesh, back }: PreparedMesh, hit: MeshHit, geometricNormal: Vec3): Vec3 {
  if (mesh.normals === undefined) return geometricNormal;
  const [x, y, z] = normalize(transformNormal(back, 0, blended(mesh, hit, mesh.normals)));
  // Normals that cancel out, between two that look opposite ways, are none.
  if (!(x * x + y * y + z * z > 0)) return geometricNormal;
  const n: Three = [x, y, z];
  return dot(n, geometricNormal) < 0 ? negate(n) : n;
}

/** The vertices' colours at the hit, which multiply the material's. */
export const colorAt = ({ mesh }: PreparedMesh, hit: MeshHit): Color =>
  mesh.colors === undefined ? [1, 1, 1] : blended(mesh, hit, mesh.colors, 4);
