/**
 * The nearest triangle along a ray, on the CPU, in the very bytes that kernels walk through (shading/mesh/traverse.wesl): the tree over the
 * instances, and below its leaves those of the meshes. Quick enough for a sketch of a scene in the blink of an eye.
 */
import { fieldOffset, GEOMETRY_ROW, geometryRows } from '../packed-scene/layout.ts';
import type { PackedGeometry } from '../packed-scene/pack-geometry.ts';
import { floatsOf, type PackedMesh, wordsOf } from '../packed-scene/packed-mesh.ts';

const NODE = geometryRows('WideNode') * GEOMETRY_ROW;
const MIN = fieldOffset('WideNode', 'minX') / 4;
const MAX = fieldOffset('WideNode', 'maxX') / 4;
const CHILDREN = fieldOffset('WideNode', 'children') / 4;
const TRIANGLE = geometryRows('Triangle') * GEOMETRY_ROW;
const [A, B, C] = (['a', 'b', 'c'] as const).map((field) => fieldOffset('Triangle', field) / 4) as [number, number, number]; // biome-ignore format: three
const INSTANCE = geometryRows('Instance') * GEOMETRY_ROW;
const TO_MESH = (['toMeshX', 'toMeshY', 'toMeshZ'] as const).map((field) => fieldOffset('Instance', field) / 4);
const NODES = fieldOffset('Instance', 'nodes') / 4;
const ROW = fieldOffset('Instance', 'row') / 4;
/** References: encode-wide-bvh.ts. */
const LEAF = 0x80000000;
const COUNT_SHIFT = 28;
const PLACE = 0x0fffffff;
const WIDTH = 4;

/** A tree, and the ray in its space. */
class Level {
  readonly stack = new Uint32Array(256);
  /** Distances and references of the children that the ray enters. */
  readonly near = new Float64Array(WIDTH);
  readonly entered = new Uint32Array(WIDTH);
  words = new Uint32Array();
  floats = new Float32Array();
  readonly origin = new Float64Array(3);
  readonly direction = new Float64Array(3);
  readonly inverse = new Float64Array(3);

  enter(words: Uint32Array<ArrayBuffer>, floats: Float32Array<ArrayBuffer>): void {
    this.words = words;
    this.floats = floats;
    for (let k = 0; k < 3; k++) this.inverse[k] = 1 / (this.direction[k] || 1e-18);
  }
}

interface MeshRows {
  readonly mesh: PackedMesh;
  readonly nodes: Float32Array<ArrayBuffer>;
  readonly triangles: Float32Array<ArrayBuffer>;
}

export class GeometryWalk {
  /** The hit, after `closest` has found one: distance, row of the scene table, mesh, place in its order, weights of corners b and c. */
  t = 0;
  row = 0;
  mesh: PackedMesh | null = null;
  place = 0;
  u = 0;
  v = 0;
  /** First word of the instance. */
  instance = 0;
  readonly #geometry: PackedGeometry;
  readonly #meshes = new Map<number, MeshRows>();
  readonly #world = new Level();
  readonly #inside = new Level();
  #current: MeshRows | null = null;
  #currentInstance = 0;
  #hit: MeshRows | null = null;

  constructor(geometry: PackedGeometry) {
    this.#geometry = geometry;
    let row = geometry.movingRows;
    for (const mesh of geometry.meshes) {
      this.#meshes.set(row, { mesh, nodes: floatsOf(mesh.nodes), triangles: floatsOf(mesh.triangles) });
      row += wordsOf(mesh).reduce((sum, { length }) => sum + length, 0) / GEOMETRY_ROW;
    }
  }

  /** Whether there is one nearer than `most`. Places are relative to the eye that the geometry was packed for. */
  closest(origin: readonly number[], direction: readonly number[], most: number): boolean {
    this.t = most;
    this.mesh = null;
    if (this.#geometry.instanceCount === 0) return false;
    const { moving } = this.#geometry;
    this.#world.origin.set(origin);
    this.#world.direction.set(direction);
    this.#world.enter(moving.u32, moving.f32);
    this.#descend(this.#world, true);
    return this.mesh !== null;
  }

  /** Of the triangle that was hit, in the space of its mesh, of any length. */
  triangleNormal(): [number, number, number] {
    const f = this.#hit!.triangles;
    const at = this.place * TRIANGLE;
    const side = (corner: number) => [0, 1, 2].map((k) => f[at + corner + k]! - f[at + A + k]!) as [number, number, number]; // biome-ignore format: short
    const [[ux, uy, uz], [vx, vy, vz]] = [side(B), side(C)];
    return [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  }

  /** A normal of the mesh that was hit, in the world, of any length: by the transpose of what leads into the mesh. */
  toWorld([x, y, z]: readonly [number, number, number]): [number, number, number] {
    const f = this.#geometry.moving.f32;
    const along = (axis: number) =>
      f[this.instance + TO_MESH[0]! + axis]! * x + f[this.instance + TO_MESH[1]! + axis]! * y + f[this.instance + TO_MESH[2]! + axis]! * z; // biome-ignore format: one sum
    return [along(0), along(1), along(2)];
  }

  #descend(level: Level, isTop: boolean): void {
    const { stack, near, entered } = level;
    let top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const count = this.#enterChildren(level, stack[--top]! * NODE);
      // Leaves at once, nearest first; the rest onto the stack, farthest first.
      for (let k = 0; k < count; k++) if (entered[k]! >= LEAF && near[k]! < this.t) this.#leaf(entered[k]!, isTop);
      for (let k = count - 1; k >= 0; k--) if (entered[k]! < LEAF && near[k]! < this.t) stack[top++] = entered[k]!;
    }
  }

