/**
 * What a ray caster of 32-bit floats may answer, from the double-precision one and a bound on rounding.
 *
 * All rounding of the kernel (of the packed shape, the ray, and each operation) is as if every point of the ray were moved by at
 * most `delta`, by some path that stays within delta of the true one. So the kernel's first entry into a solid lies between the
 * first entry into the solid grown by delta and that into the solid shrunk by delta, and likewise for exits; and where these two
 * agree on entry, exit or miss, the kernel has to agree too. Only a ray that passes a silhouette, or starts at a surface, closer
 * than delta is left open, and it is still held to the stretch within the grown solid.
 */
import {
  intersectBox,
  intersectPlane,
  intersectQuad,
  intersectSphere,
  outwardNormal,
} from '../../../../packages/renderer/src/reference/intersect.ts';
import type { PreparedAnalytic, PreparedBox } from '../../../../packages/renderer/src/reference/prepare.ts';
import type { Ray } from '../../../../packages/renderer/src/reference/ray.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import {
  add,
  addScaled,
  dot,
  length,
  negate,
  normalize,
  subtract,
} from '../../../../packages/renderer/src/scene/vec3.ts';
import { type RayCase, START } from './ray-cases.ts';

/** Half a unit in the last place of 32-bit floats, relative. */
const ROUNDING = 2 ** -24;
/** Operations in a row between the scene and t, rotation of a box included, each of which may round. Counted: 20 or less. */
const OPERATIONS = 24;
/** A plane met later than this, in sizes of everything involved, was not met: parallel rays must not come back from infinity. */
const ENDLESS = 1e15;

export interface Expectation {
  /** Metres by which rounding may move a point. */
  readonly delta: number;
  readonly mayMiss: boolean;
  /** The distances that a hit may have; null: it must be a miss. */
  readonly hit: { readonly from: number; readonly to: number } | null;
  /** Normals that a hit may have, each up to `normalTolerance`; any when there is none. */
  readonly normals: readonly Vec3[];
  readonly normalTolerance: number;
  /** Whether rounding leaves no choice between miss, entry and exit. */
  readonly decided: boolean;
}

function intersect(shape: PreparedAnalytic, ray: Ray): number {
  if (shape.type === 'sphere') return intersectSphere(shape, ray);
  if (shape.type === 'box') return intersectBox(shape, ray);
  return shape.type === 'plane' ? intersectPlane(shape, ray) : intersectQuad(shape, ray);
}

function rayOf({ origin, direction, rule }: RayCase, shape: PreparedAnalytic, eye: Vec3): Ray {
  const own = rule === START.leaving || rule === START.inside;
  return {
    origin: add(eye, origin),
    direction: normalize(direction),
    tMin: rule === START.fromEye ? 0 : 1e-5 * length(origin),
    leaving: own ? shape : null,
    leavingTriangle: -1,
    inward: rule === START.inside,
    eye,
  };
}

function sizeOf(shape: PreparedAnalytic): number {
  if (shape.type === 'sphere') return shape.radius;
  if (shape.type === 'box') return length(shape.halfSize);
  if (shape.type === 'plane') return 0;
  return 1 / length(shape.toS) + 1 / length(shape.toT);
}

const anchor = (shape: PreparedAnalytic): Vec3 => {
  if (shape.type === 'plane') return shape.point;
  return shape.type === 'quad' ? shape.corner : shape.center;
};

/** The sum of all lengths that take part. */
function scaleOf(shape: PreparedAnalytic, ray: RayCase, eye: Vec3): number {
  const fromEye = subtract(anchor(shape), eye);
  return length(ray.origin) + length(fromEye) + length(subtract(fromEye, ray.origin)) + sizeOf(shape);
}

type Solid = Extract<PreparedAnalytic, { type: 'sphere' | 'box' }>;

function grown(solid: Solid, by: number): Solid {
  if (solid.type === 'sphere') return { ...solid, radius: Math.max(solid.radius + by, 0) };
  return { ...solid, halfSize: solid.halfSize.map((h) => h + by) as unknown as Vec3 };
}

type Meeting = { readonly t: number; readonly normal: Vec3; readonly kind: 'entry' | 'exit' | 'miss' };

function meet(shape: PreparedAnalytic, ray: Ray): Meeting {
  const t = intersect(shape, ray);
  if (t === Infinity) return { t, normal: [0, 0, 0], kind: 'miss' };
  const normal = outwardNormal(shape, ray, t);
  return { t, normal, kind: dot(normal, ray.direction) < 0 ? 'entry' : 'exit' };
}

const MISS = { mayMiss: true, hit: null, normals: [], normalTolerance: 0, decided: true };

function expectSolid(solid: Solid, ray: RayCase, eye: Vec3, delta: number): Expectation {
  const larger = grown(solid, delta);
  const smaller = grown(solid, -delta);
  const outer = meet(larger, rayOf(ray, larger, eye));
  const inner = meet(smaller, rayOf(ray, smaller, eye));
  if (outer.kind === 'miss' && inner.kind === 'miss') return { ...MISS, delta };
  const decided = outer.kind === inner.kind;
  // Where the ray leaves the grown solid for good.
  const end = intersect(larger, { ...rayOf(ray, larger, eye), leaving: larger, inward: true });
  const start = ray.rule === START.inside ? 0 : rayOf(ray, larger, eye).tMin;
  const from = (decided || outer.kind === 'entry' ? Math.min(outer.t, inner.t) : start) - delta;
  const to = (decided ? Math.max(outer.t, inner.t) : end) + delta;
  const mayMiss = ray.rule !== START.inside && (outer.kind === 'miss' || inner.kind === 'miss');
  const slack = to - from + 2 * delta;
  const faces = (box: PreparedBox) => facesAt(box, rayOf(ray, larger, eye), outer, slack);
  const normals = !decided ? [] : solid.type === 'box' ? faces(solid) : [outer.normal, inner.normal];
  const turned = solid.type === 'sphere' ? (2 * (to - from)) / solid.radius : 0;
  return { delta, decided, mayMiss, hit: { from, to }, normals, normalTolerance: 1e-5 + turned };
}

