/** A camera that shows all of a scene, as model-viewer places its own: from the front, a little from above; a closed room from within. */

import { type Room, roomIn } from './room.ts';
import type { Camera, Scene, Vec3 } from './scene.ts';
import { boundsAt, visitPoints } from './scene-bounds.ts';
import { addScaled, scale } from './vec3.ts';

export interface FramingOptions {
  /** Full vertical field of view, degrees. Default: 30. */
  readonly verticalFov?: number;
  /** Degrees about +Y from the front, +Z, towards +X. Default: 0. */
  readonly azimuth?: number;
  /** Degrees above the horizon. Default: 15. */
  readonly elevation?: number;
  /** What is left free: the distance at which a ball around everything just fits the picture, times this. Default: 1.05. */
  readonly margin?: number;
}

/** Of an eye's coordinates, metres. */
const FARTHEST = 1e9;

/** Full vertical field of view in a room, degrees. */
const ROOM_FOV = 60;

/** What a scene without extent is framed as: a thing of this radius. */
const SMALLEST_RADIUS = 1e-6;

/**
 * A camera that sees everything with an end that the scene has at the time, in a square picture and in any that is wider. It looks at the
 * middle of the box around it; the ball about that middle fits the field of view. A room that hides all it holds is seen from within
 * (`room.ts`), whatever the options. Null when there is nothing to frame.
 */
export function frameScene(scene: Scene, time = 0, options: FramingOptions = {}): Camera | null {
  return frameOf(scene, time, options)?.camera ?? null;
}

export interface Frame {
  readonly camera: Camera;
  /** The room that it stands in. */
  readonly room: Room | null;
}

/** The same, and whether it is seen from within. */
export function frameOf(scene: Scene, time = 0, options: FramingOptions = {}): Frame | null {
  const bounds = boundsAt(scene, time);
  if (bounds === null) return null;
  const room = roomIn(scene, bounds, time, outwards(options));
  if (room !== null) return { camera: { eye: room.eye, target: room.middle, up: [0, 1, 0], verticalFov: ROOM_FOV }, room }; // biome-ignore format: one line
  const { min, max } = bounds;
  const target: Vec3 = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2];
  let square = 0;
  visitPoints(scene, time, (x, y, z) => {
    square = Math.max(square, (x - target[0]) ** 2 + (y - target[1]) ** 2 + (z - target[2]) ** 2);
  });
  return { camera: cameraAround(target, Math.sqrt(square), options), room: null };
}

/** A camera that sees the ball. */
export function cameraAround(target: Vec3, radius: number, options: FramingOptions = {}): Camera {
  const { verticalFov = 30, margin = 1.05 } = options;
  // Far from the origin a step must not be lost in the rounding of the place itself.
  const least = Math.max(SMALLEST_RADIUS, Math.hypot(...target) * 1e-6);
  const distance = (margin * Math.max(radius, least)) / Math.sin((verticalFov * Math.PI) / 360);
  const offset: Vec3 = scale(outwards(options), distance);
  return { eye: addScaled(target, offset, roomFor(target, offset)), target, up: [0, 1, 0], verticalFov };
}

/** Where the eye is, seen from the target. */
function outwards({ azimuth = 0, elevation = 15 }: FramingOptions): Vec3 {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
}

/** How much of the way there is before the end of the world: all, but for things nearly as large as it; there from the other side. */
function roomFor(target: Vec3, offset: Vec3): number {
  const share = (sign: number): number =>
    Math.min(1, ...offset.map((x, k) => (x === 0 ? 1 : Math.max(FARTHEST - sign * Math.sign(x) * target[k]!, 0) / Math.abs(x)))); // biome-ignore format: one formula
  const [here, there] = [share(1), share(-1)];
  return here >= 0.01 || here >= there ? here : -there;
}
