/** Random shapes, and rays that look for their weak spots. What a GPU gets is rounded to 32 bits; so is what is kept here. */

import type { AnalyticShape, Box, Quad, Scene, Sphere, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import {
  addScaled,
  cross,
  dot,
  length,
  normalize,
  rotate,
  scale,
} from '../../../../packages/renderer/src/scene/vec3.ts';
import { between, inCube, pick, type Random, randomDirection, seededRandom } from '../../../fixtures/random.ts';
import { testScene } from '../../../fixtures/scenes.ts';

/** Where the rays of a batch take place. */
export interface Setting {
  readonly seed: number;
  /** Metres. */
  readonly size: number;
  /** Distance of the shapes from the eye, in sizes. */
  readonly reach: number;
  /** World coordinates of the eye, each. */
  readonly eye: number;
  /** Thickness of boxes, in sizes; 1 = like the other sides. */
  readonly thickness: number;
}

/** How a ray starts: shape-probe.wesl has the same numbers. */
export const START = { fromEye: 0, leaving: 1, inside: 2, elsewhere: 3 } as const;
export type StartRule = (typeof START)[keyof typeof START];

export interface RayCase {
  /** Index of the shape in the file. */
  readonly shape: number;
  readonly rule: StartRule;
  /** From the eye, exactly as the GPU gets it. */
  readonly origin: Vec3;
  /** Exactly as the GPU gets it: of length 1 up to rounding. */
  readonly direction: Vec3;
}

const KINDS = ['sphere', 'box', 'plane', 'quad'] as const;
const SHAPES_PER_KIND = 30;

const rounded = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];

/** None, by less than a 32-bit cosine can tell, or any. Degrees. */
function randomRotation(random: Random): Vec3 {
  const choice = random();
  if (choice < 0.3) return [0, 0, 0];
  return inCube(random, choice < 0.45 ? 0.02 : 180);
}

function randomQuad(random: Random, size: number, near: Vec3): Quad {
  for (;;) {
    const axes: Vec3[] = [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ];
    const start = Math.floor(random() * 3);
    const straight = random() < 0.4;
    const edge = (k: number) =>
      straight ? scale(axes[(start + k) % 3]!, size * between(random, 0.1, 1)) : inCube(random, size);
    const [u, v] = [edge(0), edge(1)];
    const skew = length(cross(u, v)) / (length(u) * length(v));
    if (skew < 0.2 || Math.min(length(u), length(v)) < 0.1 * size) continue;
    return { type: 'quad', corner: near, u, v, material: 'white' };
  }
}

function randomShape(
  random: Random,
  kind: AnalyticShape['type'],
  { size, reach, eye, thickness }: Setting,
): AnalyticShape {
  const center = addScaled([eye, -eye, eye], inCube(random, size), reach);
  const side = () => size * between(random, 0.1, 2);
  switch (kind) {
    case 'sphere':
      return { type: 'sphere', center, radius: side() / 2, material: 'white' };
    case 'box':
      return {
        type: 'box',
        center,
        size: [side(), side() * thickness, side()],
        rotation: randomRotation(random),
        material: 'white',
      };
    case 'plane':
      return {
        type: 'plane',
        point: center,
        normal: scale(randomDirection(random), between(random, 0.1, 9)),
        material: 'white',
      };
    case 'quad':
      return randomQuad(random, size, center);
  }
}

/** The shapes of a batch, of all kinds in turn, and the eye that they are packed for. */
export function randomScene(setting: Setting): Scene {
  const random = seededRandom(setting.seed);
  const shapes: Record<string, AnalyticShape> = {};
  for (let k = 0; k < SHAPES_PER_KIND; k++)
    for (const kind of KINDS) shapes[`${kind} ${k}`] = randomShape(random, kind, setting);
  const { eye } = setting;
  const camera = { eye: [eye, -eye, eye], target: [0, 1, 0], up: [0, 1, 0], verticalFov: 60 } as const;
  return testScene(shapes, {}, { camera });
}

/** A place of interest on a shape, and the outward normal there (on an edge: of one of its faces). */
interface Spot {
  readonly point: Vec3;
  readonly normal: Vec3;
}

function spotOnSphere(random: Random, { center, radius }: Sphere): Spot {
  const normal = randomDirection(random);
  return { point: addScaled(center, normal, radius), normal };
}

