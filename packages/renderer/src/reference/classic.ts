/**
 * The classic integrator in double precision: docs/classic.md, line by line. Slow and plain on purpose. The tests hold
 * the GPU kernel against it, and where a browser has no GPU interface it draws the still picture.
 */
import type { Comparison, Framing, Panel } from '../renderer-types.ts';
import type { Camera, Color, Scene, Sky, Vec3 } from '../scene/scene.ts';
import { add, addScaled, dot, reflect, scale, subtract } from '../scene/vec3.ts';
import { type CameraFrame, cameraFrame, rayThrough, sampleOffset } from './camera.ts';
import { closestHit, type SurfaceHit, surfaceAt } from './cast.ts';
import { halo } from './halo.ts';
import { hashOfSample } from './hash.ts';
import { BLACK, type PreparedScene, prepareScene } from './prepare.ts';
import { type Ray, rayLeaving } from './ray.ts';
import { shade } from './shade.ts';

/** A path ends when less than this share of its weight is left. */
const MIN_WEIGHT = 1 / 4096;

export interface ClassicSettings {
  readonly width: number;
  readonly height: number;
  /** Default: the scene's own. */
  readonly camera?: Camera;
  /** Default: 0. */
  readonly seed?: number;
  /** Film samples firstSample … firstSample + sampleCount − 1 are averaged. Defaults: 0 and 1. */
  readonly firstSample?: number;
  readonly sampleCount?: number;
  /** Defaults: the scene's own. */
  readonly maxReflections?: number;
  readonly lightSamples?: number;
  /** Instead of the two above, where three panels are compared. */
  readonly comparison?: Comparison | null;
  /** Default: the whole picture. */
  readonly framing?: Framing | null;
}

/** Everything that tracing a pixel needs. Made by `prepareClassic`. */
export interface ClassicTracer
  extends Required<Omit<ClassicSettings, 'camera' | 'framing' | 'maxReflections' | 'lightSamples'>> {
  readonly scene: PreparedScene;
  readonly cameraFrame: CameraFrame;
  /** The settings of the whole picture where nothing is compared. */
  readonly panel: Panel;
}

export function prepareClassic(scene: Scene, settings: ClassicSettings): ClassicTracer {
  const { width, height, seed = 0, firstSample = 0, sampleCount = 1, comparison = null } = settings;
  const { maxReflections = scene.render.maxReflections, lightSamples = scene.render.lightSamples } = settings;
  return {
    width,
    height,
    seed,
    firstSample,
    sampleCount,
    comparison,
    scene: prepareScene(scene),
    cameraFrame: cameraFrame(settings.camera ?? scene.camera, width, height, settings.framing),
    panel: { maxReflections, lightSamples },
  };
}

/** The settings of pixel column i. */
export function panelAt({ comparison, panel, width }: ClassicTracer, i: number): Panel {
  if (comparison === null) return panel;
  const [first, second] = comparison.dividers;
  const index = Number(i + 0.5 >= first * width) + Number(i + 0.5 >= second * width);
  return comparison.panels[index]!;
}

const skyColor = ({ horizon, zenith }: Sky, direction: Vec3): Color =>
  addScaled(horizon, subtract(zenith, horizon), Math.max(direction[1], 0));

/** "Along the path": the radiance that comes back along a camera ray. `hash` is h of its pixel and film sample. */
export function tracePath(tracer: ClassicTracer, cameraRay: Ray, panel: Panel, hash: number): Color {
  const { scene } = tracer;
  const { eye } = cameraRay;
  let ray = cameraRay;
  let weight = 1;
  let L = BLACK;
  for (let reflection = 0; reflection <= panel.maxReflections; reflection++) {
    const { t, shape, light, spot } = closestHit(scene, ray);
    L = addScaled(L, halo(scene, ray, t), weight);
    if (light !== null) return addScaled(L, light.diffuse, weight * light.radiance);
    if (shape === null) return addScaled(L, skyColor(scene.sky, ray.direction), weight);

    const hit = surfaceAt(shape, ray, t, spot);
    const { reflectivity } = shape.material;
    if (reflectivity < 1) {
      const context = { scene, eye, lightSamples: panel.lightSamples, hash, reflection };
      L = addScaled(L, shade(context, hit, ray.direction), weight * (1 - reflectivity));
    }
    weight *= reflectivity;
    if (weight < MIN_WEIGHT) break;
    ray = rayLeaving(hit, mirrored(ray.direction, hit), eye);
  }
  return L;
}

/** A bent normal may send the mirror ray into the surface; then the true one mirrors. */
function mirrored(direction: Vec3, { shadingNormal, geometricNormal }: SurfaceHit): Vec3 {
  const bent = reflect(direction, shadingNormal);
  return dot(bent, geometricNormal) > 0 ? bent : reflect(direction, geometricNormal);
}

/** One film sample of pixel (i, j), j from the top. */
export function traceSample(tracer: ClassicTracer, i: number, j: number, sample: number): Color {
  const [a, b] = sampleOffset(sample);
  const ray = rayThrough(tracer.cameraFrame, i + a, j + b, tracer.width, tracer.height);
  return tracePath(tracer, ray, panelAt(tracer, i), hashOfSample(i, j, sample, tracer.seed));
}

/** The mean of the film samples of pixel (i, j). */
export function tracePixel(tracer: ClassicTracer, i: number, j: number): Color {
  let sum = BLACK;
  for (let s = 0; s < tracer.sampleCount; s++) sum = add(sum, traceSample(tracer, i, j, tracer.firstSample + s));
  return scale(sum, 1 / tracer.sampleCount);
}

/** The whole film: width × height × (linear red, green, blue, number of film samples), row 0 on top. */
export function traceClassic(scene: Scene, settings: ClassicSettings): Float64Array {
  const tracer = prepareClassic(scene, settings);
  const { width, height } = tracer;
  const film = new Float64Array(width * height * 4);
  for (let j = 0; j < height; j++) {
    for (let i = 0; i < width; i++) {
      film.set([...tracePixel(tracer, i, j), tracer.sampleCount], (j * width + i) * 4);
    }
  }
  return film;
}
