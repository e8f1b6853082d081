/** What the display makes of a film with dim, bright and colourful light, and what it should. */
import type { RendererSettings } from 'mirrorball';
import { filmToSrgb } from '../../../packages/renderer/src/display/srgb.ts';
import { testScene } from '../../fixtures/scenes.ts';
import { type GpuBackend, gpuFilm, rendererOn } from './parity.ts';

const scene = testScene(
  { ball: { type: 'sphere', center: [0, 0, 0], radius: 0.5, material: 'white' } },
  {},
  {
    camera: { eye: [0, 0, 5], target: [0, 2, 0], up: [0, 1, 0], verticalFov: 120 },
    sky: { horizon: [0.01, 0.15, 2], zenith: [40, 5, 0.05] },
  },
);

/** Shows it on the canvas `#displayed-BACKEND`, and gives the bytes that TypeScript expects there, RGBA. */
export async function displayed(
  backend: GpuBackend,
  look: Pick<RendererSettings, 'exposure' | 'toneMapping'>,
  width: number,
  height: number,
): Promise<number[]> {
  const renderer = await rendererOn(backend);
  renderer.canvas.id = `displayed-${backend}`;
  const film = await gpuFilm(backend, scene, { width, height, time: 0, maxReflections: 0, lightSamples: 1, seed: 0 });
  renderer.set({ ...look, maxSamples: 1 });
  await renderer.render();
  return Array.from(filmToSrgb(film, look.exposure, look.toneMapping));
}
