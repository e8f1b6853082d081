import type { Camera, Vec3 } from './scene.ts';
import { addScaled, cross, length, subtract } from './vec3.ts';

/**
 * What must hold between several numbers of one thing, so that no later stage divides by zero. The file reader refuses
 * what breaks these rules, and animation mends it.
 */

/** Shortest length, metres, of anything that gives a direction. */
export const SHORTEST = 1e-6;
/** Smallest sine of the angle between two directions that span a frame or a quad. */
export const SMALLEST_SINE = 1e-6;

/** Whether the two span a plane. */
export function spansPlane(u: Vec3, v: Vec3): boolean {
  return length(u) >= SHORTEST && length(v) >= SHORTEST && length(cross(u, v)) >= SMALLEST_SINE * length(u) * length(v);
}

/** What is wrong between eye, target and up, or null. */
export function cameraFault(camera: Pick<Camera, 'eye' | 'target' | 'up'>): 'target' | 'up' | null {
  const view = subtract(camera.target, camera.eye);
  if (!(length(view) >= SHORTEST)) return 'target';
  return spansPlane(view, camera.up) ? null : 'up';
}

/** Scales nearer to 0 than this would make a mesh flat. */
export const SMALLEST_SCALE = 1e-6;

/** The scale itself, or, at the instant when it goes through 0, the least that is none. */
export const mendScale = (scale: Vec3): Vec3 =>
  scale.some((s) => Math.abs(s) < SMALLEST_SCALE)
    ? (scale.map((s) =>
        Math.abs(s) < SMALLEST_SCALE ? (s < 0 ? -SMALLEST_SCALE : SMALLEST_SCALE) : s,
      ) as unknown as Vec3)
    : scale;

/** Whether it points anywhere: the normal of a plane, the direction of a light. */
export const isDirection = (direction: Vec3): boolean => length(direction) >= SHORTEST;

const AXES: readonly Vec3[] = [
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * A camera that can be used: `camera` itself, or, at the instant when moving keys make it impossible, with the view
 * direction and the up of `rest`, the camera as the file has it.
 */
export function mendCamera(camera: Camera, rest: Camera): Camera {
  let mended = camera;
  if (cameraFault(mended) === 'target') {
    const view = subtract(rest.target, rest.eye);
    // A step that the eye's own size does not swallow in rounding.
    const step = Math.max(1, length(mended.eye) * 1e-6) / length(view);
    mended = { ...mended, target: addScaled(mended.eye, view, step) };
  }
  for (const up of [rest.up, ...AXES]) {
    if (cameraFault(mended) === null) return mended;
    mended = { ...mended, up };
  }
  return mended;
}
