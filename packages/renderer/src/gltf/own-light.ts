/** Whether a model can be seen by the light of its own file. A car's tail lights and lamps without a surface are no lighting. */
import { AFFINE_LENGTH, transformDirection } from '../scene/affine.ts';
import type { Bounds } from '../scene/bounds.ts';
import { nodeTransforms, worldOf } from '../scene/node-transforms.ts';
import { placedLight } from '../scene/placed.ts';
import type { Light, Material, Scene, Vec3 } from '../scene/scene.ts';
import { boundsAt, type PosedMesh, visitMeshes } from '../scene/scene-bounds.ts';
import { add, cross, length, scale, subtract } from '../scene/vec3.ts';

/** What white things would send back in the mean, as radiance: with less they are nearly black in a picture at exposure 0. */
const LEAST = 0.02;

/** As the file's things lie at the time 0. Estimates err towards light: what is dark on purpose stays as it is. */
export function hasLight(scene: Scene): boolean {
  const bounds = boundsAt(scene, 0);
  if (bounds === null) return Object.values(scene.lights).some((light) => strengthOf(light) > 0);
  const [middle, radius] = ballAround(bounds);
  const transforms = nodeTransforms(scene);
  const world = transforms.at(0);
  let sum = 0;
  for (const light of Object.values(scene.lights))
    sum += lightOn(placedLight(light, worldOf(transforms, world, light.node)), middle, radius);
  // All that lamps send out, π · area · radiance, over the ball around everything; white makes radiance of it by 1 / π.
  const perArea = 1 / (4 * Math.PI * radius * radius);
  visitMeshes(scene, 0, (mesh) => {
    const radiance = glowOf(scene.materials[mesh.shape.material]);
    if (radiance > 0 && sum < LEAST) sum += areaOf(mesh, LEAST / (radiance * perArea)) * radiance * perArea;
  });
  return sum >= LEAST;
}

function ballAround({ min, max }: Bounds): [middle: Vec3, radius: number] {
  return [scale(add(min, max), 0.5), length(subtract(max, min)) / 2];
}

/** What glows by a texture, such as a dial, is no lamp unless its strength says so. */
function glowOf(material: Material | undefined): number {
  if (material === undefined) return 0;
  const { emission, emissionStrength = 1, emissionTexture } = material;
  return emissionTexture === undefined || emissionStrength > 1 ? emissionStrength * Math.max(...emission) : 0;
}

/** Of all its triangles in the world; not counted beyond `enough`. */
function areaOf({ positions, indices, matrices }: PosedMesh, enough: number): number {
  let sum = 0;
  const edge = (m: number, a: number, b: number): Vec3 =>
    transformDirection(matrices, m, [0, 1, 2].map((k) => positions[3 * b + k]! - positions[3 * a + k]!) as unknown as Vec3); // biome-ignore format: one line
  for (let m = 0; m < matrices.length; m += AFFINE_LENGTH)
    for (let i = 0; i < indices.length && sum < enough; i += 3) {
      const [a, b, c] = [indices[i]!, indices[i + 1]!, indices[i + 2]!];
      sum += length(cross(edge(m, a, b), edge(m, a, c))) / 2;
    }
  return sum;
}

function strengthOf(light: Light): number {
  if (light.type === 'sphere' || light.type === 'quad') return light.radiance;
  return (light.type === 'directional' ? light.irradiance : light.intensity) * Math.max(...light.color);
}

/** On white that faces it: where it is nearest to the ball of things, or half of the radius away where it lies among them. */
function lightOn(light: Light, middle: Vec3, radius: number): number {
  if (light.type !== 'point' && light.type !== 'spot') return strengthOf(light) / Math.PI;
  const distance = Math.max(length(subtract(light.position, middle)) - radius, radius / 2);
  return strengthOf(light) / (Math.PI * distance * distance);
}
