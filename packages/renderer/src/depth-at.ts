/** What lies under a point of the picture, by the double-precision tracer: for focusing by a click. */
import { cameraFrame, rayThrough } from './reference/camera.ts';
import { closestHit } from './reference/cast.ts';
import { prepareScene } from './reference/prepare.ts';
import type { Renderer } from './renderer-types.ts';
import { cameraAxes } from './scene/camera.ts';
import { lampsAsShapes } from './scene/lamps.ts';
import { posedSceneAt } from './scene/posed.ts';
import { sceneSeenBy } from './scene/seen-by.ts';
import { addScaled, dot, subtract } from './scene/vec3.ts';

/**
 * How far away that is which `renderer` shows at (x, y), in shares of the canvas's width and height from the top left: metres along the
 * line of sight, as `Camera.focusDistance` counts them (of an equirectangular camera, from the eye). Null where there is nothing.
 */
export function depthAt(
  { scene, time, camera, canvas, settings }: Pick<Renderer, 'scene' | 'time' | 'camera' | 'settings' | 'canvas'>,
  x: number,
  y: number,
): number | null {
  const { width, height } = canvas;
  if (!scene || width * height === 0) return null;
  const now = sceneSeenBy(settings.integrator, posedSceneAt(scene, time));
  const frame = cameraFrame(camera, width, height, settings.framing);
  const ray = rayThrough(frame, x * width, y * height, width, height);
  const { t } = closestHit({ ...prepareScene(lampsAsShapes(now).scene), visibleLights: [] }, ray);
  if (!Number.isFinite(t)) return null;
  if (camera.projection === 'equirectangular') return t;
  const fromEye = subtract(addScaled(ray.origin, ray.direction, t), camera.eye);
  return dot(fromEye, cameraAxes(camera).forward);
}
