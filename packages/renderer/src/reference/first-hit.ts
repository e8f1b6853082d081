/**
 * What the camera sees first, in double precision: docs/aov.md. Tests hold integrator/aov/ against it, and the command line's CPU
 * backend takes its AOVs from it.
 */
import type { PixelFilter } from '../packed-scene/pack-filter.ts';
import { AFFINE_LENGTH } from '../scene/affine.ts';
import { emissionOf, lampsAsShapes } from '../scene/lamps.ts';
import type { Camera, Color, Integrator, Material, Scene, Vec3 } from '../scene/scene.ts';
import { sceneSeenBy } from '../scene/seen-by.ts';
import { dot, subtract } from '../scene/vec3.ts';
import { conductorFresnel } from './bsdf/fresnel.ts';
import { mapColor } from './bsdf/surface.ts';
import { type CameraFrame, cameraFrame, rayThrough, sampleOffset } from './camera.ts';
import { closestHit, surfaceAt } from './cast.ts';
import { filterOffset } from './filter.ts';
import { rayThroughLens } from './lens.ts';
import { type PreparedScene, prepareScene } from './prepare.ts';
import type { Ray } from './ray.ts';
import { Sampler } from './sampler.ts';

export interface FirstHitSettings {
  readonly width: number;
  readonly height: number;
  readonly integrator: Integrator;
  readonly seed: number;
  /** Of the path integrator. Default: box. */
  readonly pixelFilter?: PixelFilter;
}

export interface FirstHitTracer extends FirstHitSettings {
  readonly camera: Camera;
  readonly cameraFrame: CameraFrame;
  readonly scene: PreparedScene;
  /** Of each material by its number of the shape, from 1: albedo seen from the front and from the back, and the shape's number. */
  readonly shapes: ReadonlyMap<object, ShapeFacts>;
}
interface ShapeFacts {
  readonly id: number;
  readonly front: Color;
  readonly back: Color;
}

export interface FirstHit {
  readonly albedo: Color;
  /** Towards the camera. */
  readonly normal: Vec3;
  readonly geometricNormal: Vec3;
  /** From the eye. */
  readonly place: Vec3;
  readonly id: number;
}

export function prepareFirstHit(scene: Scene, settings: FirstHitSettings): FirstHitTracer {
  const { scene: seen, lightOfShape } = lampsAsShapes(sceneSeenBy(settings.integrator, scene));
  const { camera } = scene;
  // Lights are shapes now; what is prepared is found again in the order of its kind.
  const prepared = { ...prepareScene(seen), visibleLights: [] };
  const shapes = new Map<object, ShapeFacts>();
  const kinds = {
    sphere: [...prepared.spheres],
    box: [...prepared.boxes],
    plane: [...prepared.planes],
    quad: [...prepared.quads],
    mesh: [...prepared.meshes],
  };
  Object.entries(seen.shapes).forEach(([name, shape], index) => {
    const material = seen.materials[shape.material]!;
    const oneSided = shape.type === 'quad' && lightOfShape.has(name);
    const front = albedoOf(material);
    const back = oneSided ? albedoOf(material, [0, 0, 0]) : front;
    // A mesh stands there once for each of its instances.
    const count = shape.type === 'mesh' && shape.instances ? shape.instances.length / AFFINE_LENGTH : 1;
    for (const one of kinds[shape.type].splice(0, count)) shapes.set(one, { id: index + 1, front, back });
  });
  const frame = cameraFrame(camera, settings.width, settings.height);
  return { ...settings, camera, cameraFrame: frame, scene: prepared, shapes };
}

function albedoOf(material: Material, emission = emissionOf(material)): Color {
  const { type, baseColor, conductor, reflectivity, unlit = false } = material;
  if (unlit) return baseColor;
  const { eta, k } = conductor;
  const measured = [...eta, ...k].some((x) => x > 0);
  const metal = measured ? mapColor(eta, (n, c) => conductorFresnel(1, n, k[c])) : baseColor;
  const base = type === 'dielectric' ? ([1, 1, 1] as const) : type === 'conductor' ? metal : baseColor;
  const brightest = Math.max(...emission, 1);
  return mapColor(base, (x, c) => Math.min(x + (1 - x) * reflectivity + emission[c] / brightest, 1));
}

/** The camera ray of a film sample, and where in the pixel it goes through. */
function rayOf(tracer: FirstHitTracer, i: number, j: number, sample: number): { ray: Ray; place: [number, number] } {
  const { integrator, width, height, seed, camera, cameraFrame } = tracer;
  if (integrator === 'classic') {
    const place = sampleOffset(sample);
    return { ray: rayThrough(cameraFrame, i + place[0], j + place[1], width, height), place };
  }
  const sampler = new Sampler(i, j, sample, seed);
  const [x, y] = filterOffset(tracer.pixelFilter ?? 'box', sampler.next2d());
  const lens = sampler.next2d();
  return {
    ray: rayThroughLens(camera, cameraFrame, [i + 0.5 + x, j + 0.5 + y], lens, tracer),
    place: [0.5 + x, 0.5 + y],
  };
}

/** What film sample `sample` of pixel (i, j) meets, or null; and how close to the middle of the pixel it is: 1 in it, else less. */
export function traceFirstHit(
  tracer: FirstHitTracer,
  i: number,
  j: number,
  sample: number,
): { readonly hit: FirstHit | null; readonly closeness: number } {
  const { ray, place } = rayOf(tracer, i, j, sample);
  const closeness = 1 / (1 + (place[0] - 0.5) ** 2 + (place[1] - 0.5) ** 2);
  const { t, shape, spot } = closestHit(tracer.scene, ray);
  if (shape === null) return { hit: null, closeness };
  const { point, outwardNormal, shadingNormal, baseColor, emission } = surfaceAt(shape, ray, t, spot);
  const fromBack = dot(outwardNormal, ray.direction) > 0;
  const { id, front, back } = tracer.shapes.get(shape)!;
  const hit = {
    albedo: shape.type === 'mesh' ? albedoOf({ ...shape.material, baseColor }, emission) : fromBack ? back : front,
    normal: shadingNormal,
    geometricNormal: outwardNormal,
    place: subtract(point, tracer.camera.eye),
    id,
  };
  return { hit, closeness };
}
