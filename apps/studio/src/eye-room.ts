import type { Plane, Scene, Vec3 } from 'mirrorball';

/** Keeps the eye on its side of a scene's planes: beyond a wall or under the floor there is nothing to be seen. */

/** A plane as the eye sees it: `normal`, of length 1, points to the eye's side. */
export interface Wall {
  readonly point: Vec3;
  readonly normal: Vec3;
  /** The eye keeps this far off, metres. */
  readonly margin: number;
}

/** Share of the distance to the target that the eye keeps off a wall. */
const MARGIN = 0.02;
/** Corners of walls that are not at right angles need more than one turn. */
const TURNS = 8;

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const addScaled = (a: Vec3, b: Vec3, s: number): Vec3 => [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s];
const mix = (a: Vec3, b: Vec3, s: number): Vec3 => [0, 1, 2].map((c) => a[c]! + (b[c]! - a[c]!) * s) as unknown as Vec3;

/** How far a point is inside of a wall; negative beyond it. */
const depth = (wall: Wall, at: Vec3): number => dot(addScaled(at, wall.point, -1), wall.normal);
/** How far it may still go; negative when it is too near already. */
const room = (wall: Wall, at: Vec3): number => depth(wall, at) - wall.margin;

/** The planes of a scene, as it is at one time, about an eye. A plane through the eye has no side, and is none. */
export function wallsAbout(scene: Scene, eye: Vec3, target: Vec3): Wall[] {
  const planes = Object.values(scene.shapes).filter((shape): shape is Plane => shape.type === 'plane');
  const wished = MARGIN * Math.hypot(...addScaled(target, eye, -1));
  return planes.flatMap(({ point, normal }) => {
    const length = Math.hypot(...normal);
    const distance = dot(addScaled(eye, point, -1), normal) / length;
    if (!(Math.abs(distance) > 0)) return [];
    const side = Math.sign(distance) / length;
    const towards: Vec3 = [normal[0] * side, normal[1] * side, normal[2] * side];
    return [{ point, normal: towards, margin: Math.min(wished, Math.abs(distance)) }];
  });
}

/** The way from one point to another, stopped at the first wall. */
export function stopAtWalls(from: Vec3, to: Vec3, walls: readonly Wall[]): Vec3 {
  let share = 1;
  for (const wall of walls) {
    const [before, after] = [room(wall, from), room(wall, to)];
    if (after < 0) share = Math.min(share, before > 0 ? before / (before - after) : 0);
  }
  return share === 1 ? to : mix(from, to, share);
}

/** As near to `to` as walls allow: what goes against a wall glides along it. */
export function glideAlongWalls(from: Vec3, to: Vec3, walls: readonly Wall[]): Vec3 {
  let at = to;
  for (let turn = 0; turn < TURNS; turn++) {
    const crossed = walls.filter((wall) => room(wall, at) < 0);
    if (crossed.length === 0) return at;
    for (const wall of crossed) at = addScaled(at, wall.normal, Math.max(-room(wall, at), 0) * (1 + 1e-9));
  }
  return stopAtWalls(from, at, walls);
}

/** The walls that a target has on the eye's side of it: those that it, too, is kept within. */
export const wallsAround = (target: Vec3, walls: readonly Wall[]): Wall[] =>
  walls.filter((wall) => depth(wall, target) > 0).map((wall) => ({ ...wall, margin: 0 }));
