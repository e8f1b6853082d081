/**
 * Whether a scene is a room that hides all it holds from a viewer outside, and where in it to stand. A cube of cells finds the place with
 * the most room around it; the directions from there tell what is around.
 *
 * Things are seen from outside, so whatever could be one stays one. From the freest place a body sees the backs of its own surface, a bowl
 * sees out, and a vase, with however thick walls, sees nothing but itself. A room has walls turned inwards, or is a plain box from outside,
 * and there is something in it.
 */
import { determinant, transformPoint } from './affine.ts';
import type { Bounds } from './bounds.ts';
import { nodeTransforms, worldOf } from './node-transforms.ts';
import { placedLight } from './placed.ts';
import { RoomGrid } from './room-grid.ts';
import type { Scene, Vec3 } from './scene.ts';
import { type PosedMesh, visitMeshes } from './scene-bounds.ts';
import { DIRECTIONS, type Seen, SPHERE, Surroundings } from './surroundings.ts';
import { addScaled, dot } from './vec3.ts';

export interface Room {
  /** The place with the most room around it. */
  readonly middle: Vec3;
  /** Where to look at it from. */
  readonly eye: Vec3;
  /** A place above the middle, well below what is above it. */
  readonly lamp: Vec3;
  /** How far away the walls are from the middle, metres, as a mean over all directions that have one. */
  readonly reach: number;
  /** Whether hardly any light comes in from outside. */
  readonly isDark: boolean;
}

/** More triangles than that are not looked at; neither are fewer than four walls have. */
const MOST_TRIANGLES = 2 ** 22;
const FEWEST_TRIANGLES = 8;

/** How much of all directions a room must be closed in, and one that is a plain box from outside; a court may be open above. */
const CLOSED = 0.8;
const CLOSED_BOX = 0.97;
/** Closed in so much, it has no daylight to speak of. */
const DARK = 0.95;
const UP: Vec3 = [0, 1, 0];
/** Within so many degrees about the way out to a viewer nearly all must be wall, or the viewer sees in. */
const WAY_OUT = Math.cos((20 * Math.PI) / 180);
const BLOCKED = 0.7;
/** Of what is seen: as good as all. */
const NEARLY_ALL = 0.9;
/** How much of what is seen must be things in the room: meshes that are no wall, or else parts of a wall's mesh that stand before it. */
const THINGS = 0.004;
const PARTS = 0.02;

/** Null when it is none. `outward`: the direction, of length 1, in which a viewer outside would stand. */
export function roomIn(scene: Scene, bounds: Bounds, time: number, outward: Vec3): Room | null {
  if (bounds.max.some((x, k) => !(x > bounds.min[k]!))) return null;
  const count = trianglesIn(scene, time);
  if (count < FEWEST_TRIANGLES || count > MOST_TRIANGLES) return null;
  const grid = new RoomGrid(bounds);
  if (!visitTriangles(scene, time, (a, b, c) => grid.mark(a, b, c))) return null;
  const clearances = grid.clearances();
  const cell = grid.freest(clearances);
  if (cell < 0) return null;
  const around = new Surroundings(grid.middle(cell));
  if (!visitTriangles(scene, time, (a, b, c, thing, seen) => around.add(a, b, c, thing, seen))) return null;
  if (!isRoom(around, bounds, outward, hasLightIn(scene, time, bounds))) return null;
  const eye = standIn(grid, around.place, clearances, Math.min(2, clearances[cell]!), outward);
  if (eye === null) return null;
  return {
    middle: around.place,
    eye,
    lamp: addScaled(around.place, UP, 0.3 * grid.walk(around.place, UP, clearances, 1)),
    reach: reachOf(around),
    isDark: shareOf((at) => around.first[at]! < Number.POSITIVE_INFINITY) >= DARK,
  };
}

function reachOf({ first }: Surroundings): number {
  let [sum, all] = [0, 0];
  for (let at = 0; at < DIRECTIONS; at++) {
    if (first[at] === Number.POSITIVE_INFINITY) continue;
    sum += first[at]! * SPHERE[at]!.share;
    all += SPHERE[at]!.share;
  }
  return sum / all;
}

function isRoom(around: Surroundings, bounds: Bounds, outward: Vec3, isLit: boolean): boolean {
  const { first, last, lastFront, lastUpright } = around;
  const isClosed = (at: number): boolean => first[at]! < Number.POSITIVE_INFINITY;
  const closed = shareOf(isClosed);
  if (closed < CLOSED) return false;
  const toViewer = (at: number): boolean => dot(SPHERE[at]!.direction, outward) > WAY_OUT;
  if (shareOf((at) => last[at]! > 0, toViewer) < BLOCKED) return false;
  const walls = wallsOf(around);
  const holdsThings = shareOf((at) => !walls.has(around.firstThing[at]!), isClosed) >= THINGS;
  if (shareOf((at) => lastFront[at] === 1, isClosed) >= NEARLY_ALL) {
    if (isLit || holdsThings) return true;
    const upright = shareOf((at) => lastUpright[at]! < 0.2 || lastUpright[at]! > 0.95, isClosed);
    return upright >= 0.7 && shareOf((at) => first[at]! < 0.85 * last[at]!, isClosed) >= PARTS;
  }
  if (closed < CLOSED_BOX || shareOf((at) => isOnBox(around, at, bounds), isClosed) < CLOSED_BOX) return false;
  return isLit || holdsThings || shareOf((at) => first[at]! < 0.7 * last[at]!, isClosed) >= PARTS;
}

