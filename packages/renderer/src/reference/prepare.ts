/** What can be worked out once for a scene instead of once for each ray. */
import { sphereLights } from '../scene/lights.ts';
import type {
  Box,
  Camera,
  Color,
  Material,
  Plane,
  Quad,
  Scene,
  Sky,
  Sphere,
  SphereLight,
  Vec3,
} from '../scene/scene.ts';
import { cross, dot, normalize, rotate, scale } from '../scene/vec3.ts';
import { type PreparedMesh, prepareMesh } from './mesh/mesh.ts';

export interface PreparedMaterial extends Material {
  /** e of docs/classic.md: the exponent of the highlight. */
  readonly exponent: number;
}
/** What a sphere shape and a light have in common. */
export interface Ball {
  readonly center: Vec3;
  readonly radius: number;
}
export interface PreparedSphere extends Ball {
  readonly type: 'sphere';
  readonly material: PreparedMaterial;
}
export interface PreparedBox {
  readonly type: 'box';
  readonly center: Vec3;
  readonly halfSize: Vec3;
  /** The box's own x, y and z directions in the world: the columns of its rotation. */
  readonly axes: readonly [Vec3, Vec3, Vec3];
  readonly material: PreparedMaterial;
}
export interface PreparedPlane {
  readonly type: 'plane';
  readonly point: Vec3;
  /** Unit. */
  readonly normal: Vec3;
  readonly material: PreparedMaterial;
}
export interface PreparedQuad {
  readonly type: 'quad';
  readonly corner: Vec3;
  /** Unit, along u × v. */
  readonly normal: Vec3;
  /** Reciprocal basis: for a point corner + s·u + t·v, s = dot(toS, point − corner), and t likewise. */
  readonly toS: Vec3;
  readonly toT: Vec3;
  readonly material: PreparedMaterial;
}
export type PreparedAnalytic = PreparedSphere | PreparedBox | PreparedPlane | PreparedQuad;
export type PreparedShape = PreparedAnalytic | PreparedMesh;

/** Shapes by kind, each kind in the order of the file. Rays test the kinds in the order given here (planes after quads). */
export interface PreparedScene {
  readonly spheres: readonly PreparedSphere[];
  readonly boxes: readonly PreparedBox[];
  readonly planes: readonly PreparedPlane[];
  readonly quads: readonly PreparedQuad[];
  readonly meshes: readonly PreparedMesh[];
  readonly lights: readonly SphereLight[];
  readonly visibleLights: readonly SphereLight[];
  readonly sky: Sky;
  readonly camera: Camera;
}

/** Rounder than this a highlight is no more: smaller roughness counts as this. */
const MIN_ROUGHNESS = 0.05;

function prepareMaterial(material: Material): PreparedMaterial {
  const roughness = Math.max(material.roughness, MIN_ROUGHNESS);
  return { ...material, exponent: Math.max(2 / roughness ** 4 - 2, 0) };
}

const prepareSphere = ({ center, radius }: Sphere, material: PreparedMaterial): PreparedSphere => ({
  type: 'sphere',
  center,
  radius,
  material,
});

const prepareBox = ({ center, size, rotation }: Box, material: PreparedMaterial): PreparedBox => ({
  type: 'box',
  center,
  halfSize: scale(size, 0.5),
  axes: [rotate([1, 0, 0], rotation), rotate([0, 1, 0], rotation), rotate([0, 0, 1], rotation)],
  material,
});

const preparePlane = ({ point, normal }: Plane, material: PreparedMaterial): PreparedPlane => ({
  type: 'plane',
  point,
  normal: normalize(normal),
  material,
});

function prepareQuad({ corner, u, v }: Quad, material: PreparedMaterial): PreparedQuad {
  const normal = cross(u, v);
  const areaSquared = dot(normal, normal);
  return {
    type: 'quad',
    corner,
    normal: normalize(normal),
    toS: scale(cross(v, normal), 1 / areaSquared),
    toT: scale(cross(normal, u), 1 / areaSquared),
    material,
  };
}

/** `scene` stands still: its animation has been applied already. */
export function prepareScene(scene: Scene): PreparedScene {
  const spheres: PreparedSphere[] = [];
  const boxes: PreparedBox[] = [];
  const planes: PreparedPlane[] = [];
  const quads: PreparedQuad[] = [];
  const meshes: PreparedMesh[] = [];
  const materials = new Map(Object.entries(scene.materials).map(([name, m]) => [name, prepareMaterial(m)]));
  for (const [name, shape] of Object.entries(scene.shapes)) {
    const material = materials.get(shape.material);
    if (material === undefined) throw new Error(`Shape "${name}" names the missing material "${shape.material}".`);
    if (shape.type === 'sphere') spheres.push(prepareSphere(shape, material));
    else if (shape.type === 'box') boxes.push(prepareBox(shape, material));
    else if (shape.type === 'plane') planes.push(preparePlane(shape, material));
    else if (shape.type === 'quad') quads.push(prepareQuad(shape, material));
    else meshes.push(...prepareMesh(shape, material, scene));
  }
  const lights = sphereLights(scene);
  const visibleLights = lights.filter((light) => light.visible);
  return { spheres, boxes, planes, quads, meshes, lights, visibleLights, sky: scene.sky, camera: scene.camera };
}

export const BLACK: Color = [0, 0, 0];
