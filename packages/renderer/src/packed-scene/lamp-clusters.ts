/**
 * Into how many emitters a glowing mesh is cut. Each is a run of triangles in the order of the mesh's tree, as long as a power of two, so
 * that a triangle's number says which emitter it belongs to. Runs lie together, so the choice among them knows what is near.
 */
import { AFFINE_LENGTH } from '../scene/affine.ts';
import { meshBounds } from '../scene/bounds.ts';
import { emissionOf } from '../scene/lamps.ts';
import { hasCoat } from '../scene/layered.ts';
import { type Mesh, triangleCount } from '../scene/mesh.ts';
import type { Color, Material, MeshShape, Scene } from '../scene/scene.ts';
import type { ImagePixels } from '../scene/textures.ts';
import { length, subtract } from '../scene/vec3.ts';
import type { GlowTexture } from './lamp-brightness.ts';

/** Runs are no shorter than 2^this. */
const LEAST_BITS = 3;
/** Emitters of one instance at most; and of one shape, as long as each instance is one. */
const MOST_OF_INSTANCE = 256;
const MOST_OF_SHAPE = 1024;
/**
 * A mesh whose area is a larger share than this of that of the sphere about it is one lamp, and one emitter: a tube ten times as long as
 * it is wide has a tenth. Cutting a compact lamp costs more time than it saves noise.
 */
const SPARSE = 0.05;

export interface LampClusters {
  readonly instances: number;
  /** Emitters of one instance. */
  readonly clusters: number;
  /** Each has 2^bits triangles, the last one maybe fewer. */
  readonly bits: number;
  /** Of the mesh. */
  readonly triangles: number;
}

/** What a mesh is as a lamp. */
export interface MeshGlow extends LampClusters {
  readonly radiance: Color;
  /** Only the front of its triangles shines. */
  readonly oneSided: boolean;
  /** What its emission is multiplied by. */
  readonly texture: GlowTexture | null;
  /** It may have holes, or be there by chance. */
  readonly mayBeMissing: boolean;
}

export function cutLamp(triangles: number, instances: number, sparse: boolean): LampClusters {
  const room = Math.min(Math.max(Math.floor(MOST_OF_SHAPE / Math.max(instances, 1)), 1), MOST_OF_INSTANCE);
  const most = sparse ? room : 1;
  let bits = LEAST_BITS;
  while (Math.ceil(triangles / 2 ** bits) > most) bits++;
  return { instances, clusters: Math.ceil(triangles / 2 ** bits), bits, triangles };
}

/** A mesh does not change. */
const known = new WeakMap<Mesh, boolean>();

/** Whether its triangles are scattered, or in a line. */
export function isSparse(mesh: Mesh): boolean {
  let sparse = known.get(mesh);
  if (sparse === undefined) {
    const { min, max } = meshBounds(mesh);
    sparse = areaOf(mesh) < SPARSE * Math.PI * length(subtract(max, min)) ** 2;
    known.set(mesh, sparse);
  }
  return sparse;
}

function areaOf({ positions: p, indices }: Mesh): number {
  let area = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * indices[k]!, 3 * indices[k + 1]!, 3 * indices[k + 2]!];
    const [ux, uy, uz] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!, p[b + 2]! - p[a + 2]!];
    const [vx, vy, vz] = [p[c]! - p[a]!, p[c + 1]! - p[a + 1]!, p[c + 2]! - p[a + 2]!];
    area += Math.sqrt((uy * vz - uz * vy) ** 2 + (uz * vx - ux * vz) ** 2 + (ux * vy - uy * vx) ** 2) / 2;
  }
  return area;
}

/** Of the texture that varies a material's emission; null without one. */
export function glowTextureOf({ textures, images }: Scene, { emissionTexture: use }: Material): GlowTexture | null {
  if (!use) return null;
  const { image, wrapU = 'repeat', wrapV = 'repeat' } = textures![use.texture]!;
  const pixels = images?.[image]?.data;
  return pixels ? { pixels, use, wrapU, wrapV } : null;
}

const blackImages = new WeakMap<ImagePixels, boolean>();

function isBlack(pixels: ImagePixels): boolean {
  let black = blackImages.get(pixels);
  if (black === undefined) {
    const { rgba } = pixels;
    black = true;
    for (let at = 0; at < rgba.length && black; at++) black = at % 4 === 3 || rgba[at] === 0;
    blackImages.set(pixels, black);
  }
  return black;
}

/**
 * How a mesh is cut whose light is sampled; null for others. What shines through a coat, and unlit surfaces, whose light is meant for the eye,
 * are found by rays that happen to meet them.
 */
export function clustersOf(scene: Scene, shape: MeshShape): LampClusters | null {
  const { materials, meshes = {} } = scene;
  const mesh = meshes[shape.mesh]?.data;
  const material = materials[shape.material]!;
  if (!mesh || Math.max(...emissionOf(material)) <= 0) return null;
  if (material.unlit || hasCoat(material)) return null;
  const texture = glowTextureOf(scene, material);
  if (material.emissionTexture && (!texture || isBlack(texture.pixels))) return null;
  const instances = shape.instances ? shape.instances.length / AFFINE_LENGTH : 1;
  return cutLamp(triangleCount(mesh), instances, isSparse(mesh));
}
