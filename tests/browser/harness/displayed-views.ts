/** What the canvas shows of each view, and the colours that it should have by the double-precision tracer. */
import type { ViewName } from 'mirrorball';
import { addReferenceSample, type FilmJob, type FilmSums, firstHitAov, referenceRows } from 'mirrorball/headless';
import { colorOfName } from '../../../packages/renderer/src/display/number-colors.ts';
import { linearToSrgb } from '../../../packages/renderer/src/display/srgb.ts';
import { aovIds } from '../../../packages/renderer/src/integrator/aov/aov-ids.ts';
import type { Scene } from '../../../packages/renderer/src/scene/scene.ts';
import { aovScene } from '../../fixtures/aov-scene.ts';
import { type GpuBackend, rendererOn } from './parity.ts';

type AovView = Exclude<ViewName, 'picture'>;
// The first sample of the classic integrator lies in the middle of each pixel.
const scene: Scene = aovScene;
const integrator = 'classic';

function film(content: 'features' | 'data', width: number, height: number): FilmSums {
  const settings = { integrator, maxDepth: -1, maxReflections: 0, lightSamples: 1, seed: 0 } as const;
  const area = { x: 0, y: 0, width, height };
  const job: FilmJob = { scene, settings, width, height, area, content };
  const sums = new Float32Array(width * height * 8);
  addReferenceSample(sums, referenceRows(job)(0, 0, height), job);
  return sums;
}

/** Red, green, blue of one pixel, 0 … 1, out of the AOV's values there. */
function colorOf(view: AovView, values: ArrayLike<number>, id: number): readonly number[] {
  const { primitives, materials, materialOf } = aovIds(scene, integrator);
  const { eye, target } = scene.camera;
  const scale = Math.hypot(...target.map((x, c) => x - eye[c]!));
  const numbers = Array.from(values);
  switch (view) {
    case 'albedo':
      return numbers.map(linearToSrgb);
    case 'normal':
    case 'geometric-normal':
      return numbers.map((x) => (id === 0 ? 0 : 0.5 + 0.5 * x));
    case 'depth':
      return new Array(3).fill(id === 0 ? 0 : scale / (scale + numbers[0]!));
    case 'position':
      return numbers.map((x, c) => {
        const p = (x - target[c]!) / scale;
        return id === 0 ? 0 : 0.5 + (0.5 * p) / (1 + Math.abs(p));
      });
    case 'primitive-id':
      return id === 0 ? [0, 0, 0] : colorOfName(primitives[id]!);
    case 'material-id':
      return id === 0 ? [0, 0, 0] : colorOfName(materials[materialOf[id]!]!);
  }
}

/** Shows the view on the canvas `#view-BACKEND`, and gives the bytes that are expected there, RGB. */
export async function displayedView(backend: GpuBackend, view: AovView, width: number, height: number) {
  const renderer = await rendererOn(backend);
  Object.assign(renderer.canvas, { id: `view-${backend}`, width, height });
  await renderer.setScene(scene);
  renderer.set({ view, integrator, maxSamples: 1 });
  await renderer.render();
  const shown = await renderer.readFilm();
  // Nobody has drawn it: it is drawn when it is read.
  renderer.set({ view: 'picture' });
  const picture = await renderer.readFilm();
  renderer.set({ view });
  await renderer.render();
  renderer.set({ view: 'picture' });
  const [features, data] = [film('features', width, height), film('data', width, height)];
  const ids = firstHitAov('primitive-id', data, scene, integrator);
  const source = view === 'albedo' || view === 'normal' ? features : data;
  const values = firstHitAov(view, source, scene, integrator);
  const count = values.length / ids.length;
  const film4 = Float32Array.from({ length: 4 * ids.length }, (_, i) =>
    i % 4 === 3 ? 1 : i % 4 < count ? values[Math.floor(i / 4) * count + (i % 4)]! : 0,
  );
  const bytes = Array.from(ids).flatMap((id, pixel) =>
    colorOf(view, values.subarray(pixel * count, (pixel + 1) * count), id).map((x) => Math.round(255 * x)),
  );
  const off = film4.filter((value, i) => Math.abs(value - shown.pixels[i]!) > 1e-4 * Math.max(Math.abs(value), 1));
  return {
    bytes,
    film: { view: shown.view, length: shown.pixels.length, off: off.length },
    picture: { view: picture.view, brightest: Math.max(...picture.pixels.filter((_, i) => i % 4 < 3)) },
  };
}
