import type { Camera, Vec3 } from 'mirrorball';
import { glideAlongWalls, stopAtWalls, type Wall, wallsAround } from './eye-room.ts';

/** How the view is to change. Pure numbers, so that moves can be summed, smoothed and tested. */
export interface CameraMove {
  /** Degrees about the vertical axis through the target; positive takes the eye to its right. */
  readonly yaw: number;
  /** Degrees upwards. */
  readonly pitch: number;
  /** Shift of eye and target to the right and up, in heights of the view at the target. */
  readonly panX: number;
  readonly panY: number;
  /** Natural logarithm of the factor for the distance to the target: negative comes closer. */
  readonly dolly: number;
}

export const stillMove: CameraMove = { yaw: 0, pitch: 0, panX: 0, panY: 0, dolly: 0 };

/** The eye stops short of straight up and straight down, where a camera with up = +Y has no direction. */
export const MAX_PITCH = 89;
const MIN_DISTANCE = 1e-4;
const MAX_DISTANCE = 1e5;

const degrees = Math.PI / 180;
const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];

/** Where the eye stands as seen from the target: yaw from +Z towards +X and pitch from the horizon, in degrees. */
export function polar(camera: Camera): { yaw: number; pitch: number; distance: number } {
  const [x, y, z] = subtract(camera.eye, camera.target);
  const distance = Math.hypot(x, y, z);
  if (distance === 0) return { yaw: 0, pitch: 0, distance };
  return { yaw: Math.atan2(x, z) / degrees, pitch: Math.asin(clamp(y / distance, -1, 1)) / degrees, distance };
}

function fromPolar(camera: Camera, yaw: number, pitch: number, distance: number): Camera {
  const flat = Math.cos(pitch * degrees) * distance;
  const offset: Vec3 = [
    Math.sin(yaw * degrees) * flat,
    Math.sin(pitch * degrees) * distance,
    Math.cos(yaw * degrees) * flat,
  ];
  return { ...camera, eye: add(camera.target, offset), up: [0, 1, 0] };
}

/** Turns the eye about the target, which keeps its place and distance. */
export function orbit(camera: Camera, yaw: number, pitch: number): Camera {
  const at = polar(camera);
  return fromPolar(camera, at.yaw + yaw, clamp(at.pitch + pitch, -MAX_PITCH, MAX_PITCH), at.distance);
}

/**
 * Brings the eye nearer to the target (factor < 1) or farther from it, never through it. An orthographic view does not depend on the
 * distance: there the picture takes in less or more.
 */
export function dolly(camera: Camera, factor: number): Camera {
  if (camera.projection === 'orthographic')
    return { ...camera, viewHeight: clamp(viewHeightOf(camera) * factor, MIN_DISTANCE, MAX_DISTANCE) };
  const at = polar(camera);
  return fromPolar(camera, at.yaw, at.pitch, clamp(at.distance * factor, MIN_DISTANCE, MAX_DISTANCE));
}

/** Metres from the lower to the upper edge of the picture at the target. Of a panorama, which has none: of an ordinary view. */
function viewHeightOf(camera: Camera): number {
  if (camera.projection === 'orthographic') return camera.viewHeight ?? 2;
  return 2 * Math.tan((camera.verticalFov / 2) * degrees) * polar(camera).distance;
}

/** The unit vectors to the right and up in the picture, for a camera with up = +Y. */
export function screenAxes(camera: Camera): { right: Vec3; up: Vec3 } {
  const { yaw, pitch } = polar(camera);
  const [sy, cy] = [Math.sin(yaw * degrees), Math.cos(yaw * degrees)];
  const [sp, cp] = [Math.sin(pitch * degrees), Math.cos(pitch * degrees)];
  return { right: [cy, 0, -sy], up: [-sp * sy, cp, -sp * cy] };
}

/** Shifts eye and target alike, by heights of the view at the target's distance: what is there follows the pointer. */
export function pan(camera: Camera, x: number, y: number): Camera {
  const height = viewHeightOf(camera);
  const { right, up } = screenAxes(camera);
  const shift = add(scale(right, x * height), scale(up, y * height));
  return { ...camera, eye: add(camera.eye, shift), target: add(camera.target, shift), up: [0, 1, 0] };
}

/** Turns, shifts and comes closer, in this order. The eye stays inside of `walls`. */
export function moveCamera(camera: Camera, move: CameraMove, walls: readonly Wall[] = []): Camera {
  const turned = orbit(camera, move.yaw, move.pitch);
  const placed = { ...turned, eye: glideAlongWalls(camera.eye, turned.eye, walls) };
  const shifted = shiftInside(placed, pan(placed, move.panX, move.panY), walls);
  const moved = dolly(shifted, Math.exp(move.dolly));
  return { ...moved, eye: stopAtWalls(shifted.eye, moved.eye, walls) };
}

/** The eye is shifted as far as walls allow, then the target; both alike, so that the direction stays. */
function shiftInside(from: Camera, to: Camera, walls: readonly Wall[]): Camera {
  const shift = subtract(glideAlongWalls(from.eye, to.eye, walls), from.eye);
  const target = glideAlongWalls(from.target, add(from.target, shift), wallsAround(from.target, walls));
  const eye = glideAlongWalls(from.eye, add(from.eye, subtract(target, from.target)), walls);
  return { ...to, eye, target };
}

export function addMoves(a: CameraMove, b: CameraMove): CameraMove {
  return {
    yaw: a.yaw + b.yaw,
    pitch: a.pitch + b.pitch,
    panX: a.panX + b.panX,
    panY: a.panY + b.panY,
    dolly: a.dolly + b.dolly,
  };
}

export function scaleMove(a: CameraMove, s: number): CameraMove {
  return { yaw: a.yaw * s, pitch: a.pitch * s, panX: a.panX * s, panY: a.panY * s, dolly: a.dolly * s };
}

/** Whether what is left of a move cannot be seen any more. */
export function isNegligible(move: CameraMove): boolean {
  return (
    Math.abs(move.yaw) + Math.abs(move.pitch) < 0.01 && Math.hypot(move.panX, move.panY) + Math.abs(move.dolly) < 1e-4
  );
}
