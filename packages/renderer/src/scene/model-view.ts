/** How a model is shown whose file says nothing of pictures: by paths, in a studio. */
import type { RenderSettings, Sky } from './scene.ts';
import { studioEnvironment } from './studio-environment.ts';

/** glTF is made for a path tracer's materials, and its viewers for this tone mapping. */
export const MODEL_RENDER: RenderSettings = {
  integrator: 'path',
  maxReflections: 5,
  lightSamples: 9,
  maxDepth: -1,
  exposure: 0,
  toneMapping: 'neutral',
};

/** The studio as a sky. Its colours are what the classic integrator sees of it. */
export const studioSky = (): Sky => ({
  horizon: [0.2, 0.2, 0.2],
  zenith: [0.34, 0.34, 0.34],
  map: studioEnvironment(),
});
