/** "One camera ray" of docs/classic.md. */
import type { Framing } from '../renderer-types.ts';
import { wholeCamera } from '../scene/camera.ts';
import type { Camera, Projection, Vec3 } from '../scene/scene.ts';
import { addScaled, cross, normalize, scale, subtract } from '../scene/vec3.ts';
import { cameraRay, type Ray } from './ray.ts';

/**
 * Perspective: the plane one unit in front of the eye, `forward` to its middle, `right` and `up` to its edges. Orthographic: the
 * same two in the plane through the eye. Equirectangular: unit axes.
 */
export interface CameraFrame {
  readonly projection: Projection;
  readonly eye: Vec3;
  readonly forward: Vec3;
  readonly right: Vec3;
  readonly up: Vec3;
}

/** With a framing, the middle of `framing.center` is looked at, and `framing.height` of the picture spans the field of view. */
export function cameraFrame(
  camera: Camera,
  width: number,
  height: number,
  framing: Framing | null = null,
): CameraFrame {
  const forward = normalize(subtract(camera.target, camera.eye));
  const right = normalize(cross(forward, camera.up));
  const up = cross(right, forward);
  const { projection, viewHeight, verticalFov } = wholeCamera(camera);
  if (projection === 'equirectangular') return { projection, eye: camera.eye, forward, right, up };
  const perspective = projection === 'perspective';
  const half = perspective ? Math.tan((verticalFov * Math.PI) / 360) : viewHeight / 2;
  const halfHeight = half / (framing?.height ?? 1);
  const halfWidth = (halfHeight * width) / height;
  const [x, y] = framing && perspective ? [2 * framing.center[0] - 1, 1 - 2 * framing.center[1]] : [0, 0];
  return {
    projection,
    eye: camera.eye,
    forward: addScaled(addScaled(forward, right, -x * halfWidth), up, -y * halfHeight),
    right: scale(right, halfWidth),
    up: scale(up, halfHeight),
  };
}

const frac = (x: number): number => x - Math.floor(x);

/** Where in its pixel film sample s lies: Roberts' R2 sequence, from the centre on. */
export const sampleOffset = (s: number): [a: number, b: number] => [
  frac(0.5 + s * 0.7548776662466927),
  frac(0.5 + s * 0.5698402909980532),
];

/** The ray through (column, row) of the picture, counted in pixels from its top left corner. */
export function rayThrough(frame: CameraFrame, column: number, row: number, width: number, height: number): Ray {
  const x = (2 * column) / width - 1;
  const y = 1 - (2 * row) / height;
  const across = (start: Vec3) => addScaled(addScaled(start, frame.right, x), frame.up, y);
  if (frame.projection === 'orthographic') return cameraRay(across(frame.eye), frame.forward);
  if (frame.projection === 'perspective') return cameraRay(frame.eye, normalize(across(frame.forward)));
  const [longitude, latitude] = [Math.PI * x, (Math.PI / 2) * y];
  const level = addScaled(scale(frame.forward, Math.cos(longitude)), frame.right, Math.sin(longitude));
  return cameraRay(frame.eye, addScaled(scale(level, Math.cos(latitude)), frame.up, Math.sin(latitude)));
}
