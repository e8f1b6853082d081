import type { Scene } from 'mirrorball';
import { meanAndError } from '../../fixtures/random.ts';
import { type GpuBackend, gpuFilm, type PictureSettings, rendererOn } from './parity.ts';

/** Mean red of all pixels of the film after so many film samples, and its standard error, for cameras that look at one point. */
export async function shadeMean(backend: GpuBackend, scene: Scene, picture: PictureSettings, filmSamples: number) {
  await gpuFilm(backend, scene, picture);
  const renderer = await rendererOn(backend);
  for (let sample = 1; sample < filmSamples; sample++) await renderer.render();
  const { pixels } = await renderer.readFilm();
  const counts = Array.from(pixels).filter((_, k) => k % 4 === 3);
  const values = Array.from(pixels).filter((_, k) => k % 4 === 0);
  return { ...meanAndError(values), leastSamples: Math.min(...counts), mostSamples: Math.max(...counts) };
}
