import { rotate } from '../../packages/renderer/src/scene/vec3.ts';
import { backends, expect, test } from './fixtures.ts';

const SEED = 31;
/** Normal maps of one texel; none tilts farther than the sun allows. */
const TILTS = [
  { texel: [128, 128, 255], rotation: [0, 0, 0] },
  { texel: [180, 128, 240], rotation: [0, 0, 0] },
  { texel: [110, 70, 230], rotation: [0, 0, 0] },
  { texel: [150, 90, 220], rotation: [-20, 15, 40] },
] as const;

for (const backend of backends) {
  test(`${backend}: textures of all sizes, wraps, filters and transforms as in double precision (seed ${SEED})`, async ({
    harness,
  }) => {
    const report = await harness.evaluate(([b, s]) => window.harness.probeLookups(b, s), [backend, SEED] as const);
    expect(report.examples, `${report.faults} of ${report.asked}`).toEqual([]);
    expect(report.open, 'where rounding decides').toBeLessThan(0.001 * report.asked);
  });

  test(`${backend}: albedo and normals of textured meshes as in double precision (seed ${SEED})`, async ({
    harness,
  }) => {
    const { albedoOff, normalsOff, covered } = await harness.evaluate(([b, s]) => window.harness.texturedSights(b, s), [
      backend,
      SEED,
    ] as const);
    expect(covered).toBeGreaterThan(0.5);
    // At an edge a ray may just meet or just miss.
    expect(albedoOff, 'albedo').toBeLessThan(0.003);
    expect(normalsOff, 'normals').toBeLessThan(0.003);
  });

  test(`${backend}: opacity, single sides, unlit and emission have their closed forms (seed ${SEED})`, async ({
    harness,
  }) => {
    const cases = await harness.evaluate(([b, s]) => window.harness.lightCases(b, s), [backend, SEED] as const);
    for (const { what, mean, expected, error } of cases)
      expect.soft(Math.abs(mean - expected), `${what}: ${mean} for ${expected}`).toBeLessThan(4 * error + 1e-4);
  });

  test(`${backend}: a map that says the same everywhere is a tilted surface`, async ({ harness }) => {
    for (const { texel, rotation } of TILTS) {
      const film = await harness.evaluate(([b, t, r]) => window.harness.tiltedLight(b, t, r), [
        backend,
        texel,
        rotation,
      ] as const);
      const [x, y, z] = texel.map((byte) => (2 * byte) / 255 - 1) as [number, number, number];
      const normal = rotate([x, y, z], rotation);
      const cosine = (-0.6 * normal[1] + 0.8 * normal[2]) / Math.hypot(...normal);
      const exact = (0.5 / Math.PI) * 2 * cosine;
      expect(cosine, 'lit').toBeGreaterThan(0.1);
      for (const value of film) expect(Math.abs(value - exact), `${texel}: ${value} for ${exact}`).toBeLessThan(1e-4);
    }
  });
}
