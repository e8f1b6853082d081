/**
 * Meshes that shine → emitters, and the tables by which kernels choose among their triangles: an alias table for each emitter, in
 * proportion to the triangles' areas in the world. A stretched instance has other areas than the mesh, and so a table of its own;
 * instances that are only moved, turned, mirrored or scaled evenly share one.
 */
import type { Mesh } from '../scene/mesh.ts';
import { placedBounds } from '../scene/mesh-bounds.ts';
import { determinant, type Placement, placeDirection } from '../scene/placement.ts';
import type { Vec3 } from '../scene/scene.ts';
import { add, addScaled, cross, dot, length, scale, subtract } from '../scene/vec3.ts';
import { aliasTable } from './alias-table.ts';
import { EMITTER_KIND, type EmitterValues, NO_EMITTER } from './emitter-values.ts';
import type { MeshGlow } from './lamp-clusters.ts';
import { fieldOffset, GEOMETRY_ROW, geometryRows } from './layout.ts';
import type { PackedMesh } from './pack-mesh.ts';

/** A run of triangles, in the space of the mesh but for the areas. */
interface Cluster {
  readonly min: Vec3;
  readonly max: Vec3;
  readonly triangles: number;
  /** In the world of a placement without scale. */
  readonly area: number;
  /** The triangles' normals times their areas, summed up. */
  readonly normal: Vec3;
  /** Cosine of the cone about their sum that holds all normals. */
  readonly cosWidth: number;
}
export interface LampTable {
  readonly words: Uint32Array<ArrayBuffer>;
  readonly clusters: readonly Cluster[];
}

const ROW = geometryRows('LampTriangle') * GEOMETRY_ROW;
const word = (field: 'own' | 'place' | 'other' | 'density') => fieldOffset('LampTriangle', field) / 4;
const [OWN, PLACE, OTHER, DENSITY] = [word('own'), word('place'), word('other'), word('density')];

/** By the mesh, and by how its placement stretches it. */
const known = new WeakMap<PackedMesh, Map<string, LampTable>>();

/** The factor by which a placement scales lengths, on average. */
const scaleOf = (placement: Placement): number => Math.cbrt(Math.abs(determinant(placement)));

/** What a placement without its scale does to lengths and angles: the same for all that turn it, and mirror it. */
function stretchOf({ x, y, z }: Placement): string {
  const products = [dot(x, x), dot(y, y), dot(z, z), dot(x, y), dot(y, z), dot(z, x)];
  return products.map((p) => (p + 0).toFixed(5).replace(/^-(0\.0+)$/, '$1')).join(' ');
}

export function lampTable(mesh: Mesh, packed: PackedMesh, placement: Placement, bits: number): LampTable {
  const s = 1 / scaleOf(placement);
  const { x, y, z, origin } = placement;
  const even: Placement = { x: scale(x, s), y: scale(y, s), z: scale(z, s), origin };
  const key = `${bits}: ${stretchOf(even)}`;
  const tables = known.get(packed) ?? new Map<string, LampTable>();
  known.set(packed, tables);
  let table = tables.get(key);
  if (!table) tables.set(key, (table = makeTable(mesh, packed, even, bits)));
  return table;
}

const vertexOf = ({ positions, indices }: Mesh, corner: number): Vec3 => {
  const at = 3 * indices[corner]!;
  return [positions[at]!, positions[at + 1]!, positions[at + 2]!];
};

