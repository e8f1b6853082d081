/** Films from the browser, and pictures of what came of them. */
import type { Page } from '@playwright/test';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import type { Film } from '../reference/blocks.ts';
import type {} from './harness/harness.ts';
import type { GpuBackend } from './harness/parity.ts';
import type { EncodedFilm, PathOrder, PathRange } from './harness/path.ts';

const decode = (base64: string): Float32Array =>
  new Float32Array(Uint8Array.from(Buffer.from(base64, 'base64')).buffer);

const decodeFilm = (film: EncodedFilm, { width, height }: PathRange): Film => ({
  width,
  height,
  sum: decode(film.sum),
  sumOfSquares: decode(film.sumOfSquares),
  count: decode(film.count),
});

/** Films of a scene by the path integrator, one for each order. The page must be the harness. */
export async function filmsOf(page: Page, scene: Scene, orders: readonly PathOrder[]): Promise<Film[]> {
  const films = await page.evaluate(([s, o]) => window.harness.pathFilms(s, o), [scene, orders] as const);
  return films.map((film, i) => decodeFilm(film, orders[i]!.range));
}

/** Some samples of a scene. */
export async function pathFilm(page: Page, backend: GpuBackend, scene: Scene, range: PathRange): Promise<Film> {
  return (await filmsOf(page, scene, [{ backend, range }]))[0]!;
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
export const batchOrders = (backend: GpuBackend, { batches, seed, ...rest }: PathBatches): PathOrder[] =>
  Array.from({ length: batches }, (_, n) => ({ backend, range: { ...rest, firstSample: 0, seed: seed + n } }));

export const pathFilms = (page: Page, backend: GpuBackend, scene: Scene, settings: PathBatches): Promise<Film[]> =>
  filmsOf(page, scene, batchOrders(backend, settings));
