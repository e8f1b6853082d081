/** Things that nodes carry, put into the world. */
import {
  AFFINE_LENGTH,
  cofactors,
  composeAffine,
  determinant,
  multiplyAffine,
  type Numbers,
  transformDirection,
  transformPoint,
} from './affine.ts';
import { sceneAt } from './animation.ts';
import { nodeTransforms, worldOf } from './node-transforms.ts';
import type { Box, Camera, Light, MeshShape, Scene, Shape, Vec3 } from './scene.ts';
import { dot, length, normalize, rotate, scale } from './vec3.ts';

/** The meshes among a scene's shapes, with their names. */
export const meshShapes = (scene: Pick<Scene, 'shapes'>): [string, MeshShape][] =>
  Object.entries(scene.shapes as Record<string, Shape | MeshShape>).filter(
    (entry): entry is [string, MeshShape] => entry[1].type === 'mesh',
  );

/** From the mesh's own space to the world (or, where the shape names a node, to the node's): scale, turn and translation, and before them `matrix`, as 12 numbers. */
export function placementOf({ translation, rotation, scale: s, matrix }: MeshShape): Float64Array {
  const [x, y, z] = [rotate([s[0], 0, 0], rotation), rotate([0, s[1], 0], rotation), rotate([0, 0, s[2]], rotation)];
  const rows = ([0, 1, 2] as const).flatMap((r) => [x[r], y[r], z[r], translation[r]]);
  const out = Float64Array.from(rows);
  if (matrix) multiplyAffine(out, 0, rows, 0, matrix, 0);
  return out;
}

/**
 * The world matrices of a mesh, 12 numbers each (`Affine`): one, or one of each of its instances. `world` is that of its node. A mesh with
 * a skin is placed by its joints: its vertices are in the world already.
 */
export function meshMatrices(shape: MeshShape, world: Numbers): Float64Array {
  const { instances, skin } = shape;
  if (skin !== undefined) return Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0);
  const own = placementOf(shape);
  const out = new Float64Array(instances ? instances.length : AFFINE_LENGTH);
  for (let at = 0; at < out.length; at += AFFINE_LENGTH) {
    if (instances) {
      multiplyAffine(out, at, instances, at, own, 0);
      multiplyAffine(out, at, world, 0, out, at);
    } else multiplyAffine(out, at, world, 0, own, 0);
  }
  return out;
}

/**
 * The scene at a time with everything that nodes carry put into the world: nothing names a node any more, and meshes have their matrices
 * (16 numbers, or those of their instances). Throws an Error when a node would stretch a sphere or a box out of its form.
 */
export function placedSceneAt(scene: Scene, time: number): Scene {
  const now = sceneAt(scene, time);
  if (scene.nodes === undefined) return now;
  const transforms = nodeTransforms(scene);
  const world = transforms.at(time);
  return placedScene(now, (node) => worldOf(transforms, world, node), true);
}

/** The same for a scene that is animated already. `of`: the world matrix of a node. Without `meshes` these stay where nodes carry them. */
export function placedScene(now: Scene, of: (node: string) => Numbers, meshes: boolean): Scene {
  const things = <Thing extends { readonly node?: string }>(
    all: Readonly<Record<string, Thing>>,
    place: (thing: Thing, world: Numbers, name: string) => Thing,
    counts: (thing: Thing) => boolean = () => true,
  ): Readonly<Record<string, Thing>> => {
    let moved: Record<string, Thing> | null = null;
    for (const [name, thing] of Object.entries(all)) {
      if (thing.node === undefined || !counts(thing)) continue;
      moved ??= Object.assign(Object.create(null), all) as Record<string, Thing>;
      moved[name] = place(thing, of(thing.node), name);
    }
    return moved ?? all;
  };
  const { nodes: _, ...rest } = now;
  const shapes = now.shapes as Readonly<Record<string, Shape | MeshShape>>;
  return {
    ...rest,
    camera: now.camera.node === undefined ? now.camera : placedCamera(now.camera, of(now.camera.node)),
    lights: things(now.lights, placedLight),
    shapes: things(shapes, placedShape, ({ type }) => meshes || type !== 'mesh') as Scene['shapes'],
    ...(now.cameras && { cameras: things(now.cameras, placedCamera) }),
  };
}

export function placedCamera({ node: _, ...camera }: Camera, world: Numbers): Camera {
  return {
    ...camera,
    eye: transformPoint(world, 0, camera.eye),
    target: transformPoint(world, 0, camera.target),
    up: transformDirection(world, 0, camera.up),
  };
}

