import { expect, test } from 'vitest';
import { between, inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Vec3 } from '../scene/scene.ts';
import { addScaled, dot, length, subtract } from '../scene/vec3.ts';
import { falloffIntegral, halo } from './halo.ts';
import { prepareScene } from './prepare.ts';
import { cameraRay } from './ray.ts';

/** Simpson's rule. */
function integrate(f: (x: number) => number, from: number, to: number, steps: number): number {
  const h = (to - from) / steps;
  let sum = f(from) + f(to);
  for (let k = 1; k < steps; k++) sum += f(from + k * h) * (k % 2 === 1 ? 4 : 2);
  return (sum * h) / 3;
}

test('closed form = quadrature of 1 / distance² along the ray, in front and behind (seed 1)', () => {
  const random = seededRandom(1);
  for (let k = 0; k < 300; k++) {
    const light = testLight({ center: inCube(random, 2), radius: between(random, 0.2, 0.6) });
    const ray = cameraRay(inCube(random, 3), randomDirection(random));
    const t = between(random, 0.01, 8);
    const toCenter = subtract(light.center, ray.origin);
    const along = dot(toCenter, ray.direction);
    const b = length(addScaled(toCenter, ray.direction, -along));
    // Outside the ball's cylinder it is 1 / distance² to the centre; inside, the ray is moved out to the radius.
    const missing = Math.max(light.radius ** 2 - b * b, 0);
    const falloff = (s: number) =>
      1 / (length(subtract(addScaled(ray.origin, ray.direction, s), light.center)) ** 2 + missing);
    const exact = integrate(falloff, 0, t, 2000);
    expect(Math.abs(falloffIntegral(light, ray, t) / exact - 1)).toBeLessThan(1e-8);
  }
});

test("continuous across the ball's edge", () => {
  const light = testLight({ center: [0, 0, -5], radius: 1 });
  const at = (b: number) => falloffIntegral(light, cameraRay([b, 0, 0], [0, 0, -1]), 10);
  expect(Math.abs(at(1 + 1e-9) - at(1 - 1e-9))).toBeLessThan(1e-8);
  expect(at(0)).toBe(at(0.99));
  expect(at(1.1)).toBeLessThan(at(1));
});

test('lights add up, coloured by diffuse; hidden ones and clear air give none; nothing hit counts as 10⁵', () => {
  const red = testLight({ center: [0, 1, -5], diffuse: [1, 0, 0], halo: 0.1, visible: true, radiance: 4, radius: 0.5 });
  const blue = { ...red, diffuse: [0, 0, 1] as Vec3, halo: 0.3 };
  const scene = testScene({}, { red, blue, hidden: { ...red, visible: false }, clear: { ...red, halo: 0 } });
  const ray = cameraRay([0, 0, 0], [0, 0, -1]);
  const integral = Math.atan(1e5 - 5) + Math.atan(5);
  const glow = halo(prepareScene(scene), ray, Infinity);
  expect(glow[0]).toBeCloseTo(0.1 * integral, 12);
  expect(glow[1]).toBe(0);
  expect(glow[2]).toBeCloseTo(0.3 * integral, 12);
});
