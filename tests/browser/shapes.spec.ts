import { backends, expect, test } from './fixtures.ts';

/**
 * The kernels' shapes against the double-precision ones: 7 × 16384 random rays from outside, inside and the surface itself,
 * with zero components, at edges and corners. How far rounding may go is worked out in harness/shapes/expectation.ts.
 */
const near = { size: 1, reach: 2, eye: 0, thickness: 1 };
const SETTINGS = [
  { ...near, seed: 101 },
  { ...near, seed: 103, size: 1e-3 },
  { ...near, seed: 105, eye: 1e4 },
  { ...near, seed: 107, size: 1e-3, eye: 1e4 },
  { ...near, seed: 109, size: 1e4 },
  { ...near, seed: 111, reach: 1000 },
  { ...near, seed: 113, thickness: 1e-5 },
];

for (const backend of backends)
  for (const setting of SETTINGS) {
    const { seed, size, reach, eye, thickness } = setting;
    const where = `${size} m large, ${reach} sizes from the eye, ${eye} from the origin, ${thickness} thick`;
    test(`${backend}: hits and normals as in double precision, shapes ${where} (seed ${seed})`, async ({ harness }) => {
      const report = await harness.evaluate(([b, s]) => window.harness.probeShapes(b, s), [backend, setting] as const);
      expect(report.examples, `${report.faults} of ${report.rays} rays`).toEqual([]);
      expect(report.hits, 'hits').toBeGreaterThan(0.2 * report.rays);
      // Every second ray is aimed at an edge or starts on a surface, with some of them along it.
      expect(report.open, 'rays that rounding leaves open').toBeLessThan(0.25 * report.rays);
    });
  }