/** Of the faces that the hit may lie on (on edges there are several) those that an entry, or an exit, can go through. */
function facesAt(box: PreparedBox, { origin, direction }: Ray, { t, kind }: Meeting, slack: number): Vec3[] {
  const fromCenter = subtract(addScaled(origin, direction, t), box.center);
  const outwards = box.axes.flatMap((axis, k) => [axis, negate(axis)].map((n) => ({ n, half: box.halfSize[k]! })));
  const near = outwards.filter(({ n, half }) => Math.abs(dot(fromCenter, n) - half) <= slack);
  const onWay = near.filter(({ n }) => (kind === 'entry' ? dot(n, direction) <= 0 : dot(n, direction) >= 0));
  return onWay.map(({ n }) => n);
}

type Flat = Exclude<PreparedAnalytic, Solid>;

/** How far the point lies outside of a flat shape within its plane; negative: inside, from its nearest edge. */
function outside(shape: Flat, point: Vec3): number {
  if (shape.type === 'plane') return -Infinity;
  const fromCorner = subtract(point, shape.corner);
  const beyond = (to: Vec3) => (Math.abs(dot(to, fromCorner) - 0.5) - 0.5) / length(to);
  return Math.max(beyond(shape.toS), beyond(shape.toT));
}

/** Rounding turns a ray by about this much, so that one which is closer to parallel may go either way. */
const TURN = OPERATIONS * ROUNDING;

function expectFlat(shape: Flat, rayCase: RayCase, eye: Vec3, base: number): Expectation {
  const ray = rayOf(rayCase, shape, eye);
  if (ray.leaving) return { ...MISS, delta: base };
  const height = dot(subtract(anchor(shape), ray.origin), shape.normal);
  const cosine = dot(ray.direction, shape.normal);
  if (Math.abs(cosine) < 8 * TURN) return expectGrazing(shape, rayCase, { height, cosine, base, eye });
  const t = height / cosine;
  const delta = base + TURN * Math.abs(t);
  const slack = delta * (1 + 1 / Math.abs(cosine));
  if (shape.type === 'plane') return expectPlane(shape, ray, t, { delta, slack });
  const beyond = Math.max(outside(shape, addScaled(ray.origin, ray.direction, t)), ray.tMin - t);
  if (beyond > slack) return { ...MISS, delta };
  const open = beyond > -slack;
  if (!open && intersect(shape, ray) === Infinity) throw new Error('The reference disagrees with itself.');
  const hit = { from: t - slack, to: t + slack };
  return { delta, hit, mayMiss: open, normals: [shape.normal], normalTolerance: 1e-5, decided: !open };
}

/** Met by all that goes away from the eye's side, at once by what starts beyond. */
function expectPlane(
  plane: Extract<Flat, { type: 'plane' }>,
  ray: Ray,
  t: number,
  { delta, slack }: { delta: number; slack: number },
): Expectation {
  const eyeHeight = dot(subtract(ray.eye, plane.point), plane.normal);
  if (eyeHeight * dot(ray.direction, plane.normal) > 0) return { ...MISS, delta };
  const at = Math.max(t, 0);
  const hit = { from: at - slack, to: at + slack };
  return { delta, hit, mayMiss: false, normals: [plane.normal], normalTolerance: 1e-5, decided: true };
}

type Grazing = { height: number; cosine: number; base: number; eye: Vec3 };

/** A ray that is all but parallel to a flat shape: it misses, or meets it far away; exactly along an axis it misses. */
function expectGrazing(shape: Flat, ray: RayCase, { height, cosine, base, eye }: Grazing): Expectation {
  const exact = shape.normal.filter((x) => x === 0).length === 2;
  if (exact && cosine === 0) return { ...MISS, delta: base };
  const from = shape.type === 'plane' ? 0 : (Math.abs(height) - base) / (Math.abs(cosine) + TURN);
  const to = ENDLESS * scaleOf(shape, ray, eye);
  return {
    delta: base,
    hit: { from, to },
    mayMiss: true,
    normals: [shape.normal],
    normalTolerance: 1e-5,
    decided: false,
  };
}

export function expectation(shape: PreparedAnalytic, ray: RayCase, eye: Vec3): Expectation {
  const delta = OPERATIONS * ROUNDING * scaleOf(shape, ray, eye);
  if (shape.type === 'sphere' || shape.type === 'box') return expectSolid(shape, ray, eye, delta);
  return expectFlat(shape, ray, eye, delta);
}

/** What is wrong with an answer (t, normal; t ≥ 10³⁰ for a miss), or null. */
export function fault(expected: Expectation, [t, x, y, z]: readonly [number, number, number, number]): string | null {
  if (![t, x, y, z].every(Number.isFinite)) return 'is not a number';
  if (t >= 1e30) return expected.mayMiss ? null : 'is missed';
  if (!expected.hit) return 'is hit';
  if (t < expected.hit.from || t > expected.hit.to) return 'is hit at the wrong distance';
  if (t < 0) return 'is hit behind the start';
  const normal: Vec3 = [x, y, z];
  if (Math.abs(length(normal) - 1) > 1e-5) return 'has a normal that is not of length 1';
  const { normals, normalTolerance } = expected;
  if (normals.length === 0 || normals.some((n) => length(subtract(n, normal)) <= normalTolerance)) return null;
  return 'has a wrong normal';
}
