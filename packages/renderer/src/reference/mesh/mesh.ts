/** A placed mesh: where a ray meets it, and what its surface is like there. */
import {
  AFFINE_LENGTH,
  IDENTITY,
  invertAffine,
  type Numbers,
  transformDirection,
  transformNormal,
  transformPoint,
} from '../../scene/affine.ts';
import { emissionOf } from '../../scene/lamps.ts';
import type { Mesh } from '../../scene/mesh.ts';
import { meshMatrices } from '../../scene/placed.ts';
import type { Color, MeshShape, Scene, Vec3 } from '../../scene/scene.ts';
import { add, cross, dot, negate, normalize, scale, subtract } from '../../scene/vec3.ts';
import type { PreparedMaterial } from '../prepare.ts';
import type { Ray } from '../ray.ts';
import { bentNormal } from './bent-normal.ts';
import { type Presence, presenceOf } from './presence.ts';
import { bumpOf, type MeshTextures, prepareTextures, texelOf, timesTexel } from './textured.ts';
import { closestTriangle, type MeshHit, type MeshTree, treeOf } from './tree.ts';
import { meshRay } from './triangle.ts';

export interface PreparedMesh {
  readonly type: 'mesh';
  readonly mesh: Mesh;
  readonly tree: MeshTree;
  /** From the world to the mesh's own space. */
  readonly back: Numbers;
  readonly material: PreparedMaterial;
  readonly textures: MeshTextures;
  readonly presence: Presence | null;
}

/** The mesh at each place where the shape has it. */
export function prepareMesh(shape: MeshShape, material: PreparedMaterial, scene: Scene): PreparedMesh[] {
  const mesh = scene.meshes?.[shape.mesh]?.data;
  if (mesh === undefined) throw new TypeError(`The mesh "${shape.mesh}" has not been loaded.`);
  const textures = prepareTextures(scene, material);
  const presence = presenceOf(mesh, material, textures.baseColor);
  const matrices = meshMatrices(shape, IDENTITY);
  return Array.from({ length: matrices.length / AFFINE_LENGTH }, (_, i) => {
    const back = invertAffine(matrices, AFFINE_LENGTH * i)!;
    return { type: 'mesh', mesh, tree: treeOf(mesh), back, material, textures, presence };
  });
}

/** The ray's rule of start: of the mesh that it leaves only the one triangle is left out, which is flat. */
export function intersectMesh(prepared: PreparedMesh, ray: Ray, most: number): MeshHit | null {
  const { mesh, tree, back, presence } = prepared;
  const inside = meshRay(transformPoint(back, 0, ray.origin), transformDirection(back, 0, ray.direction));
  const leaving = ray.leaving === prepared ? ray.leavingTriangle : -1;
  const isThere = presence ? (hit: MeshHit) => presence(hit, inside.direction) : undefined;
  return closestTriangle(mesh, tree, inside, ray.tMin, most, leaving, isThere);
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

/** The unit normal that light is shaded with, on the side of `geometricNormal`, which is the one that the ray in `direction` comes from. */
export function shadingNormal(prepared: PreparedMesh, hit: MeshHit, geometricNormal: Vec3, direction: Vec3): Vec3 {
  const { mesh, back, textures } = prepared;
  if (mesh.normals === undefined) return geometricNormal;
  const blendedNormal = blended(mesh, hit, mesh.normals);
  const [x, y, z] = normalize(transformNormal(back, 0, blendedNormal));
  // Normals that cancel out, between two that look opposite ways, are none.
  if (!(x * x + y * y + z * z > 0)) return geometricNormal;
  const n: Three = [x, y, z];
  const smooth = dot(n, geometricNormal) < 0 ? negate(n) : n;
  if (textures.normal === null || mesh.tangents === undefined) return smooth;
  const mapped = mappedNormal(mesh, hit, blendedNormal, bumpOf(mesh, hit, textures.normal));
  const world = normalize(transformNormal(back, 0, mapped));
  return bentNormal(geometricNormal, negate(direction), dot(n, geometricNormal) < 0 ? negate(world) : world);
}

/** In the mesh's own space, from the frame that MikkTSpace wants: of blended vectors that have not got length 1 again. */
function mappedNormal(mesh: Mesh, hit: MeshHit, normal: Vec3, [x, y, z]: Vec3): Vec3 {
  const tangent = blended(mesh, hit, mesh.tangents!, 4);
  const hand = mesh.tangents![4 * mesh.indices[3 * hit.triangle]! + 3]!;
  const bitangent = scale(cross(normal, tangent), hand);
  return add(add(scale(tangent, x), scale(bitangent, y)), scale(normal, z));
}

/** The vertices' colours at the hit. */
const colorAt = ({ mesh }: PreparedMesh, hit: MeshHit): Color =>
  mesh.colors === undefined ? [1, 1, 1] : blended(mesh, hit, mesh.colors, 4);

const multiply = (a: Color, b: Color): Color => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** The material's colours with what vertices and textures say. */
export function colorsAt(
  prepared: PreparedMesh,
  hit: MeshHit,
): { readonly baseColor: Color; readonly emission: Color } {
  const { mesh, material, textures } = prepared;
  const own = timesTexel(material.baseColor, texelOf(mesh, hit, textures.baseColor));
  const emission = timesTexel(emissionOf(material), texelOf(mesh, hit, textures.emission));
  return { baseColor: multiply(colorAt(prepared, hit), own), emission };
}
