/** Films of the path integrator: the one place where tests and `npm run proof` meet it. */

import type { FilmTracer } from '../../../packages/renderer/src/headless/index.ts';
import type { Scene } from '../../../packages/renderer/src/scene/scene.ts';
import type { GpuBackend } from './parity.ts';
import { tracerBy } from './tracers.ts';

export interface PathRange {
  readonly width: number;
  readonly height: number;
  /** Samples a pixel, `firstSample` … `firstSample + samples − 1` of the sequence that `seed` begins. */
  readonly samples: number;
  readonly firstSample: number;
  readonly seed: number;
}

export interface PathOrder {
  readonly backend: GpuBackend;
  readonly range: PathRange;
}

/** Linear RGB triples, row 0 on top: over the samples of each pixel the sums of radiance and of its square; and samples a pixel. */
export interface PathFilm {
  readonly sum: Float32Array;
  readonly sumOfSquares: Float32Array;
  readonly count: Float32Array;
}

export const renderPath = async (backend: GpuBackend, scene: Scene, range: PathRange): Promise<PathFilm> =>
  renderBy(await tracerBy(backend === 'webgpu' ? 'webgpu, computed' : 'webgl2'), scene, range);

export async function renderBy(tracer: FilmTracer, scene: Scene, range: PathRange): Promise<PathFilm> {
  const { width, height, samples, firstSample, seed } = range;
  const { maxDepth, maxReflections, lightSamples } = scene.render;
  const settings = { integrator: 'path', maxDepth, maxReflections, lightSamples, seed } as const;
  await tracer.begin({ scene, settings, width, height, area: { x: 0, y: 0, width, height }, squares: true });
  const sums = await tracer.trace(firstSample, samples, null);
  const texels = width * height;
  const channels = (layer: number) =>
    Float32Array.from({ length: texels * 3 }, (_, i) => sums[(layer * texels + Math.floor(i / 3)) * 4 + (i % 3)]!);
  return {
    sum: channels(0),
    sumOfSquares: channels(1),
    count: Float32Array.from({ length: texels }, (_, p) => sums[p * 4 + 3]!),
  };
}

/** The bytes of each array, base64: text that `page.evaluate` returns quickly. tests/browser/films.ts reads it. */
export type EncodedFilm = Readonly<Record<keyof PathFilm, string>>;

/** Films of one scene, which crosses over to the page once for all of them, and whose meshes and map are packed once. */
export async function pathFilms(scene: Scene, orders: readonly PathOrder[]): Promise<EncodedFilm[]> {
  const films: EncodedFilm[] = [];
  for (const { backend, range } of orders) {
    const { sum, sumOfSquares, count } = await renderPath(backend, scene, range);
    films.push({ sum: encode(sum), sumOfSquares: encode(sumOfSquares), count: encode(count) });
  }
  return films;
}

function encode(floats: Float32Array): string {
  const bytes = new Uint8Array(floats.buffer);
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}