/** The things that most of the last surfaces belong to. */
function wallsOf({ lastThing }: Surroundings): Set<number> {
  const shares = new Map<number, number>();
  lastThing.forEach((thing, at) => {
    shares.set(thing, (shares.get(thing) ?? 0) + SPHERE[at]!.share);
  });
  return new Set([...shares].filter(([, share]) => share >= 0.05).map(([thing]) => thing));
}

/** Whether the last surface lies in a side of the box around everything. */
function isOnBox({ place, last }: Surroundings, at: number, { min, max }: Bounds): boolean {
  return place.some((from, k) => {
    const x = from + last[at]! * SPHERE[at]!.direction[k]!;
    return Math.min(x - min[k]!, max[k]! - x) < 0.02 * (max[k]! - min[k]!);
  });
}

/** How much of the directions that count it is so in. */
function shareOf(isSo: (at: number) => boolean, counts: (at: number) => boolean = () => true): number {
  let [share, all] = [0, 0];
  for (let at = 0; at < DIRECTIONS; at++) {
    if (!counts(at)) continue;
    all += SPHERE[at]!.share;
    if (isSo(at)) share += SPHERE[at]!.share;
  }
  return all > 0 ? share / all : 0;
}

/** As far from the middle as one can go on its level and still see it; from where the viewer is, if that is nearly as far. Null: there is no step to go. */
function standIn(grid: RoomGrid, middle: Vec3, clearances: Uint8Array, least: number, outward: Vec3): Vec3 | null {
  let eye: Vec3 | null = null;
  let best = 0;
  for (let turn = 0; turn < 16; turn++) {
    const angle = (turn * Math.PI) / 8;
    const direction: Vec3 = [Math.sin(angle), 0, Math.cos(angle)];
    const far = grid.walk(middle, direction, clearances, least);
    const worth = far * (1 + 0.15 * dot(direction, outward));
    if (worth <= best * (1 + 1e-9)) continue;
    best = worth;
    eye = [middle[0] + far * direction[0], middle[1], middle[2] + far * direction[2]];
  }
  return eye;
}

/** Lights in a room were put there for who is in it. */
function hasLightIn(scene: Scene, time: number, { min, max }: Bounds): boolean {
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  return Object.values(scene.lights).some((light) => {
    const placed = placedLight(light, worldOf(transforms, world, light.node));
    if (placed.type === 'directional') return false;
    const at = placed.type === 'sphere' ? placed.center : placed.type === 'quad' ? placed.corner : placed.position;
    return at.every((x, k) => x >= min[k]! && x <= max[k]!);
  });
}

type TriangleVisitor = (a: Vec3, b: Vec3, c: Vec3, thing: number, seen: Seen) => boolean;

function trianglesIn(scene: Scene, time: number): number {
  let count = 0;
  visitMeshes(scene, time, ({ indices, matrices }) => {
    count += (indices.length / 3) * (matrices.length / 12);
  });
  return count;
}

/** The triangles of meshes in the world, until `visit` says that it is enough; then false. */
function visitTriangles(scene: Scene, time: number, visit: TriangleVisitor): boolean {
  let goesOn = true;
  let thing = 0;
  visitMeshes(scene, time, (mesh) => {
    for (let m = 0; m < mesh.matrices.length && goesOn; m += 12)
      goesOn = visitPlaced(mesh, m, thing, seenAs(scene, mesh), visit);
    thing++;
  });
  return goesOn;
}

function visitPlaced(mesh: PosedMesh, m: number, thing: number, seen: Seen, visit: TriangleVisitor): boolean {
  const { positions: p, indices, matrices } = mesh;
  const isMirrored = determinant(matrices, m) < 0;
  const corner = (i: number): Vec3 => {
    const at = 3 * indices[i]!;
    return transformPoint(matrices, m, [p[at]!, p[at + 1]!, p[at + 2]!]);
  };
  for (let i = 0; i < indices.length; i += 3) {
    const [b, c] = isMirrored ? [2, 1] : [1, 2];
    if (!visit(corner(i), corner(i + b), corner(i + c), thing, seen)) return false;
  }
  return true;
}

function seenAs(scene: Scene, { shape }: PosedMesh): Seen {
  const material = scene.materials[shape.material];
  if (material === undefined) return 'both';
  const { type, transmission, alphaMode, opacity = 1, doubleSided = true } = material;
  const isClear = type === 'dielectric' || (transmission?.weight ?? 0) > 0.05 || (alphaMode === 'blend' && opacity < 0.95); // biome-ignore format: one condition
  return isClear ? 'through' : doubleSided ? 'both' : 'front';
}