export function placedLight({ node: _, ...light }: Light, world: Numbers): Light {
  const point = (p: Vec3) => transformPoint(world, 0, p);
  const direction = (d: Vec3) => transformDirection(world, 0, d);
  switch (light.type) {
    case 'sphere':
      return { ...light, center: point(light.center), radius: light.radius * Math.cbrt(Math.abs(determinant(world))) };
    case 'quad':
      return { ...light, corner: point(light.corner), u: direction(light.u), v: direction(light.v) };
    case 'point':
      return { ...light, position: point(light.position) };
    case 'spot':
      return { ...light, position: point(light.position), direction: direction(light.direction) };
    case 'directional':
      return { ...light, direction: direction(light.direction) };
  }
}

export function placedShape({ node: _, ...shape }: Shape | MeshShape, world: Numbers, name = ''): Shape | MeshShape {
  switch (shape.type) {
    case 'mesh':
      return placedMesh(shape, world);
    case 'quad':
      return {
        ...shape,
        corner: transformPoint(world, 0, shape.corner),
        u: transformDirection(world, 0, shape.u),
        v: transformDirection(world, 0, shape.v),
      };
    case 'plane': {
      const c = cofactors(world, 0);
      const row = (r: number): number =>
        c[r]! * shape.normal[0] + c[r + 1]! * shape.normal[1] + c[r + 2]! * shape.normal[2];
      return { ...shape, point: transformPoint(world, 0, shape.point), normal: normalize([row(0), row(3), row(6)]) };
    }
    case 'sphere': {
      const [radius] = sidesOf(world, [0, 0, 0], [shape.radius, shape.radius, shape.radius], name, true).lengths;
      return { ...shape, center: transformPoint(world, 0, shape.center), radius: radius! };
    }
    case 'box':
      return placedBox(shape, world, name);
  }
}

function placedMesh(shape: MeshShape, world: Numbers): MeshShape {
  const matrices = meshMatrices(shape, world);
  const { instances, ...rest } = shape;
  const still = { ...rest, translation: [0, 0, 0], rotation: [0, 0, 0], scale: [1, 1, 1] } as const;
  if (instances) return { ...still, matrix: undefined, instances: Float32Array.from(matrices) };
  return { ...still, matrix: [...matrices, 0, 0, 0, 1] };
}

/** How far from a right angle, or from even lengths, a form may be bent by rounding. */
const SLACK = 1e-4;

/** Where the sides of a box go: their lengths and directions; they must stay at right angles. */
function sidesOf(world: Numbers, rotation: Vec3, size: Vec3, name: string, even: boolean) {
  const axes = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const).map((axis) => transformDirection(world, 0, rotate(axis, rotation))); // biome-ignore format: a matrix
  const stretches = axes.map(length);
  const most = Math.max(...stretches);
  const skewed = [[0, 1], [1, 2], [2, 0]].some(([a, b]) => Math.abs(dot(axes[a!]!, axes[b!]!)) > SLACK * most * most); // biome-ignore format: pairs
  const uneven = even && stretches.some((stretch) => Math.abs(stretch - most) > SLACK * most);
  if (skewed || uneven || !(most > 0))
    throw new Error(
      `The node that carries the shape "${name}" would ${skewed ? 'shear' : uneven ? 'stretch' : 'flatten'} it, which a ${even ? 'sphere' : 'box'} cannot be.`,
    );
  return { axes, lengths: size.map((side, i) => side * stretches[i]!) };
}

function placedBox(box: Omit<Box, 'node'>, world: Numbers, name: string): Box {
  const { axes, lengths } = sidesOf(world, box.rotation, box.size, name, false);
  const [x, y, z] = axes.map((axis) => scale(axis, 1 / length(axis))) as [Vec3, Vec3, Vec3];
  const sign = determinant([...x, 0, ...y, 0, ...z, 0]) < 0 ? -1 : 1; // a box is its own mirror image
  return {
    ...box,
    center: transformPoint(world, 0, box.center),
    size: lengths as unknown as Vec3,
    rotation: anglesOf(x, y, scale(z, sign)),
  };
}

/** Degrees about X, then Y, then Z for a turn that takes the axes to these: R = Rz·Ry·Rx, whose columns they are. */
export function anglesOf(x: Vec3, y: Vec3, z: Vec3): Vec3 {
  const degrees = (radians: number) => (radians * 180) / Math.PI;
  const sinY = Math.min(Math.max(-x[2], -1), 1);
  if (Math.abs(sinY) > 1 - 1e-12) return [degrees(Math.atan2(-z[1], y[1])), degrees(Math.asin(sinY)), 0];
  return [degrees(Math.atan2(y[2], z[2])), degrees(Math.asin(sinY)), degrees(Math.atan2(x[1], x[0]))];
}

/** What `composeAffine` makes, as an array. */
export function affineOf(translation: Vec3, rotation: Numbers, scaling: Vec3): number[] {
  const out: number[] = new Array(AFFINE_LENGTH).fill(0);
  composeAffine(out, 0, translation, 0, rotation, 0, scaling, 0);
  return out;
}
