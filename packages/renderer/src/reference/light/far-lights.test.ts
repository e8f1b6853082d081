import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../../../tests/fixtures/random.ts';
import { testLight } from '../../../../../tests/fixtures/scenes.ts';
import type { Vec3 } from '../../scene/scene.ts';
import { dot, normalize } from '../../scene/vec3.ts';
import { choiceProbabilities, estimatedIrradiance } from './choose.ts';
import { type Emitter, emitterPdf, sampleEmitter } from './emitter.ts';
import { emitterOfLight, emitterOfShape } from './from-scene.ts';

const UP: Vec3 = [0, 1, 0];
const ORIGIN: Vec3 = [0, 0, 0];

/** Mean over the samples of red radiance · cos / pdf. */
function irradiance(e: Emitter, normal: Vec3, count: number, seed: number): number {
  const random = seededRandom(seed);
  let sum = 0;
  for (let k = 0; k < count; k++) {
    const sample = sampleEmitter(e, ORIGIN, [(k + random()) / count, (k * 0.6180339887498949 + random() / count) % 1]);
    if (sample !== null) sum += (sample.radiance[0] * Math.max(dot(sample.direction, normal), 0)) / sample.pdf;
  }
  return sum / count;
}

describe('lights without a surface', () => {
  const sun = (angle: number) =>
    emitterOfLight({ type: 'directional', direction: [1, -2, 0.5], irradiance: 3, color: [1, 1, 1], angle });
  test.each([0, 0.01, 0.53, 30])('a sun of %d° gives its irradiance to what faces it (seed 41)', (angle) => {
    const toSun = normalize([-1, 2, -0.5]);
    expect(irradiance(sun(angle), toSun, 20_000, 41)).toBeCloseTo(3, 4);
    expect(irradiance(sun(angle), UP, 20_000, 41)).toBeCloseTo(3 * toSun[1], 3);
  });
  test('the density of a sun is one over its solid angle, and 0 beside it', () => {
    const [e, toSun] = [sun(2), normalize([-1, 2, -0.5])];
    const { direction, pdf } = sampleEmitter(e, ORIGIN, [0.999, 0.3])!;
    expect(emitterPdf(e, ORIGIN, direction)).toBe(pdf);
    expect(pdf).toBeCloseTo(1 / (2 * Math.PI * (1 - Math.cos(Math.PI / 180))), 6);
    expect(emitterPdf(e, ORIGIN, normalize([toSun[0] + 0.04, toSun[1], toSun[2]]))).toBe(0);
  });
  test('a point light gives intensity / distance², a spot the same between its angles', () => {
    const position: Vec3 = [0, 2, 0];
    const point = emitterOfLight({ type: 'point', position, intensity: 8, color: [1, 1, 1] });
    expect(irradiance(point, UP, 1, 1)).toBeCloseTo(2, 12);
    const spot = (direction: Vec3) => irradiance(emitterOfLight({ ...spotLight, position, direction }), UP, 1, 1);
    const spotLight = { type: 'spot', intensity: 8, color: [1, 1, 1], innerAngle: 20, outerAngle: 40 } as const;
    const off = (degrees: number): Vec3 => [
      Math.sin((degrees * Math.PI) / 180),
      -Math.cos((degrees * Math.PI) / 180),
      0,
    ];
    expect(spot(off(0))).toBeCloseTo(2, 12);
    expect(spot(off(19.9))).toBeCloseTo(2, 12);
    expect(spot(off(40.1))).toBe(0);
    const share = (Math.cos(Math.PI / 6) - Math.cos(Math.PI / 4.5)) / (Math.cos(Math.PI / 9) - Math.cos(Math.PI / 4.5));
    expect(spot(off(30))).toBeCloseTo(2 * share ** 2, 10);
  });
  test('a sky gives π times its mean, weighted with the cosine (seed 42)', () => {
    const sky: Emitter = { kind: 'sky', horizon: [1, 1, 1], zenith: [4, 1, 1] };
    // ∫ (1 + 3 y) y over the upper half: π + 3 · 2π / 3.
    expect(irradiance(sky, UP, 50_000, 42) / (3 * Math.PI)).toBeCloseTo(1, 2.6);
    expect(irradiance(sky, [0, -1, 0], 50_000, 42) / Math.PI).toBeCloseTo(1, 2.6);
  });
});

describe('choosing', () => {
  const ball = (center: Vec3, radius = 0.5) => emitterOfLight(testLight({ center, radius }));
  const lamp = emitterOfLight({
    type: 'quad',
    corner: [-0.5, 3, -0.5],
    u: [1, 0, 0],
    v: [0, 0, 1],
    radiance: 1,
    color: [1, 1, 1],
    visible: true,
  });
  test('goes by the irradiance of far lamps', () => {
    expect(estimatedIrradiance(ball([0, 50, 0]), ORIGIN, UP)).toBeCloseTo((Math.PI * 0.25) / 2500, 7);
    expect(estimatedIrradiance(ball([30, 40, 0]), ORIGIN, UP) / ((Math.PI * 0.25 * 0.8) / 2500)).toBeCloseTo(1, 1);
    const [near, far] = choiceProbabilities([ball([0, 10, 0]), ball([0, 20, 0])], ORIGIN, null);
    expect(near! / far!).toBeCloseTo(4, 10);
  });
  test('is never without chance for what shines, and always for what cannot', () => {
    const all = [lamp, ball([0, 3, 0]), ball([3, -0.4, 0]), ball([3, -0.6, 0])];
    const [, above, through, below] = choiceProbabilities(all, ORIGIN, UP);
    expect(above).toBeGreaterThan(through!);
    expect(through).toBeGreaterThan(0);
    expect(below).toBe(0);
    expect(choiceProbabilities(all, [0, 5, 0], null)[0]).toBe(0);
    expect(choiceProbabilities(all, ORIGIN, null).every((p) => p > 0)).toBe(true);
    expect(choiceProbabilities([lamp], [0, 5, 0], UP)).toEqual([1]);
    expect(choiceProbabilities([lamp, lamp], [0, 5, 0], UP)).toEqual([0, 0]);
  });
  test('stays bounded in and on a lamp', () => {
    const box = emitterOfShape(
      { type: 'box', center: [0, 0, 0], size: [1, 1, 1], rotation: [0, 0, 0], material: '' },
      [1, 1, 1],
    );
    for (const e of [ball(ORIGIN), box, ball([0, 0.5, 0])])
      expect(estimatedIrradiance(e, ORIGIN, UP)).toBeLessThan(1.01 * Math.PI);
  });
});
