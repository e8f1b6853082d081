import { createRenderer, type Renderer, type Scene } from 'mirrorball';
import { traceClassic } from '../../../packages/renderer/src/reference/classic.ts';
import { sceneAt } from '../../../packages/renderer/src/scene/index.ts';
import { DEFAULT_SETTINGS } from '../../../packages/renderer/src/view.ts';
import { sceneNamed } from './scenes.ts';

export interface PictureSettings {
  readonly width: number;
  readonly height: number;
  readonly time: number;
  readonly maxReflections: number;
  readonly lightSamples: number;
  readonly seed: number;
}
export type GpuBackend = 'webgpu' | 'webgl2';

const renderers = new Map<GpuBackend, Promise<Renderer>>();
export function rendererOn(backend: GpuBackend): Promise<Renderer> {
  let renderer = renderers.get(backend);
  if (!renderer) {
    const canvas = document.createElement('canvas');
    document.body.append(canvas);
    renderers.set(backend, (renderer = createRenderer(canvas, { backend, settings: { adaptive: false } })));
  }
  return renderer;
}

/** One film sample of a scene by the renderer itself: mean radiance, RGB + sample count, row 0 first. */
export async function gpuFilm(backend: GpuBackend, scene: Scene, picture: PictureSettings): Promise<Float32Array> {
  const renderer = await rendererOn(backend);
  Object.assign(renderer.canvas, { width: picture.width, height: picture.height });
  await renderer.setScene(scene);
  const { maxReflections, lightSamples, seed, time } = picture;
  // A picture before this one may have asked for fewer samples.
  const { maxSamples } = DEFAULT_SETTINGS;
  renderer.set({ maxSamples, maxReflections, lightSamples, seed });
  renderer.time = time;
  await renderer.render();
  return (await renderer.readFilm()).pixels;
}

function cpuFilm(scene: Scene, picture: PictureSettings): Float64Array {
  return traceClassic(sceneAt(scene, picture.time), picture);
}

export interface Difference {
  /** Mean of |a − b| over all values. */
  readonly mean: number;
  /** Share of pixels in which some channel is off by more than 0.02. */
  readonly shareOff: number;
  /** Largest difference outside a band of one pixel at edges. */
  readonly largestInside: number;
  readonly finite: boolean;
}

type Film = ArrayLike<number>;

/** Whether some neighbour of the pixel differs so much from it that an edge of a shape or shadow is near. */
function isEdge(film: Film, width: number, height: number, x: number, y: number): boolean {
  const at = (y * width + x) * 4;
  for (let dy = -1; dy <= 1; dy++)
    for (let dx = -1; dx <= 1; dx++) {
      const [i, j] = [x + dx, y + dy];
      if (i < 0 || j < 0 || i >= width || j >= height) continue;
      for (let c = 0; c < 3; c++) if (Math.abs(film[(j * width + i) * 4 + c]! - film[at + c]!) > 0.05) return true;
    }
  return false;
}

export function compareFilms(a: Film, b: Film, width: number, height: number): Difference {
  let sum = 0;
  let off = 0;
  let largestInside = 0;
  let finite = true;
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++) {
      const at = (y * width + x) * 4;
      const differences = [0, 1, 2].map((c) => Math.abs(a[at + c]! - b[at + c]!));
      const largest = Math.max(...differences);
      finite &&= Number.isFinite(largest);
      sum += differences.reduce((s, d) => s + d, 0);
      if (largest > 0.02) off++;
      if (largest > largestInside && !isEdge(b, width, height, x, y)) largestInside = largest;
    }
  return { mean: sum / (width * height * 3), shareOff: off / (width * height), largestInside, finite };
}

/** The same picture by WebGPU, WebGL2 and the double-precision reference, compared. */
export async function parity(name: string, picture: PictureSettings) {
  const scene = sceneNamed(name);
  const { width, height } = picture;
  const webgpu = await gpuFilm('webgpu', scene, picture);
  const webgl2 = await gpuFilm('webgl2', scene, picture);
  const cpu = cpuFilm(scene, picture);
  return {
    backends: compareFilms(webgpu, webgl2, width, height),
    webgpu: compareFilms(webgpu, cpu, width, height),
    webgl2: compareFilms(webgl2, cpu, width, height),
  };
}

/** For looking at: the film as sRGB bytes, base64. */
export async function pictureOf(backend: GpuBackend, name: string, picture: PictureSettings): Promise<number[]> {
  return Array.from(await gpuFilm(backend, sceneNamed(name), picture));
}
