/**
 * Scene → the scene table's bytes. Shapes are sorted by kind (spheres, boxes, quads, planes) and keep the file's order inside a
 * kind, except that planes which cast no shadow come last; what an instance of a mesh is made of follows them. Positions become relative to `eye` here, in double precision.
 */
import { sphereLights } from '../scene/lights.ts';
import type { Box, Color, Material, Plane, Quad, Scene, Shape, Sphere, SphereLight, Vec3 } from '../scene/scene.ts';
import { add, cross, dot, length, normalize, scale, subtract } from '../scene/vec3.ts';
import type { EmitterValues } from './emitter-values.ts';
import { TABLE_WIDTH, type TableStruct, tableColumn } from './layout.ts';
import type { PackedEmitters } from './pack-emitters.ts';
import type { PackedEnvironment } from './pack-environment.ts';
import type { BodyRows, PackedGeometry } from './pack-geometry.ts';
import type { PackedTextures } from './pack-textures.ts';
import { refuseMeshes, UntraceableSceneError } from './refuse-meshes.ts';
import type { WorkerPoses } from './worker-poses.ts';
import { type Block, createBlock, type StructValues, writeStruct } from './write-struct.ts';

/** What the rows of a table were made from; another object whenever they are written. */
export interface PackSource {
  readonly scene: Scene;
  readonly eye: Vec3;
  readonly reach: ViewReach;
  /** Whether they have all that the path integrator reads. */
  readonly surfaces: boolean;
}

export interface PackedScene {
  readonly source: PackSource;
  /** Texels of the table, row by row; only the first `rows` rows hold anything. */
  readonly table: Block;
  readonly rows: number;
  /** Index past the last sphere, box, quad and plane. */
  readonly shapeEnds: readonly [number, number, number, number];
  /** Index past the last shape that may stand between a light and a point. */
  readonly occluderEnd: number;
  readonly lightCount: number;
  /** Rows after those of the shapes that hold a light's ball. */
  readonly ballCount: number;
  /** Rows that hold an emitter of the path integrator; the first ones of them are infinitely far. */
  readonly emitterCount: number;
  readonly farEmitters: number;
  /** Row of the root of the tree over the others, and its levels; 0: there is no tree. */
  readonly lightTree: number;
  readonly lightTreeDepth: number;
  /** Sky colours. */
  readonly horizon: Color;
  readonly zenith: Color;
  /** What the path integrator looks up and samples; null in scenes packed for the classic one. */
  readonly environment: PackedEnvironment | null;
  /** How far it is turned about +Y, 0 … 1. */
  readonly environmentTurn: number;
  /** Meshes and where they stand; null in scenes packed for the classic integrator. */
  readonly geometry: PackedGeometry | null;
  /** What meshes are made of, and what shines beside them; null likewise. */
  readonly bodies: BodyRows | null;
  readonly lights: PackedEmitters | null;
  /** What shines among the meshes, where the table has it. */
  readonly glowing: readonly EmitterValues[];
  /** What their materials use; null likewise. */
  readonly textures: PackedTextures | null;
  /** Whether rays of the camera start on both sides of some plane. */
  readonly planesCutView: boolean;
  /** Names in table order, so that an index can be told to people. */
  readonly shapeNames: readonly string[];
}

/** Where rays of the camera start: anywhere on the parallelogram eye ± right ± up. */
export interface ViewReach {
  readonly right: Vec3;
  readonly up: Vec3;
}
const AT_EYE: ViewReach = { right: [0, 0, 0], up: [0, 0, 0] };

const KINDS = ['sphere', 'box', 'quad', 'plane'] as const;
const ROW_BYTES = TABLE_WIDTH * 16;

/** Writes the part of a row that this struct has. */
export function writeRow<S extends TableStruct>(table: Block, name: S, row: number, values: StructValues<S>): void {
  writeStruct(table, name, row * ROW_BYTES + tableColumn(name) * 16, values);
}