  /** Sorts the children that the ray enters by distance; gives how many there are. */
  #enterChildren({ words, floats, origin, inverse, near: distances, entered }: Level, at: number): number {
    let count = 0;
    for (let k = 0; k < WIDTH; k++) {
      const reference = words[at + CHILDREN + k]!;
      if (reference === 0) continue;
      let [near, far] = [0, this.t];
      for (let axis = 0; axis < 3; axis++) {
        const scale = inverse[axis]!;
        const a = (floats[at + MIN + axis * WIDTH + k]! - origin[axis]!) * scale;
        const b = (floats[at + MAX + axis * WIDTH + k]! - origin[axis]!) * scale;
        near = Math.max(near, Math.min(a, b));
        far = Math.min(far, Math.max(a, b));
      }
      if (!(near <= far * (1 + 1e-6))) continue;
      let place = count++;
      for (; place > 0 && distances[place - 1]! > near; place--) {
        distances[place] = distances[place - 1]!;
        entered[place] = entered[place - 1]!;
      }
      distances[place] = near;
      entered[place] = reference;
    }
    return count;
  }

  /** A leaf of the upper tree is one instance, and has the number 0. */
  #leaf(reference: number, isTop: boolean): void {
    const first = reference & PLACE;
    if (isTop) this.#enterInstance(first);
    const end = first + ((reference >>> COUNT_SHIFT) & 7);
    for (let place = first; place < end; place++) this.#tryTriangle(place);
  }

  #enterInstance(index: number): void {
    const { moving, instances } = this.#geometry;
    const at = instances * GEOMETRY_ROW + index * INSTANCE;
    const [world, inside] = [this.#world, this.#inside];
    for (let axis = 0; axis < 3; axis++) {
      const row = at + TO_MESH[axis]!;
      const [x, y, z] = [moving.f32[row]!, moving.f32[row + 1]!, moving.f32[row + 2]!];
      inside.origin[axis] = x * world.origin[0]! + y * world.origin[1]! + z * world.origin[2]! + moving.f32[row + 3]!;
      inside.direction[axis] = x * world.direction[0]! + y * world.direction[1]! + z * world.direction[2]!;
    }
    const mesh = this.#meshes.get(moving.u32[at + NODES]!)!;
    this.#current = mesh;
    this.#currentInstance = at;
    inside.enter(mesh.mesh.nodes, mesh.nodes);
    this.#descend(inside, false);
  }

  /** Möller and Trumbore (1997). */
  #tryTriangle(place: number): void {
    const f = this.#current!.triangles;
    const { origin: o, direction: d } = this.#inside;
    const at = place * TRIANGLE;
    const [ax, ay, az] = [f[at + A]!, f[at + A + 1]!, f[at + A + 2]!];
    const [ux, uy, uz] = [f[at + B]! - ax, f[at + B + 1]! - ay, f[at + B + 2]! - az];
    const [vx, vy, vz] = [f[at + C]! - ax, f[at + C + 1]! - ay, f[at + C + 2]! - az];
    const [px, py, pz] = [d[1]! * vz - d[2]! * vy, d[2]! * vx - d[0]! * vz, d[0]! * vy - d[1]! * vx];
    const inverse = 1 / (ux * px + uy * py + uz * pz);
    const [sx, sy, sz] = [o[0]! - ax, o[1]! - ay, o[2]! - az];
    const u = (sx * px + sy * py + sz * pz) * inverse;
    if (!(u >= 0 && u <= 1)) return;
    const [qx, qy, qz] = [sy * uz - sz * uy, sz * ux - sx * uz, sx * uy - sy * ux];
    const v = (d[0]! * qx + d[1]! * qy + d[2]! * qz) * inverse;
    const t = (vx * qx + vy * qy + vz * qz) * inverse;
    if (!(v >= 0 && u + v <= 1 && t > 0 && t < this.t)) return;
    this.t = t;
    this.u = u;
    this.v = v;
    this.place = place;
    this.mesh = this.#current!.mesh;
    this.#hit = this.#current;
    this.instance = this.#currentInstance;
    this.row = this.#geometry.moving.u32[this.#currentInstance + ROW]!;
  }
}
