/** The film as floats: what a program gets of what is shown. */
import { firstHitAov } from './headless/aovs.ts';
import type { ShownFilm } from './renderer-types.ts';
import type { Stages } from './stages.ts';

/** Of the newest whole picture on the device. */
export async function readShown({ film, shown }: Stages): Promise<ShownFilm> {
  const { width, height, samples } = film;
  if (!shown) return { view: 'picture', width, height, pixels: await film.read() };
  const { view, scene, camera, integrator } = shown;
  const sums = await film.readSums(2);
  const values = firstHitAov(view, sums, { ...scene, camera }, integrator);
  const channels = values.length / (width * height);
  const pixels = new Float32Array(width * height * 4);
  for (let i = 0; i < width * height; i++) {
    pixels.set(values.subarray(i * channels, (i + 1) * channels), i * 4);
    pixels[i * 4 + 3] = samples;
  }
  return { view, width, height, pixels };
}
