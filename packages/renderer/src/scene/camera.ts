import type { Camera, Projection, Vec3 } from './scene.ts';

/** All projections; the position of each is its number in the kernels, camera.wesl. */
export const PROJECTIONS = ['perspective', 'orthographic', 'equirectangular'] as const satisfies readonly Projection[];

/** What a camera has where it says nothing. */
export const CAMERA_DEFAULTS = {
  projection: 'perspective',
  viewHeight: 2,
  aperture: 0,
  focusDistance: 0,
} as const satisfies Partial<Camera>;

/** The camera with nothing left out. */
export const wholeCamera = (camera: Camera): Required<Camera> => ({ ...CAMERA_DEFAULTS, ...camera });

/** Focusing nearer than this makes no picture. */
const NEAREST_FOCUS = 1e-6;

/** Where the picture is sharp, metres from the eye. */
export function focusOf({ eye, target, focusDistance = 0 }: Camera): number {
  const toTarget = Math.hypot(target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]);
  return Math.max(focusDistance > 0 ? focusDistance : toTarget, NEAREST_FOCUS);
}

const normalize = (a: Vec3): Vec3 => {
  const l = Math.hypot(...a);
  return [a[0] / l, a[1] / l, a[2] / l];
};
const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Right-handed unit axes: forward, right, up. */
export function cameraAxes({ eye, target, up }: Camera): { forward: Vec3; right: Vec3; up: Vec3 } {
  const forward = normalize([target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]]);
  const right = normalize(cross(forward, up));
  return { forward, right, up: cross(right, forward) };
}
