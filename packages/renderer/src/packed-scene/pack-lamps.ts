/**
 * Meshes that shine → emitters, and the tables by which kernels choose among their triangles: an alias table for each emitter, in
 * proportion to the triangles' areas in the world, and where a texture varies the emission to what each shows of it. A stretched instance has
 * other areas than the mesh, and so a table of its own; instances that are only moved, turned, mirrored or scaled evenly share one.
 */
import { cofactors, determinant, type Numbers, transformDirection } from '../scene/affine.ts';
import type { Body } from '../scene/bodies.ts';
import { type Bounds, placedBounds } from '../scene/bounds.ts';
import type { Vec3 } from '../scene/scene.ts';
import { add, addScaled, cross, dot, length, scale, subtract } from '../scene/vec3.ts';
import { aliasTable } from './alias-table.ts';
import { EMITTER_KIND, type EmitterValues, NO_EMITTER } from './emitter-values.ts';
import { brightnessOf } from './lamp-brightness.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';
import type { PackedMesh } from './packed-mesh.ts';

/** A mesh, and what joints and weights make of it. */
export type Formed = Pick<Body, 'mesh' | 'form'>;

type Glow = Pick<MeshGlow, 'bits' | 'texture'>;

/** A run of triangles. */
interface Cluster {
  /** In the space of the mesh, of what is not dark. */
  readonly bounds: Bounds;
  /** The triangles' normals times their areas and brightness, summed up, in the space of the mesh. */
  readonly normal: Vec3;
  /** Areas times brightness, where a placement like that of the table, but without scale, puts the triangles. */
  readonly weights: Float64Array;
  /** Their sum, and that of the areas. */
  readonly weight: number;
  readonly area: number;
  /** There too: cosine of the cone about the sum of the normals that holds them all. */
  readonly cosWidth: number;
}
export interface LampTable {
  /** One row a triangle. */
  readonly words: Uint32Array<ArrayBuffer>;
  readonly clusters: readonly Cluster[];
}

const ROW = geometryRows('LampTriangle') * GEOMETRY_ROW;
const word = (field: 'own' | 'place' | 'other' | 'density') => fieldOffset('LampTriangle', field) / 4;
const [OWN, PLACE, OTHER, DENSITY] = [word('own'), word('place'), word('other'), word('density')];

/** Of one form of a mesh, by how its placement stretches it. So many are kept, as a lamp that moves may have another one each time. */
interface KnownTables {
  readonly revision: number;
  readonly byStretch: Map<string, LampTable>;
}
const MOST_KEPT = 256;
/** By the brightness of the triangles, or the mesh itself where they are all alike. */
const known = new WeakMap<PackedMesh, WeakMap<object, KnownTables>>();

/** The factor by which a placement scales lengths, on average. */
const scaleOf = (placement: Numbers): number => Math.cbrt(Math.abs(determinant(placement)));

/** What a placement does to lengths and angles, but for its scale: the same for all that turn it, and mirror it. */
function stretchOf(m: Numbers): string {
  const column = (c: number): Vec3 => [m[c]!, m[4 + c]!, m[8 + c]!];
  const [x, y, z] = [column(0), column(1), column(2)];
  const square = scaleOf(m) ** 2;
  const products = [dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(y, z), dot(z, x)];
  return products.map((product) => Math.round((product / square) * 1e5)).join(' ');
}

/** `placement`: where the mesh stands. */
export function lampTable(body: Formed, packed: PackedMesh, placement: Numbers, glow: Glow): LampTable {
  const { revision } = packed;
  const { bits, texture } = glow;
  const brightness = texture ? brightnessOf(body.mesh, texture) : null;
  let ofMesh = known.get(packed);
  if (!ofMesh) known.set(packed, (ofMesh = new WeakMap()));
  let tables = ofMesh.get(brightness ?? packed);
  if (tables?.revision !== revision) ofMesh.set(brightness ?? packed, (tables = { revision, byStretch: new Map() }));
  const { byStretch } = tables;
  const key = `${bits}: ${stretchOf(placement)}`;
  let table = byStretch.get(key);
  if (!table && byStretch.size >= MOST_KEPT) byStretch.clear();
  if (!table) byStretch.set(key, (table = makeTable(body, packed, placement, bits, brightness)));
  return table;
}

function makeTable(
  body: Formed,
  { order }: PackedMesh,
  placement: Numbers,
  bits: number,
  brightness: Float64Array | null,
): LampTable {
  const words = new Uint32Array(order.length * ROW);
  const floats = new Float32Array(words.buffer);
  const clusters: Cluster[] = [];
  for (let first = 0; first < order.length; first += 2 ** bits) {
    const triangles = order.subarray(first, first + 2 ** bits);
    const cluster = measure(body, triangles, placement, brightness);
    clusters.push(cluster);
    const { weights, weight, area } = cluster;
    const { length } = weights;
    const { own, other } =
      weight > 0 ? aliasTable(weights) : { own: new Float64Array(length).fill(1), other: new Uint32Array(length) };
    for (let k = 0; k < length; k++) {
      const at = (first + k) * ROW;
      floats[at + OWN] = own[k]!;
      words[at + PLACE] = first + k;
      words[at + OTHER] = first + other[k]!;
      floats[at + DENSITY] = brightness && weight > 0 ? (brightness[triangles[k]!]! * area) / weight : 1;
    }
  }
  return { words, clusters };
}

