/** The thin lens of shading/camera/camera.wesl in double precision. The classic integrator has none. */
import { cameraAxes, focusOf, wholeCamera } from '../scene/camera.ts';
import type { Camera } from '../scene/scene.ts';
import { add, addScaled, normalize, scale, subtract } from '../scene/vec3.ts';
import type { CameraFrame } from './camera.ts';
import { rayThrough } from './camera.ts';
import { cameraRay, type Ray } from './ray.ts';

/** Shirley and Chiu, "A Low Distortion Map Between Disk and Square", 1997. */
function concentricDisc([u, v]: readonly [number, number]): [number, number] {
  const [x, y] = [2 * u - 1, 2 * v - 1];
  if (x === 0 && y === 0) return [0, 0];
  const wide = Math.abs(x) > Math.abs(y);
  const radius = wide ? x : y;
  const angle = wide ? (Math.PI / 4) * (y / x) : Math.PI / 2 - (Math.PI / 4) * (x / y);
  return [radius * Math.cos(angle), radius * Math.sin(angle)];
}

/** As `rayThrough`, from a point of the lens; `u` is a point of the unit square. */
export function rayThroughLens(
  camera: Camera,
  frame: CameraFrame,
  [column, row]: readonly [number, number],
  u: readonly [number, number],
  { width, height }: { readonly width: number; readonly height: number },
): Ray {
  const { aperture, projection } = wholeCamera(camera);
  const pinhole = rayThrough(frame, column, row, width, height);
  if (aperture === 0 || projection === 'equirectangular') return pinhole;
  const { forward, right, up } = cameraAxes(camera);
  const [x, y] = concentricDisc(u);
  const lens = addScaled(scale(right, aperture * x), up, aperture * y);
  const [across, above] = [(2 * column) / width - 1, 1 - (2 * row) / height];
  const ahead =
    projection === 'orthographic' ? forward : addScaled(addScaled(frame.forward, frame.right, across), frame.up, above);
  const direction = normalize(subtract(ahead, scale(lens, 1 / focusOf(camera))));
  return cameraRay(add(pinhole.origin, lens), direction);
}
