/** A closed mesh of any size, and rays in it: from an eye, and from where those end into all directions. */
import type { TriangleMesh } from '../../../packages/renderer/src/bvh/bvh.ts';
import type { Vec3 } from '../../../packages/renderer/src/scene/scene.ts';
import { add, cross, dot, normalize, scale, subtract } from '../../../packages/renderer/src/scene/vec3.ts';
import { bumpySphere, joined } from '../../../tests/fixtures/meshes.ts';
import { type Random, seededRandom } from '../../../tests/fixtures/random.ts';
import type { Hits } from './race.ts';

const [WIDTH, HEIGHT] = [2048, 1024];
export const RAYS = WIDTH * HEIGHT;
/** Neighbouring threads have neighbouring rays: tiles of 8 × 8 along Morton's curve. */
const TILE = 8;

/**
 * Between a bumpy cave, 80 m across, and a bumpy ball of 20 m in its middle, of half the triangles each. Other tracers leave out triangles
 * that are small in metres, so these are large.
 */
export function cave(triangles: number): TriangleMesh {
  const rows = Math.round(Math.sqrt(triangles / 8));
  const sphere = (seed: number, radius: number) => {
    const { positions, indices } = bumpySphere(seededRandom(seed), rows);
    return { positions: positions.map((x) => x * radius), indices };
  };
  return joined(sphere(1, 40), sphere(2, 10));
}

const EYE: Vec3 = [3, 9, 24];

function put(rays: Float32Array, i: number, origin: Vec3, direction: Vec3): void {
  rays.set(origin, 8 * i);
  rays.set(direction, 8 * i + 4);
}

/** Through every pixel of a picture. */
export function primaryRays(): Float32Array<ArrayBuffer> {
  const rays = new Float32Array(8 * RAYS);
  const odd = (m: number) => (m & 1) | ((m >> 1) & 2) | ((m >> 2) & 4);
  for (let i = 0; i < RAYS; i++) {
    const [tile, within] = [Math.floor(i / TILE ** 2), i % TILE ** 2];
    const x = (tile % (WIDTH / TILE)) * TILE + odd(within);
    const y = Math.floor(tile / (WIDTH / TILE)) * TILE + odd(within >> 1);
    const direction: Vec3 = [(2 * x) / WIDTH - 1.1, 0.25 - y / HEIGHT, -0.8];
    put(rays, i, EYE, normalize(direction));
  }
  return rays;
}

function cosineAbout(normal: Vec3, random: Random): Vec3 {
  const z = 2 * random() - 1;
  const [phi, ring] = [2 * Math.PI * random(), Math.sqrt(1 - z * z)];
  return normalize(add(normal, scale([ring * Math.cos(phi), ring * Math.sin(phi), z], 0.9999)));
}

/** As a matte surface sends light back from each hit. `order`: which triangle stands at a hit's place. */
export function diffuseRays(
  from: Float32Array,
  hits: Hits,
  { positions, indices }: TriangleMesh,
  order: Uint32Array,
): Float32Array<ArrayBuffer> {
  const random = seededRandom(5);
  const places = new Uint32Array(hits.buffer);
  const rays = new Float32Array(8 * RAYS);
  const vector = (array: Float32Array, at: number): Vec3 => [array[at]!, array[at + 1]!, array[at + 2]!];
  for (let i = 0; i < RAYS; i++) {
    const direction = vector(from, 8 * i + 4);
    const point = add(vector(from, 8 * i), scale(direction, hits[2 * i]!));
    const triangle = 3 * order[places[2 * i + 1]!]!;
    const [a, b, c] = [0, 1, 2].map((k) => vector(positions, 3 * indices[triangle + k]!)) as [Vec3, Vec3, Vec3];
    const normal = normalize(cross(subtract(b, a), subtract(c, a)));
    const outward = scale(normal, dot(normal, direction) > 0 ? -1 : 1);
    put(rays, i, add(point, scale(outward, 0.01)), cosineAbout(outward, random));
  }
  return rays;
}