export interface PackOptions {
  /** A packed scene that is no longer needed; its memory is taken when it is large enough. */
  readonly reuse?: PackedScene | undefined;
  /** Where the camera's rays may start. */
  readonly reach?: ViewReach;
  /** Whether meshes get rows too, after all other shapes; without it a scene that has some is refused. */
  readonly meshes?: boolean;
  /** Whether the rows of meshes in `reuse` are good: they do not depend on the eye. */
  readonly keepMeshes?: boolean;
  /** Rows that are needed beside shapes and lights, and those after them all. */
  readonly leastRows?: number;
  /** Rows of their own after all of these: of the tree over lights, and of layers. */
  readonly moreRows?: number;
  /** Of the data that a device takes which bends meshes itself; 0, the default: they are bent here. */
  readonly deviceRows?: number;
  /** Of the scene that plays, where a worker bends its meshes. */
  readonly poses?: WorkerPoses | null;
}

export function packScene(scene: Scene, eye: Vec3, options: PackOptions = {}): PackedScene {
  if (!options.meshes) refuseMeshes(scene);
  const { reuse, reach = AT_EYE, leastRows = 1, moreRows = 0, keepMeshes = false } = options;
  const named = Object.entries(scene.shapes);
  const sorted = KINDS.map((kind) => named.filter(([, s]) => s.type === kind));
  const lights = sphereLights(scene);
  const balls = lights.filter((light) => light.visible);
  const rows = Math.max(named.length + balls.length, lights.length, leastRows) + moreRows;
  const table = reuse && reuse.table.bytes.byteLength >= rows * ROW_BYTES ? reuse.table : createBlock(rows * ROW_BYTES);
  const put = <S extends TableStruct>(name: S, row: number, values: StructValues<S>) =>
    writeRow(table, name, row, values);

  const casts = ([, plane]: [string, Shape]) =>
    castsShadow(plane as Plane, eye, lights) || cuts(plane as Plane, eye, reach);
  const planes = sorted[3]!;
  sorted[3] = [...planes.filter(casts), ...planes.filter((plane) => !casts(plane))];
  const meshes = named.filter(([, { type }]) => type === 'mesh');
  const ordered = [...sorted.flat(), ...meshes];
  const ids = new Map(named.map(([name], index) => [name, index + 1]));
  ordered.forEach(([name, shape], row) => {
    if (shape.type === 'mesh') {
      if (keepMeshes) return;
    } else {
      const { center, radius, ...extent } = shapeValues(shape, eye);
      put('Bounds', row, { center, radius });
      put('Extent', row, extent);
    }
    put('Material', row, { ...materialValues(scene.materials[shape.material]!), id: ids.get(name)! });
  });
  lights.forEach((light, row) => {
    put('Light', row, lightValues(light, eye));
  });
  balls.forEach((light, k) => {
    put('Ball', named.length + k, ballValues(light, eye));
  });
  let end = 0;
  const shapeEnds = sorted.map((kind) => (end += kind.length)) as [number, number, number, number];
  const occluderEnd = shapeEnds[2] + planes.filter(casts).length;
  return {
    source: { scene, eye, reach, surfaces: false },
    table,
    rows,
    shapeEnds,
    occluderEnd,
    lightCount: lights.length,
    planesCutView: planes.some(([, plane]) => cuts(plane as Plane, eye, reach)),
    ballCount: balls.length,
    emitterCount: 0,
    farEmitters: 0,
    lightTree: rows - moreRows,
    lightTreeDepth: 0,
    horizon: scene.sky.horizon,
    zenith: scene.sky.zenith,
    environment: null,
    environmentTurn: 0,
    geometry: null,
    bodies: null,
    lights: null,
    glowing: [],
    textures: null,
    shapeNames: ordered.map(([name]) => name),
  };
}

/**
 * A plane that has the eye and every light wholly on one side casts no shadow that can be seen: what the camera sees, directly
 * or by mirrors, lies on that side too, since the plane itself would be hit on the way to the other; and a line between two
 * points of one side does not cross. This spares a closed room the tests of its six walls.
 */
function castsShadow({ point, normal }: Plane, eye: Vec3, lights: readonly SphereLight[]): boolean {
  const unit = normalize(normal);
  const height = (p: Vec3) => dot(unit, subtract(p, point));
  const side = Math.sign(height(eye));
  return !lights.every((l) => height(l.center) * side > l.radius);
}

/**
 * Whether the plane goes through where the camera's rays start, and not only through the eye. It then has no side that all paths
 * are on: the kernels take both of its sides for real (intersect/plane.wesl), and it may cast shadows. Rare: a floor that an
 * orthographic view reaches below, a wall closer than a lens is wide.
 */
