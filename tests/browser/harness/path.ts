/** Films of the path integrator: the one place where tests and `npm run proof` meet it. */

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

/** Linear RGB triples, row 0 on top: over the samples of each pixel the sums of radiance and of its square; and samples a pixel. */
export interface PathFilm {
  readonly sum: Float32Array;
  readonly sumOfSquares: Float32Array;
  readonly count: Float32Array;
}

export async function renderPath(backend: GpuBackend, scene: Scene, range: PathRange): Promise<PathFilm> {
  const { width, height, samples, firstSample, seed } = range;
  const tracer = await tracerBy(backend === 'webgpu' ? 'webgpu, computed' : 'webgl2');
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

export async function pathFilm(backend: GpuBackend, scene: Scene, range: PathRange): Promise<EncodedFilm> {
  const { sum, sumOfSquares, count } = await renderPath(backend, scene, range);
  return { sum: encode(sum), sumOfSquares: encode(sumOfSquares), count: encode(count) };
}

function encode(floats: Float32Array): string {
  const bytes = new Uint8Array(floats.buffer);
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}
