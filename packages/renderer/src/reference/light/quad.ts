/** Glowing quads: rectangles by solid angle, parallelograms and what looks small by area. */
import type { Vec3 } from '../../scene/scene.ts';
import { add, cross, dot, length, normalize, scale, subtract } from '../../scene/vec3.ts';
import type { LightSample, Meeting, QuadEmitter, Square } from './emitter.ts';
import { pointOfRectangle, type SphericalRectangle, sphericalRectangle } from './spherical-rectangle.ts';

/** Rectangles that fill less, in steradians, are sampled by area: shading/light/emitter/quad.wesl says why. */
export const SMALL_SOLID_ANGLE = 0.01;
/** Of the angle between the sides of what counts as a rectangle. */
const LARGEST_COSINE = 1e-5;
/** Nearer to the quad's plane than this share of its sides a point sees a line. */
const IN_PLANE = 1e-7;

/** Of the point over the plane, to the side of u × v. */
function heightOver({ corner, u, v }: QuadEmitter, point: Vec3): number {
  return dot(subtract(point, corner), normalize(cross(u, v)));
}

function isLit(e: QuadEmitter, point: Vec3): boolean {
  const height = heightOver(e, point);
  if (Math.abs(height) <= IN_PLANE * (length(e.u) + length(e.v))) return false;
  return !e.oneSided || height > 0;
}

function bySolidAngle({ corner, u, v }: QuadEmitter, point: Vec3): SphericalRectangle | null {
  if (Math.abs(dot(normalize(u), normalize(v))) > LARGEST_COSINE) return null;
  const rectangle = sphericalRectangle(corner, u, v, point);
  return rectangle.S > SMALL_SOLID_ANGLE ? rectangle : null;
}

export function metQuad({ corner, u, v }: QuadEmitter, origin: Vec3, direction: Vec3): Meeting | null {
  const across = cross(u, v);
  const distance = dot(subtract(corner, origin), across) / dot(direction, across);
  if (!(distance > 0) || !Number.isFinite(distance)) return null;
  const inside = subtract(add(origin, scale(direction, distance)), corner);
  const s = dot(cross(inside, v), across) / dot(across, across);
  const t = dot(cross(u, inside), across) / dot(across, across);
  return s >= 0 && s <= 1 && t >= 0 && t <= 1 ? { distance, normal: normalize(across) } : null;
}

/** Met there at `distance`: per area 1 / area, so per solid angle distance² / (area · cos). */
export function quadPdf(e: QuadEmitter, point: Vec3, distance: number): number {
  if (!isLit(e, point)) return 0;
  const rectangle = bySolidAngle(e, point);
  if (rectangle !== null) return 1 / rectangle.S;
  const cosine = Math.abs(heightOver(e, point)) / distance;
  return distance ** 2 / (length(cross(e.u, e.v)) * cosine);
}

export function sampleQuad(e: QuadEmitter, point: Vec3, u: Square): LightSample | null {
  if (!isLit(e, point)) return null;
  const rectangle = bySolidAngle(e, point);
  const onArea = add(subtract(e.corner, point), add(scale(e.u, u[0]), scale(e.v, u[1])));
  const toLight = rectangle === null ? onArea : pointOfRectangle(rectangle, u);
  const distance = length(toLight);
  const pdf = quadPdf(e, point, distance);
  return { direction: scale(toLight, 1 / distance), distance, radiance: e.radiance, pdf, delta: false };
}
