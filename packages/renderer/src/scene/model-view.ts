/** How a model is shown whose file says nothing of pictures: by paths, in a studio, or by a lamp in a room without windows. */
import type { Room } from './room.ts';
import type { Light, RenderSettings, Sky } from './scene.ts';
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

/**
 * Where no studio shines in, a ball of light that is not seen: white that faces it, at the mean distance of the walls, sends back radiance
 * 0.3, and the other walls add theirs. The radiance of a ball of radius r whose irradiance at the distance d is E: E d² / (π r²).
 */
export function roomLights(room: Room | null): Record<string, Light> {
  if (!room?.isDark) return {};
  const radius = 0.05 * room.reach;
  const radiance = (0.3 * room.reach ** 2) / radius ** 2;
  return { 'room lamp': { type: 'sphere', center: room.lamp, radius, radiance, ambient: [0, 0, 0], diffuse: [1, 1, 1], specular: [1, 1, 1], halo: 0, visible: false } }; // biome-ignore format: one light
}