/** On a face, or on an edge or corner, which is where boxes and quads go wrong. */
function spotOnBox(random: Random, { center, size, rotation }: Box): Spot {
  const at = inCube(random, 1) as [number, number, number];
  const axis = Math.floor(random() * 3);
  const side = pick(random, [-1, 1]);
  at[axis] = side;
  for (const other of [1, 2]) if (random() < 0.25) at[(axis + other) % 3] = pick(random, [-1, 1]);
  const normal: [number, number, number] = [0, 0, 0];
  normal[axis] = side;
  const local: Vec3 = [(at[0] * size[0]) / 2, (at[1] * size[1]) / 2, (at[2] * size[2]) / 2];
  return { point: addScaled(center, rotate(local, rotation), 1), normal: rotate(normal, rotation) };
}

function spotOnQuad(random: Random, { corner, u, v }: Quad): Spot {
  const share = () => (random() < 0.2 ? pick(random, [0, 1]) : between(random, -0.3, 1.3));
  return { point: addScaled(addScaled(corner, u, share()), v, share()), normal: normalize(cross(u, v)) };
}

function spotOn(random: Random, shape: AnalyticShape, size: number): Spot {
  if (shape.type === 'sphere') return spotOnSphere(random, shape);
  if (shape.type === 'box') return spotOnBox(random, shape);
  if (shape.type === 'quad') return spotOnQuad(random, shape);
  const normal = normalize(shape.normal);
  return { point: addScaled(shape.point, cross(normal, inCube(random, size)), 1), normal };
}

const isSolid = (shape: AnalyticShape): shape is Sphere | Box => shape.type === 'sphere' || shape.type === 'box';

/** Any direction, or one that nearly grazes the surface. */
function directionFrom(random: Random, normal: Vec3, outwards: boolean): Vec3 {
  const any = randomDirection(random);
  const along = addScaled(any, normal, -dot(any, normal));
  const grazing = random() < 0.25 && length(along) > 0.1;
  const d = grazing ? addScaled(normalize(along), normal, between(random, 1e-6, 1e-2)) : any;
  return dot(d, normal) > 0 === outwards ? normalize(d) : normalize(addScaled(d, normal, -2 * dot(d, normal)));
}

/** A ray from somewhere near that meets, or just misses, a spot. */
function rayTowards(random: Random, spot: Spot, size: number): Omit<RayCase, 'shape'> {
  const direction = randomDirection(random);
  // At the spot itself, next to it, or anywhere near.
  const aside = pick(random, [0, 0, 10 ** between(random, -5, -2), 0.5]);
  const aim = addScaled(spot.point, inCube(random, size), aside);
  const back = size * between(random, 0.01, 5);
  return { rule: START.fromEye, origin: addScaled(aim, direction, -back), direction };
}

function rayFrom(random: Random, shape: AnalyticShape, size: number): Omit<RayCase, 'shape'> {
  const spot = spotOn(random, shape, size);
  const choice = random();
  if (choice < 0.5) return rayTowards(random, spot, size);
  if (choice < 0.6) {
    const center = isSolid(shape) ? shape.center : spot.point;
    const origin = addScaled(center, addScaled(spot.point, center, -1), between(random, 0, 0.99));
    return { rule: START.fromEye, origin, direction: randomDirection(random) };
  }
  const outwards = random() < 0.5;
  const direction = directionFrom(random, spot.normal, outwards);
  // On another shape that touches this one.
  if (choice < 0.75) return { rule: START.elsewhere, origin: spot.point, direction };
  const rule = outwards || !isSolid(shape) ? START.leaving : START.inside;
  return { rule, origin: spot.point, direction };
}

export function randomRays(setting: Setting, scene: Scene, count: number): RayCase[] {
  const random = seededRandom(setting.seed + 1);
  const shapes = Object.values(scene.shapes) as AnalyticShape[];
  return Array.from({ length: count }, (_, k) => {
    const index = k % shapes.length;
    const { rule, origin, direction } = rayFrom(random, shapes[index]!, setting.size);
    const fromEye = addScaled(origin, scene.camera.eye, -1);
    return { shape: index, rule, origin: rounded(fromEye), direction: rounded(direction) };
  });
}