function cuts({ point, normal }: Plane, eye: Vec3, { right, up }: ViewReach): boolean {
  const reach = Math.abs(dot(normal, right)) + Math.abs(dot(normal, up));
  return reach > 0 && Math.abs(dot(normal, subtract(eye, point))) <= reach;
}

const equal = (a: Vec3, b: Vec3): boolean => a[0] === b[0] && a[1] === b[1] && a[2] === b[2];

/** Whether packing again, for the path integrator, would write the same rows. */
export function isPackedFrom(
  { source }: PackedScene,
  scene: Scene,
  eye: Vec3,
  { reach = AT_EYE }: PackOptions,
): boolean {
  const { right, up } = source.reach;
  const same = source.surfaces && source.scene === scene;
  return same && equal(source.eye, eye) && equal(right, reach.right) && equal(up, reach.up);
}

type ShapeValues = StructValues<'Bounds'> & StructValues<'Extent'>;

function shapeValues(shape: Shape, eye: Vec3): ShapeValues {
  switch (shape.type) {
    case 'sphere':
      return sphereValues(shape, eye);
    case 'box':
      return boxValues(shape, eye);
    case 'plane':
      return planeValues(shape, eye);
    case 'quad':
      return quadValues(shape, eye);
    case 'mesh':
      throw new UntraceableSceneError(`The mesh "${shape.mesh}" has no row of its own here.`);
  }
}

function sphereValues({ center, radius }: Sphere, eye: Vec3): ShapeValues {
  return { center: subtract(center, eye), radius };
}

function boxValues({ center, size, rotation }: Box, eye: Vec3): ShapeValues {
  const half = scale(size, 0.5);
  const q = eulerQuaternion(rotation);
  // The kernel turns from world to box: the inverse rotation.
  return {
    center: subtract(center, eye),
    radius: length(half),
    a: [-q[0], -q[1], -q[2], q[3]],
    b: [...half, 0],
  };
}

function planeValues({ point, normal }: Plane, eye: Vec3): ShapeValues {
  const n = normalize(normal);
  return { center: n, radius: dot(n, subtract(point, eye)) };
}

function quadValues({ corner, u, v }: Quad, eye: Vec3): ShapeValues {
  const normal = cross(u, v);
  const area2 = dot(normal, normal);
  const reciprocalU = scale(cross(v, normal), 1 / area2);
  const reciprocalV = scale(cross(normal, u), 1 / area2);
  const fromCorner = scale(add(u, v), 0.5);
  const otherHalf = scale(subtract(u, v), 0.5);
  const center = subtract(add(corner, fromCorner), eye);
  const radius = Math.max(length(fromCorner), length(otherHalf));
  return { center, radius, a: [...reciprocalU, 0], b: [...reciprocalV, 0] };
}

/** Degrees about X, then Y, then Z, as a unit quaternion (x, y, z, w). No rotation gives w = 1 exactly. */
export function eulerQuaternion(degrees: Vec3): [number, number, number, number] {
  const h = degrees.map((d) => (d * Math.PI) / 360);
  const [cx, cy, cz] = h.map(Math.cos) as [number, number, number];
  const [sx, sy, sz] = h.map(Math.sin) as [number, number, number];
  return [
    sx * cy * cz - cx * sy * sz,
    cx * sy * cz + sx * cy * sz,
    cx * cy * sz - sx * sy * cz,
    cx * cy * cz + sx * sy * sz,
  ];
}

function materialValues(m: Material): StructValues<'Material'> {
  const roughness = Math.max(m.roughness, 0.05);
  return {
    baseColor: m.baseColor,
    reflectivity: m.reflectivity,
    specular: m.specular,
    exponent: Math.max(2 / roughness ** 4 - 2, 0),
  };
}

function lightValues(light: SphereLight, eye: Vec3): StructValues<'Light'> {
  return {
    center: subtract(light.center, eye),
    radius: light.radius,
    ambient: light.ambient,
    spare0: 0,
    diffuse: light.diffuse,
    power: powerOf(light),
    specular: light.specular,
    spare1: 0,
  };
}

function ballValues(light: SphereLight, eye: Vec3): StructValues<'Ball'> {
  return {
    center: subtract(light.center, eye),
    radius: light.radius,
    diffuse: light.diffuse,
    halo: light.halo * powerOf(light),
    radiance: light.radiance,
    spare0: 0,
    spare1: 0,
    spare2: 0,
  };
}

const powerOf = (light: SphereLight): number => light.radiance * light.radius ** 2;
