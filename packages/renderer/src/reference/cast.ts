/** The two questions that are asked of a scene: what does a ray meet first, and does anything stand in its way. */
import { emissionOf } from '../scene/lamps.ts';
import type { Color, SphereLight, Vec3 } from '../scene/scene.ts';
import { addScaled, dot, negate } from '../scene/vec3.ts';
import { intersectBox, intersectPlane, intersectQuad, intersectSphere, outwardNormal } from './intersect.ts';
import { colorsAt, intersectMesh, shadingNormal, triangleNormal } from './mesh/mesh.ts';
import type { MeshHit } from './mesh/tree.ts';
import type { PreparedScene, PreparedShape } from './prepare.ts';
import type { Ray } from './ray.ts';

export interface SurfaceHit {
  readonly t: number;
  readonly shape: PreparedShape;
  readonly point: Vec3;
  /** The geometric normal to the outside of the shape. */
  readonly outwardNormal: Vec3;
  /** The geometric normal turned to the side the ray came from. */
  readonly geometricNormal: Vec3;
  /** n of docs/classic.md: the geometric normal, or what a mesh's vertices have instead, on the same side. */
  readonly shadingNormal: Vec3;
  /** The material's, times the vertices' colours and those of textures. */
  readonly baseColor: Color;
  readonly emission: Color;
  /** Of a mesh, else −1. */
  readonly triangle: number;
}
export interface Closest {
  /** Infinity when nothing is hit. */
  readonly t: number;
  /** At most one of these two is set. */
  readonly shape: PreparedShape | null;
  readonly light: SphereLight | null;
  /** Where on the shape, when it is a mesh. */
  readonly spot: MeshHit | null;
}

/** Closest hit of shapes and visible light balls. Of two at the same distance the one tested first wins. */
export function closestHit(scene: PreparedScene, ray: Ray): Closest {
  let closest = Infinity;
  let shape: PreparedShape | null = null;
  let light: SphereLight | null = null;
  const consider = (t: number, candidate: PreparedShape) => {
    if (t < closest) {
      closest = t;
      shape = candidate;
      light = null;
    }
  };
  for (const sphere of scene.spheres) consider(intersectSphere(sphere, ray), sphere);
  for (const ball of scene.visibleLights) {
    const t = intersectSphere(ball, ray);
    if (t < closest) {
      closest = t;
      shape = null;
      light = ball;
    }
  }
  for (const box of scene.boxes) consider(intersectBox(box, ray), box);
  for (const quad of scene.quads) consider(intersectQuad(quad, ray), quad);
  for (const plane of scene.planes) consider(intersectPlane(plane, ray), plane);
  let spot: MeshHit | null = null;
  for (const mesh of scene.meshes) {
    const hit = intersectMesh(mesh, ray, closest);
    if (hit === null) continue;
    consider(hit.t, mesh);
    spot = hit;
  }
  return { t: closest, shape, light, spot };
}

/** `spot`: of a mesh, what `closestHit` says. */
export function surfaceAt(shape: PreparedShape, ray: Ray, t: number, spot: MeshHit | null = null): SurfaceHit {
  const outward = shape.type === 'mesh' ? triangleNormal(shape, spot!) : outwardNormal(shape, ray, t);
  const geometricNormal = dot(outward, ray.direction) > 0 ? negate(outward) : outward;
  const { baseColor } = shape.material;
  const plain = { baseColor, emission: emissionOf(shape.material) };
  return {
    t,
    shape,
    point: addScaled(ray.origin, ray.direction, t),
    outwardNormal: outward,
    geometricNormal,
    shadingNormal:
      shape.type === 'mesh' ? shadingNormal(shape, spot!, geometricNormal, ray.direction) : geometricNormal,
    ...(shape.type === 'mesh' ? colorsAt(shape, spot!) : plain),
    triangle: shape.type === 'mesh' ? spot!.triangle : -1,
  };
}

/** Whether a shape stands between the ray's start and `distance`. Light balls cast no shadows. */
export function occluded(scene: PreparedScene, ray: Ray, distance: number): boolean {
  for (const sphere of scene.spheres) if (intersectSphere(sphere, ray) < distance) return true;
  for (const box of scene.boxes) if (intersectBox(box, ray) < distance) return true;
  for (const plane of scene.planes) if (intersectPlane(plane, ray) < distance) return true;
  for (const quad of scene.quads) if (intersectQuad(quad, ray) < distance) return true;
  for (const mesh of scene.meshes) if (intersectMesh(mesh, ray, distance) !== null) return true;
  return false;
}
