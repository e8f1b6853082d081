/**
 * Where a ray meets a shape. Each function gives the smallest distance t at which the ray's rule of start lets the hit
 * count, or Infinity; `outwardNormal` then gives the shape's unit geometric normal at that hit.
 *
 * Spheres and boxes are convex: a ray that has left one outwards never comes back, and one that goes inwards meets
 * exactly the far side. So the shape that a ray leaves needs no epsilon at all (`ray.leaving`).
 */
import type { Vec3 } from '../scene/scene.ts';
import { addScaled, dot, negate, normalize, subtract } from '../scene/vec3.ts';
import type { Ball, PreparedAnalytic, PreparedBox, PreparedPlane, PreparedQuad } from './prepare.ts';
import type { Ray } from './ray.ts';

/** Picks from the two ends of the stretch that a ray has inside a convex shape. What starts inside cannot but meet the far end. */
function closestEnd(near: number, far: number, ray: Ray, leavingIt: boolean): number {
  if (leavingIt) return Math.max(far, 0);
  if (near > ray.tMin) return near;
  return far > ray.tMin ? far : Infinity;
}

/**
 * |origin + t·direction − center|² = radius². With b the (negated) t of the point closest to the centre and q that
 * point relative to the centre, the ends are −b ± √(radius² − q²): no difference of large squares, so that tiny
 * spheres stay round from far away.
 */
export function intersectSphere(ball: Ball, ray: Ray): number {
  const leavingIt = ray.leaving === ball;
  if (leavingIt && !ray.inward) return Infinity;
  const fromCenter = subtract(ray.origin, ball.center);
  const b = dot(fromCenter, ray.direction);
  const q = addScaled(fromCenter, ray.direction, -b);
  const halfChordSquared = ball.radius * ball.radius - dot(q, q);
  // From the surface itself the chord cannot be missed; rounding may say so for a grazing ray.
  if (halfChordSquared < 0 && !leavingIt) return Infinity;
  const halfChord = Math.sqrt(Math.max(halfChordSquared, 0));
  return closestEnd(-b - halfChord, -b + halfChord, ray, leavingIt);
}

/** The stretch of a ray within a box: distances where it enters and leaves, and through the faces of which axis. */
interface Stretch {
  near: number;
  far: number;
  nearAxis: number;
  farAxis: number;
}

/** The stretch within all three slabs |x| ≤ halfSize of the box's own axes; empty when near > far. */
function stretchInBox(box: PreparedBox, ray: Ray): Stretch {
  const fromCenter = subtract(ray.origin, box.center);
  const stretch: Stretch = { near: -Infinity, far: Infinity, nearAxis: 0, farAxis: 0 };
  for (let axis = 0; axis < 3; axis++) {
    const position = dot(box.axes[axis]!, fromCenter);
    const speed = dot(box.axes[axis]!, ray.direction);
    const half = box.halfSize[axis]!;
    if (speed === 0) {
      // Parallel to this pair of faces: between them always, or never.
      if (Math.abs(position) > half && ray.leaving !== box) stretch.far = -Infinity;
      continue;
    }
    const enters = (-Math.sign(speed) * half - position) / speed;
    const leaves = (Math.sign(speed) * half - position) / speed;
    if (enters > stretch.near) {
      stretch.near = enters;
      stretch.nearAxis = axis;
    }
    if (leaves < stretch.far) {
      stretch.far = leaves;
      stretch.farAxis = axis;
    }
  }
  return stretch;
}

export function intersectBox(box: PreparedBox, ray: Ray): number {
  const leavingIt = ray.leaving === box;
  if (leavingIt && !ray.inward) return Infinity;
  const { near, far } = stretchInBox(box, ray);
  if (near > far && !leavingIt) return Infinity;
  return closestEnd(near, far, ray, leavingIt);
}

/** dot(origin + t·direction − point, normal) = 0. Parallel rays give ±Infinity or NaN and so no hit. */
function distanceToPlane(point: Vec3, normal: Vec3, ray: Ray): number {
  const t = dot(subtract(point, ray.origin), normal) / dot(ray.direction, normal);
  return t > ray.tMin ? t : Infinity;
}

/**
 * A plane lets nothing through, so all of a path lies on the eye's side of it. A start beyond it is rounding, in a corner
 * of a room: going on away from the eye's side, the ray meets the plane at once.
 */
export function intersectPlane(plane: PreparedPlane, ray: Ray): number {
  if (ray.leaving === plane) return Infinity;
  const side = Math.sign(dot(subtract(ray.eye, plane.point), plane.normal));
  if (side === 0) return distanceToPlane(plane.point, plane.normal, ray);
  const towards = -side * dot(ray.direction, plane.normal);
  if (!(towards > 0)) return Infinity;
  const height = side * dot(subtract(ray.origin, plane.point), plane.normal);
  return Math.max(height / towards, 0);
}

export function intersectQuad(quad: PreparedQuad, ray: Ray): number {
  if (ray.leaving === quad) return Infinity;
  const t = distanceToPlane(quad.corner, quad.normal, ray);
  if (t === Infinity) return Infinity;
  const fromCorner = addScaled(subtract(ray.origin, quad.corner), ray.direction, t);
  const s = dot(quad.toS, fromCorner);
  const r = dot(quad.toT, fromCorner);
  return s >= 0 && s <= 1 && r >= 0 && r <= 1 ? t : Infinity;
}

/**
 * A box's normal is that of the face the ray came through, not of the face closest to the point: on an edge the two
 * can differ, and only the first agrees with whether the ray enters or leaves.
 */
function boxNormal(box: PreparedBox, ray: Ray, t: number): Vec3 {
  const { near, nearAxis, farAxis } = stretchInBox(box, ray);
  const enters = t === near && !(ray.leaving === box);
  const face = box.axes[enters ? nearAxis : farAxis]!;
  const alongRay = dot(face, ray.direction) > 0;
  return alongRay === enters ? negate(face) : face;
}

/** The unit geometric normal where `ray` meets `shape` at t: to the outside of a solid, as given for a flat shape. */
export function outwardNormal(shape: PreparedAnalytic, ray: Ray, t: number): Vec3 {
  switch (shape.type) {
    case 'sphere':
      return normalize(subtract(addScaled(ray.origin, ray.direction, t), shape.center));
    case 'box':
      return boxNormal(shape, ray, t);
    default:
      return shape.normal;
  }
}
