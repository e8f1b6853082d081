/** A ray, and the rule of where it starts ("Where a ray starts" in docs/classic.md). */
import type { Vec3 } from '../scene/scene.ts';
import { dot, length, subtract } from '../scene/vec3.ts';
import type { PreparedShape } from './prepare.ts';

export interface Ray {
  readonly origin: Vec3;
  /** Unit. */
  readonly direction: Vec3;
  /** Hits of other shapes count from t > tMin. */
  readonly tMin: number;
  /** Where the path began: it never gets to the other side of a plane. */
  readonly eye: Vec3;
  /** The shape whose surface the ray leaves; null for a camera ray. */
  readonly leaving: PreparedShape | null;
  /** Which triangle of a mesh it is, else −1. */
  readonly leavingTriangle: number;
  /** Whether the ray goes into `leaving`: away from its outward normal. */
  readonly inward: boolean;
}

/** Share of the distance from the eye by which a hit must be away from the start: above the GPU's float rounding. */
const T_MIN_SCALE = 1e-5;

export const cameraRay = (eye: Vec3, direction: Vec3): Ray => ({
  origin: eye,
  direction,
  tMin: 0,
  eye,
  leaving: null,
  leavingTriangle: -1,
  inward: false,
});

/** The point that a ray leaves: what surfaceAt (cast.ts) tells of it. */
export interface Start {
  readonly shape: PreparedShape;
  readonly point: Vec3;
  readonly outwardNormal: Vec3;
  readonly triangle: number;
}

/** A mirror or shadow ray that leaves a surface. */
export function rayLeaving({ shape, point: origin, outwardNormal, triangle }: Start, direction: Vec3, eye: Vec3): Ray {
  return {
    origin,
    direction,
    tMin: T_MIN_SCALE * length(subtract(origin, eye)),
    eye,
    leaving: shape,
    leavingTriangle: triangle,
    inward: !(dot(direction, outwardNormal) > 0),
  };
}
