import { describe, expect, test } from 'vitest';
import { LIGHT_CASES, type LightCase } from '../../../../../tests/fixtures/lights/cases.ts';
import { exactIrradiance } from '../../../../../tests/fixtures/lights/closed-forms.ts';
import { chiSquareZ, countBins, densityOfBins } from '../../../../../tests/fixtures/lights/histogram.ts';
import { surroundingsOf } from '../../../../../tests/fixtures/lights/surroundings.ts';
import { type Random, seededRandom } from '../../../../../tests/fixtures/random.ts';
import { dot, length, subtract } from '../../scene/vec3.ts';
import { emitterPdf, type LightSample, metEmitter, sampleEmitter } from './emitter.ts';

const SIDE = 120;

/** One jittered pair of numbers in each cell of a square, which makes means far more exact than random ones. */
function samplesOf({ emitter, point }: LightCase, random: Random): LightSample[] {
  const samples: LightSample[] = [];
  for (let k = 0; k < SIDE * SIDE; k++) {
    const u = [((k % SIDE) + random()) / SIDE, (Math.floor(k / SIDE) + random()) / SIDE] as const;
    const sample = sampleEmitter(emitter, point, u);
    if (sample !== null) samples.push(sample);
  }
  return samples;
}

const dark = (light: LightCase) => exactIrradiance(light.emitter, light.point, light.normal) === 0;
const named = (cases: readonly LightCase[]) => cases.map((light) => [light.name, light] as const);

describe('the mean of cos / pdf is the irradiance in closed form (seed 31)', () => {
  test.each(named(LIGHT_CASES))('%s', (_, light) => {
    const samples = samplesOf(light, seededRandom(31));
    const sum = samples.reduce((s, { direction, pdf }) => s + Math.max(dot(direction, light.normal), 0) / pdf, 0);
    const exact = exactIrradiance(light.emitter, light.point, light.normal);
    expect(Math.abs(sum / SIDE ** 2 - exact)).toBeLessThanOrEqual(0.003 * exact);
  });
});

describe('directions are distributed as the density says (seed 32)', () => {
  test.each(named(LIGHT_CASES.filter((light) => !dark(light))))('%s', (_, light) => {
    const { emitter, point } = light;
    const random = seededRandom(32);
    const directions = Array.from(
      { length: 10_000 },
      () => sampleEmitter(emitter, point, [random(), random()])!.direction,
    );
    const around = surroundingsOf(emitter, point);
    const bins = densityOfBins(around, (direction) => emitterPdf(emitter, point, direction));
    expect(Math.abs(bins.reduce((sum, x) => sum + x, 0) - 1)).toBeLessThan(0.015);
    const counts = countBins(around, directions);
    expect(counts.reduce((sum, n) => sum + n, 0)).toBeGreaterThan(9_950);
    expect(
      chiSquareZ(
        counts,
        bins.map((x) => x * directions.length),
      ),
    ).toBeLessThan(4);
  });
});

test.each(named(LIGHT_CASES))(
  '%s: each sample is where a ray meets the light, with the density told (seed 33)',
  (_, light) => {
    const { emitter, point } = light;
    const random = seededRandom(33);
    for (let k = 0; k < 300; k++) {
      const sample = sampleEmitter(emitter, point, [random(), random()]);
      if (sample === null) continue;
      expect(length(sample.direction)).toBeCloseTo(1, 12);
      const met = metEmitter(emitter, point, sample.direction);
      // Edges and rims may be missed by rounding.
      if (met === null) continue;
      expect(met.distance / sample.distance).toBeCloseTo(1, 5);
      expect(emitterPdf(emitter, point, sample.direction) / sample.pdf).toBeCloseTo(1, 5);
      expect(subtract(sample.radiance, emitter.radiance)).toEqual([0, 0, 0]);
    }
  },
);
