import type { Camera, Projection, Vec3 } from './scene.ts';
import { cross, length, normalize, subtract } from './vec3.ts';

/** All projections; the position of each is its number in the kernels, camera.wesl. */
export const PROJECTIONS = ['perspective', 'orthographic', 'equirectangular'] as const satisfies readonly Projection[];

/** What a camera has where it says nothing. */
export const CAMERA_DEFAULTS = {
  projection: 'perspective',
  viewHeight: 2,
  aperture: 0,
  focusDistance: 0,
} as const satisfies Partial<Camera>;

/** Nothing is left out but a node that does not carry it. */
export type WholeCamera = Camera & Required<Omit<Camera, 'node'>>;

/** The camera with nothing left out. */
export const wholeCamera = (camera: Camera): WholeCamera => ({ ...CAMERA_DEFAULTS, ...camera });

/** Focusing nearer than this makes no picture. */
const NEAREST_FOCUS = 1e-6;

/** Where the picture is sharp, metres from the eye. */
export function focusOf({ eye, target, focusDistance = 0 }: Camera): number {
  const toTarget = length(subtract(target, eye));
  return Math.max(focusDistance > 0 ? focusDistance : toTarget, NEAREST_FOCUS);
}

/** Right-handed unit axes: forward, right, up. */
export function cameraAxes({ eye, target, up }: Camera): { forward: Vec3; right: Vec3; up: Vec3 } {
  const forward = normalize(subtract(target, eye));
  const right = normalize(cross(forward, up));
  return { forward, right, up: cross(right, forward) };
}