function makeTable(mesh: Mesh, { order }: PackedMesh, placement: Placement, bits: number): LampTable {
  const words = new Uint32Array(order.length * ROW);
  const floats = new Float32Array(words.buffer);
  const clusters: Cluster[] = [];
  for (let first = 0; first < order.length; first += 2 ** bits) {
    const places = order.subarray(first, first + 2 ** bits);
    const cluster = measure(mesh, places, placement);
    clusters.push(cluster);
    // One that has textures would weigh a triangle's area by the mean of what it sends out, and write the quotient of that and the
    // cluster's mean for the density.
    const { own, other } =
      cluster.area > 0
        ? aliasTable(cluster.areas)
        : { own: new Float64Array(places.length).fill(1), other: Uint32Array.from(places.keys()) };
    for (let k = 0; k < places.length; k++) {
      const at = (first + k) * ROW;
      floats[at + OWN] = own[k]!;
      words[at + PLACE] = first + k;
      words[at + OTHER] = first + other[k]!;
      floats[at + DENSITY] = 1;
    }
  }
  return { words, clusters };
}

function measure(mesh: Mesh, triangles: Uint32Array, placement: Placement): Cluster & { areas: Float64Array } {
  const areas = new Float64Array(triangles.length);
  const normals: Vec3[] = [];
  let [area, normal, turned] = [0, [0, 0, 0] as Vec3, [0, 0, 0] as Vec3];
  let [min, max] = [[Infinity, Infinity, Infinity] as Vec3, [-Infinity, -Infinity, -Infinity] as Vec3];
  triangles.forEach((triangle, k) => {
    const [a, b, c] = [0, 1, 2].map((corner) => vertexOf(mesh, 3 * triangle + corner)) as [Vec3, Vec3, Vec3];
    const [u, v] = [subtract(b, a), subtract(c, a)];
    const across = scale(cross(placeDirection(placement, u), placeDirection(placement, v)), 0.5);
    areas[k] = length(across);
    area += areas[k]!;
    normals.push(across);
    turned = add(turned, across);
    normal = addScaled(normal, cross(u, v), 0.5);
    for (const p of [a, b, c]) {
      min = [Math.min(min[0], p[0]), Math.min(min[1], p[1]), Math.min(min[2], p[2])];
      max = [Math.max(max[0], p[0]), Math.max(max[1], p[1]), Math.max(max[2], p[2])];
    }
  });
  const size = length(turned);
  let cosWidth = size > 1e-6 * area ? 1 : -1;
  if (cosWidth === 1)
    for (let k = 0; k < normals.length; k++)
      if (areas[k]! > 0) cosWidth = Math.min(cosWidth, dot(normals[k]!, turned) / (areas[k]! * size));
  return { min, max, triangles: triangles.length, area, areas, normal, cosWidth };
}

/**
 * The emitters of one instance, one for each cluster. `instance`: its number; `first`: row of the table among all tables; `row`: of the
 * scene table.
 */
export function meshEmitters(
  { radiance, oneSided, bits }: MeshGlow,
  table: LampTable,
  placement: Placement,
  { instance, first, row }: { instance: number; first: number; row: number },
): EmitterValues[] {
  const { x, y, z } = placement;
  const side = Math.sign(determinant(placement));
  const scaled = scaleOf(placement) ** 2;
  const mean = (radiance[0] + radiance[1] + radiance[2]) / 3;
  let at = first;
  return table.clusters.map((cluster) => {
    const { min, max } = placedBounds(cluster, placement);
    const area = cluster.area * scaled;
    const [a, b, c] = cluster.normal;
    // Area vectors go by the cofactors; the front stays the front in a mirror.
    const across = add(add(scale(cross(y, z), a * side), scale(cross(z, x), b * side)), scale(cross(x, y), c * side));
    const values: EmitterValues = {
      ...NO_EMITTER,
      kind: EMITTER_KIND.mesh,
      position: scale(add(min, max), 0.5),
      u: [cluster.cosWidth, 0, 0],
      radius: bits,
      v: area > 0 ? scale(across, 1 / Math.max(area, length(across))) : [0, 0, 0],
      cosInner: table.clusters.length,
      radiance,
      area,
      shape: row,
      oneSided: oneSided ? 1 : 0,
      power: mean * area,
      reach: length(subtract(max, min)) / 2,
      table: at,
      triangles: cluster.triangles,
      instance,
    };
    at += cluster.triangles;
    return values;
  });
}
