/** Films from the browser, and pictures of what came of them. */
import type { Page } from '@playwright/test';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import type { Film } from '../reference/blocks.ts';
import type {} from './harness/harness.ts';
import type { GpuBackend } from './harness/parity.ts';
import type { EncodedFilm, PathBatches } from './harness/path.ts';

const decode = (base64: string): Float32Array =>
  new Float32Array(Uint8Array.from(Buffer.from(base64, 'base64')).buffer);

const decodeFilm = (film: EncodedFilm, { width, height }: PathBatches): Film => ({
  width,
  height,
  sum: decode(film.sum),
  sumOfSquares: decode(film.sumOfSquares),
  count: decode(film.count),
});

/** Films of a scene by the path integrator, with independent seeds. The page must be the harness. */
export async function pathFilms(page: Page, backend: GpuBackend, scene: Scene, batches: PathBatches): Promise<Film[]> {
  const films = await page.evaluate(([b, s, p]) => window.harness.pathFilms(b, s, p), [
    backend,
    scene,
    batches,
  ] as const);
  return films.map((film) => decodeFilm(film, batches));
}
