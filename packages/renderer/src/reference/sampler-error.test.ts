/** What the arrangement of samples is for: smaller errors, and errors that neighbouring pixels make up for. */
import { describe, expect, test } from 'vitest';
import { Sampler, type SamplerKind } from './sampler.ts';

interface Integrand {
  readonly draw: (s: Sampler) => number;
  readonly integral: number;
}
const INTEGRANDS = {
  smooth: {
    draw: (s) => {
      const [u, v] = s.next2d();
      return Math.exp(-u * u - v);
    },
    integral: 0.7468241328124271 * (1 - Math.exp(-1)),
  },
  'quarter disk': {
    draw: (s) => {
      const [u, v] = s.next2d();
      return u * u + v * v < 1 ? 1 : 0;
    },
    integral: Math.PI / 4,
  },
  step: { draw: (s) => (s.next1d() < 0.37 ? 1 : 0), integral: 0.37 },
  'smooth in three': {
    draw: (s) => {
      const [u, v, w] = s.next3d();
      return u * v * w + Math.sin(3 * w) * u;
    },
    integral: 1 / 8 + (1 - Math.cos(3)) / 6,
  },
  'two groups': {
    draw: (s) => {
      const [u, v] = s.next2d();
      const [a, b] = s.next2d();
      return (u + v * v) * (a + b);
    },
    integral: 5 / 6,
  },
  'only both groups together': { draw: (s) => (s.next2d()[0] - 0.5) * (s.next2d()[1] - 0.5), integral: 0 },
} as const satisfies Record<string, Integrand>;
type Name = keyof typeof INTEGRANDS;

function pixelError(name: Name, x: number, y: number, spp: number, seed: number, kind: SamplerKind = 'sobol'): number {
  const { draw, integral } = INTEGRANDS[name];
  let sum = 0;
  for (let i = 0; i < spp; i++) sum += draw(new Sampler(x, y, i, seed, kind));
  return sum / spp - integral;
}
const rms = (errors: readonly number[]) => Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length);

describe('the error of a pixel, as a share of that of independent numbers', () => {
  test.each([
    ['smooth', 16, 0.12],
    ['smooth', 64, 0.035],
    ['smooth', 256, 0.01],
    ['quarter disk', 16, 0.7],
    ['quarter disk', 64, 0.53],
    ['quarter disk', 256, 0.34],
    ['step', 16, 0.25],
    ['step', 64, 0.2],
    ['step', 256, 0.1],
    ['smooth in three', 16, 0.25],
    ['smooth in three', 64, 0.11],
    ['smooth in three', 256, 0.04],
    ['two groups', 16, 0.5],
    ['two groups', 64, 0.5],
    ['two groups', 256, 0.5],
  ] as const)('%s, %i samples: below %f (seed 41)', (name, spp, bound) => {
    const errors = (kind: SamplerKind) =>
      Array.from({ length: 200 }, (_, t) => pixelError(name, 16 * t + 3, 5, spp, 41, kind));
    expect(rms(errors('sobol')) / rms(errors('independent'))).toBeLessThan(bound);
  });

  test('is 0 in the mean over seeds, for one sample too (seeds 0 to 3999)', () => {
    for (const name of Object.keys(INTEGRANDS) as Name[])
      for (const spp of [1, 3]) {
        const errors = Array.from({ length: 4000 }, (_, seed) => pixelError(name, 19, 7, spp, seed));
        const mean = errors.reduce((sum, e) => sum + e, 0) / errors.length;
        expect(Math.abs(mean), `${name}, ${spp}`).toBeLessThan((4 * rms(errors)) / Math.sqrt(errors.length));
      }
  });
});

/** Power of the waves longer than `side / most` pixels, as a share of what white noise with the same variance would have. */
function lowFrequencies(picture: readonly number[], side: number, most: number): number {
  const mean = picture.reduce((sum, e) => sum + e, 0) / picture.length;
  const variance = rms(picture.map((e) => e - mean)) ** 2;
  const cosine = Array.from({ length: side }, (_, k) => Math.cos((2 * Math.PI * k) / side));
  let [power, count] = [0, 0];
  for (let ky = -most; ky <= most; ky++)
    for (let kx = 0; kx <= most; kx++) {
      if (kx * kx + ky * ky > most * most || (kx === 0 && ky <= 0)) continue;
      let [re, im] = [0, 0];
      picture.forEach((e, p) => {
        const turn = kx * (p % side) + ky * Math.floor(p / side) + side * side;
        re += e * cosine[turn % side]!;
        im += e * cosine[(turn + (3 * side) / 4) % side]!;
      });
      power += (re * re + im * im) / picture.length;
      count++;
    }
  return power / count / variance;
}

describe('the error of a picture', () => {
  const side = 64;
  const picture = (name: Name, spp: number, kind: SamplerKind) =>
    Array.from({ length: side * side }, (_, p) =>
      pixelError(name, 64 + (p % side), 128 + Math.floor(p / side), spp, 42, kind),
    );

  test.each([
    ['smooth', 1, 0.2],
    ['smooth', 4, 0.25],
    ['smooth', 16, 0.25],
    ['smooth in three', 1, 0.3],
    ['smooth in three', 4, 0.25],
    ['quarter disk', 1, 0.6],
    ['quarter disk', 4, 0.75],
    ['step', 1, 0.25],
    ['step', 4, 0.35],
    ['two groups', 1, 0.4],
  ] as const)(
    '%s, %i samples: waves of 8 pixels and more have below %f of the power of white noise (seed 42)',
    (name, spp, bound) => {
      expect(lowFrequencies(picture(name, spp, 'sobol'), side, 8)).toBeLessThan(bound);
    },
  );

  test('of independent numbers it is white (seed 42)', () => {
    for (const spp of [1, 4]) {
      const power = lowFrequencies(picture('smooth', spp, 'independent'), side, 8);
      expect(power).toBeGreaterThan(0.7);
      expect(power).toBeLessThan(1.3);
    }
  });

  // Shuffles that a whole tile shares would give 1.7 here, with tiles at 6 standard deviations: a mean over many pixels would
  // be far less certain than the pixels say.
  test.each([
    ['two groups', 4],
    ['two groups', 16],
    ['two groups', 64],
    ['only both groups together', 16],
    ['only both groups together', 64],
  ] as const)('%s, %i samples: tiles are about as certain as 256 pixels apart (seed 43)', (name, spp) => {
    const tiles = Array.from({ length: 128 }, (_, t) =>
      Array.from({ length: 256 }, (_, p) => pixelError(name, 16 * t + (p % 16), Math.floor(p / 16), spp, 43)),
    );
    const pixelRms = rms(tiles.flat());
    const means = tiles.map((errors) => errors.reduce((sum, e) => sum + e, 0) / 16);
    expect(rms(means) / pixelRms).toBeLessThan(1.25);
    expect(Math.max(...means.map(Math.abs)) / pixelRms).toBeLessThan(4.5);
  });
});
