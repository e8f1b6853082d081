/** Films from the browser, and pictures of what came of them. */
import type { Page } from '@playwright/test';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import type { Film } from '../reference/blocks.ts';
import type {} from './harness/harness.ts';
import type { GpuBackend } from './harness/parity.ts';
import type { EncodedFilm, PathRange } from './harness/path.ts';

const decode = (base64: string): Float32Array =>
  new Float32Array(Uint8Array.from(Buffer.from(base64, 'base64')).buffer);

const decodeFilm = (film: EncodedFilm, { width, height }: PathRange): Film => ({
  width,
  height,
  sum: decode(film.sum),
  sumOfSquares: decode(film.sumOfSquares),
  count: decode(film.count),
});

/** Some samples of a scene by the path integrator. The page must be the harness. */
export async function pathFilm(page: Page, backend: GpuBackend, scene: Scene, range: PathRange): Promise<Film> {
  const film = await page.evaluate(([b, s, r]) => window.harness.pathFilm(b, s, r), [backend, scene, range] as const);
  return decodeFilm(film, range);
}

export interface PathBatches {
  readonly width: number;
  readonly height: number;
  /** Samples a pixel in each batch. */
  readonly samples: number;
  readonly batches: number;
  /** Of the first batch; the next have the next numbers. */
  readonly seed: number;
}

/** Films with independent seeds. */
export async function pathFilms(page: Page, backend: GpuBackend, scene: Scene, settings: PathBatches): Promise<Film[]> {
  const { batches, seed, ...rest } = settings;
  const films: Film[] = [];
  for (let n = 0; n < batches; n++)
    films.push(await pathFilm(page, backend, scene, { ...rest, firstSample: 0, seed: seed + n }));
  return films;
}
