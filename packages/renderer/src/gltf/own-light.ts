/** How much light the file of a model has of its own: a car's tail lights and lamps without a surface do not let it be seen. */
import { AFFINE_LENGTH, transformDirection } from '../scene/affine.ts';
import type { Bounds } from '../scene/bounds.ts';
import { nodeTransforms, worldOf } from '../scene/node-transforms.ts';
import { placedLight } from '../scene/placed.ts';
import type { Light, Material, Scene, Vec3 } from '../scene/scene.ts';
import { boundsAt, type PosedMesh, visitMeshes } from '../scene/scene-bounds.ts';
import { add, cross, dot, length, scale, subtract } from '../scene/vec3.ts';

/** Things that send back less than this are nearly black in a picture at exposure 0. */
const LEAST = 0.02;
/** White that sends back more than this is mostly beyond what a picture shows. */
const MOST = 2;
/** Stops; a program's lights may be of any size. */
const DARKEST = -16;

/** About what white things send back in the mean by the lights and lamps of the scene, as radiance, at the time 0. */
export function ownLight(scene: Scene): number {
  const bounds = boundsAt(scene, 0);
  if (bounds === null) return Math.max(0, ...Object.values(scene.lights).map(strengthOf));
  const [middle, radius] = ballAround(bounds);
  const transforms = nodeTransforms(scene);
  const world = transforms.at(0);
  let sum = 0;
  for (const light of Object.values(scene.lights))
    sum += lightOn(placedLight(light, worldOf(transforms, world, light.node)), middle, radius);
  visitMeshes(scene, 0, (mesh) => {
    const radiance = glowOf(scene.materials[mesh.shape.material]);
    // All that a lamp sends out, π · area · radiance, over the ball around everything; white makes radiance of it by 1 / π.
    if (radiance > 0 && radius > 0) sum += (areaOf(mesh) * radiance) / (4 * Math.PI * radius * radius);
  });
  return sum;
}

export const isEnough = (light: number): boolean => light >= LEAST;

/** Stops by which a picture of things in so much light is darkened: lights of other programs may be thousands of times too strong. */
export const exposureFor = (light: number): number =>
  light > MOST ? Math.max(Math.round(-10 * Math.log2(light / MOST)) / 10, DARKEST) : 0;

function ballAround({ min, max }: Bounds): [middle: Vec3, radius: number] {
  return [scale(add(min, max), 0.5), length(subtract(max, min)) / 2];
}

/** What glows by a texture, such as a dial, is no lamp unless its strength says so. */
function glowOf(material: Material | undefined): number {
  if (material === undefined) return 0;
  const { emission, emissionStrength = 1, emissionTexture } = material;
  return emissionTexture === undefined || emissionStrength > 1 ? emissionStrength * Math.max(...emission) : 0;
}

/** Of more instances these are taken for all: what it is for needs no more. */
const MOST_EXACT_INSTANCES = 16;

/** Of all its triangles in the world. */
function areaOf(mesh: PosedMesh): number {
  const count = mesh.matrices.length / AFFINE_LENGTH;
  let sum = 0;
  for (let i = 0; i < Math.min(count, MOST_EXACT_INSTANCES); i++) sum += areaAt(mesh, i * AFFINE_LENGTH);
  return (sum * count) / Math.min(count, MOST_EXACT_INSTANCES);
}

function areaAt({ positions, indices, matrices }: PosedMesh, m: number): number {
  const edge = (a: number, b: number): Vec3 =>
    transformDirection(matrices, m, [0, 1, 2].map((k) => positions[3 * b + k]! - positions[3 * a + k]!) as unknown as Vec3); // biome-ignore format: one line
  let sum = 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
    sum += length(cross(edge(a, b), edge(a, c))) / 2;
  }
  return sum;
}

function strengthOf(light: Light): number {
  if (light.type === 'sphere' || light.type === 'quad') return light.radiance;
  return (light.type === 'directional' ? light.irradiance : light.intensity) * Math.max(...light.color);
}

/** On white that faces it, at a distance as of things all over the ball. */
function lightOn(light: Light, middle: Vec3, radius: number): number {
  if (light.type !== 'point' && light.type !== 'spot') return strengthOf(light) / Math.PI;
  const away = subtract(light.position, middle);
  const square = dot(away, away) + (radius * radius) / 3;
  return square > 0 ? strengthOf(light) / (Math.PI * square) : 0;
}
