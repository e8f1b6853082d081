import { cameraFrame, rayThrough } from '../../packages/renderer/src/reference/camera.ts';
import { focusOf } from '../../packages/renderer/src/scene/camera.ts';
import type { Camera, Vec3 } from '../../packages/renderer/src/scene/scene.ts';
import { addScaled, dot, length, normalize, scale, subtract } from '../../packages/renderer/src/scene/vec3.ts';
import { backends, expect, test } from './fixtures.ts';

/** Rays from all over the lens against the pinhole's of the double-precision reference, which has no lens. */
const WIDTH = 96;
const HEIGHT = 64;
const BLOCK = 16;
const view: Camera = { eye: [1, 2, 3], target: [4, 2.5, -1], up: [0.1, 1, 0], verticalFov: 50, viewHeight: 3 };
const cameras: [string, Camera][] = [
  ['a lens focused on the target', { ...view, aperture: 0.2 }],
  ['a lens focused nearer', { ...view, aperture: 0.5, focusDistance: 1.5 }],
  ['a pinhole', view],
  ['an orthographic lens', { ...view, projection: 'orthographic', aperture: 0.3, focusDistance: 4 }],
  ['an orthographic pinhole', { ...view, projection: 'orthographic' }],
  ['an equirectangular camera, which has no lens', { ...view, projection: 'equirectangular', aperture: 0.3 }],
];

for (const backend of backends)
  for (const [what, camera] of cameras)
    test(`${what}: all rays of a film point meet in focus (${backend})`, async ({ harness }) => {
      const { origins, directions } = await harness.evaluate(([b, c, w, h]) => window.harness.cameraRays(b, c, w, h), [
        backend,
        camera,
        WIDTH,
        HEIGHT,
      ] as const);
      const at = (values: readonly number[], pixel: number) =>
        values.slice(4 * pixel, 4 * pixel + 3) as unknown as Vec3;
      const frame = cameraFrame(camera, WIDTH, HEIGHT);
      const forward = normalize(subtract(camera.target, camera.eye));
      const focus = focusOf(camera);
      const radius = camera.projection === 'equirectangular' ? 0 : (camera.aperture ?? 0);
      let [aside, outside, unit, moment, within] = [0, 0, 0, 0, 0];
      let sum: Vec3 = [0, 0, 0];
      for (let y = 0; y < HEIGHT; y++)
        for (let x = 0; x < WIDTH; x++) {
          const [column, row] = [x, y].map((k) => (Math.floor(k / BLOCK) + 0.5) * BLOCK) as [number, number];
          const central = rayThrough(frame, column, row, WIDTH, HEIGHT);
          const [origin, direction] = [at(origins, y * WIDTH + x), at(directions, y * WIDTH + x)];
          const offset = subtract(origin, subtract(central.origin, camera.eye));
          // A panorama looks behind itself too: there any distance will do.
          const reach = camera.projection === 'equirectangular' ? 1 : focus / dot(central.direction, forward);
          const sharp = addScaled(subtract(central.origin, camera.eye), central.direction, reach);
          const toSharp = subtract(sharp, origin);
          aside = Math.max(aside, length(subtract(normalize(toSharp), direction)));
          unit = Math.max(unit, Math.abs(length(direction) - 1));
          // Beyond the rim of the lens, or off its plane.
          outside = Math.max(outside, length(offset) - radius, Math.abs(dot(offset, forward)));
          moment += dot(offset, offset);
          if (length(offset) < radius / 2) within++;
          sum = addScaled(sum, offset, 1);
        }
      // WGSL asks of sine and cosine an error of at most 2^-11.
      expect(aside, 'directions').toBeLessThan(camera.projection === 'equirectangular' ? 3 * 2 ** -11 : 2e-5);
      expect(unit, 'their length').toBeLessThan(1e-6);
      expect(outside, 'starts').toBeLessThan(1e-6);
      const count = WIDTH * HEIGHT;
      // Uniform on a disc: the middle in the middle, mean r² = radius² / 2, a quarter within half the radius.
      expect(length(scale(sum, 1 / count))).toBeLessThan(1e-4);
      expect(Math.abs(moment / count - radius ** 2 / 2)).toBeLessThan(5e-3 * radius ** 2 + 1e-9);
      expect(within / count).toBe(radius > 0 ? 0.25 : 0);
    });