function measure(
  { mesh, form }: Formed,
  triangles: Uint32Array,
  placement: Numbers,
  brightness: Float64Array | null,
): Cluster {
  const { indices } = mesh;
  const { positions } = form ?? mesh;
  const vertex = (corner: number): Vec3 => {
    const at = 3 * indices[corner]!;
    return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
  };
  const s = 1 / scaleOf(placement);
  const even = Float64Array.from(placement, (x) => x * s);
  const weights = new Float64Array(triangles.length);
  const placed: Vec3[] = [];
  const min: [number, number, number] = [Infinity, Infinity, Infinity];
  const max: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  let [area, weight, normal, sum] = [0, 0, [0, 0, 0] as Vec3, [0, 0, 0] as Vec3];
  for (let k = 0; k < triangles.length; k++) {
    const [a, b, c] = [vertex(3 * triangles[k]!), vertex(3 * triangles[k]! + 1), vertex(3 * triangles[k]! + 2)];
    const [u, v] = [subtract(b, a), subtract(c, a)];
    const bright = brightness ? brightness[triangles[k]!]! : 1;
    const across = scale(cross(transformDirection(even, 0, u), transformDirection(even, 0, v)), 0.5);
    area += length(across);
    weights[k] = bright * length(across);
    weight += weights[k]!;
    placed.push(scale(across, bright));
    sum = addScaled(sum, across, bright);
    normal = addScaled(normal, cross(u, v), 0.5 * bright);
    if (bright === 0) continue;
    for (let axis = 0; axis < 3; axis++) {
      min[axis] = Math.min(min[axis]!, a[axis]!, b[axis]!, c[axis]!);
      max[axis] = Math.max(max[axis]!, a[axis]!, b[axis]!, c[axis]!);
    }
  }
  const bounds = weight > 0 ? { min, max } : { min: ORIGIN, max: ORIGIN };
  return { bounds, normal, weights, weight, area, cosWidth: cosineAbout(sum, placed, weights) };
}

const ORIGIN: Vec3 = [0, 0, 0];

/** Of the cone about the sum of some vectors that holds them all; −1 where they cancel out. */
function cosineAbout(sum: Vec3, vectors: readonly Vec3[], lengths: Float64Array): number {
  const size = length(sum);
  let [least, total] = [1, 0];
  vectors.forEach((vector, k) => {
    total += lengths[k]!;
    if (lengths[k]! > 0) least = Math.min(least, dot(vector, sum) / (lengths[k]! * size));
  });
  return size > 1e-6 * total ? Math.max(least, -1) : -1;
}

/** Where the tables and rows of one instance's emitters are. */
export interface LampPlace {
  /** Its number. */
  readonly instance: number;
  /** Row of its table among all tables. */
  readonly table: number;
  /** Of the scene table. */
  readonly row: number;
}

/** The emitters of one instance, one for each cluster. */
export function meshEmitters(
  glow: MeshGlow,
  { clusters }: LampTable,
  placement: Numbers,
  { instance, table, row }: LampPlace,
): EmitterValues[] {
  const { radiance, bits, oneSided, texture, mayBeMissing } = glow;
  const mean = (radiance[0] + radiance[1] + radiance[2]) / 3;
  const square = scaleOf(placement) ** 2;
  // What takes vectors of areas into the world. The front stays the front in a mirror.
  const side = Math.sign(determinant(placement));
  const [a, b, c, d, e, f, g, h, i] = cofactors(placement, 0).map((x) => x * side) as [number, number, number, number, number, number, number, number, number]; // biome-ignore format: a matrix
  const toWorld = [a, b, c, 0, d, e, f, 0, g, h, i, 0];
  let first = table;
  return clusters.map(({ bounds, normal, weights, weight, area: evenArea, cosWidth }) => {
    const { min, max } = placedBounds(bounds, placement);
    // As large as it would be if it were white.
    const lit = weight * square;
    const across = transformDirection(toWorld, 0, normal);
    const values: EmitterValues = {
      ...NO_EMITTER,
      kind: EMITTER_KIND.mesh,
      position: scale(add(min, max), 0.5),
      u: [cosWidth, texture || mayBeMissing ? 1 : 0, 0],
      radius: bits,
      v: lit > 0 ? scale(across, 1 / Math.max(lit, length(across))) : [0, 0, 0],
      cosInner: clusters.length,
      radiance,
      area: evenArea * square,
      shape: row,
      oneSided: oneSided ? 1 : 0,
      power: mean * lit,
      reach: length(subtract(max, min)) / 2,
      table: first,
      triangles: weights.length,
      instance,
    };
    first += weights.length;
    return values;
  });
}
