import { describe, expect, test } from 'vitest';
import { between, inCube, meanAndError, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testLight, testMaterial, testScene } from '../../../../tests/fixtures/scenes.ts';
import type { Camera, Shape, Vec3 } from '../scene/scene.ts';
import { add, addScaled, dot, length, normalize, scale, subtract } from '../scene/vec3.ts';
import { occluded } from './cast.ts';
import { prepareClassic, tracePixel } from './classic.ts';
import { hashOfSample, lightRandoms } from './hash.ts';
import { prepareScene } from './prepare.ts';
import { rayLeaving } from './ray.ts';
import { samplePoints } from './sample-points.ts';

const floor: Shape = { type: 'plane', point: [0, 0, 0], normal: [0, 1, 0], material: 'white' };

/** A camera whose one pixel looks at `point`. */
const lookingAt = (point: Vec3, from: Vec3): Camera => ({
  eye: from,
  target: point,
  up: [0.1, 0.2, 1],
  verticalFov: 30,
});

/** The shade of the white floor at `point` for each of many seeds. */
function shades(point: Vec3, light: ReturnType<typeof testLight>, lightSamples: number, seeds: number): number[] {
  const scene = testScene({ floor }, { lamp: light });
  const camera = lookingAt(point, add(point, [0.3, 2, -0.2]));
  return Array.from({ length: seeds }, (_, seed) => {
    const tracer = prepareClassic(scene, { width: 1, height: 1, camera, lightSamples, seed });
    return tracePixel(tracer, 0, 0)[0];
  });
}

describe('irradiance of a floor under a spherical light (mean-value property)', () => {
  // Height of the centre over the floor and horizontal distance, in radii of the light. 1.02 almost touches the floor.
  const places = [
    [1.1, 0],
    [1.02, 0.5],
    [1.05, 3],
    [1.5, 0],
    [2, 1],
    [3, 0],
    [5, 4],
    [20, 0],
    [20, 30],
    [200, 50],
  ];

  test.each(places)('height %f, aside %f radii: radiance · radius² / d² · cos θ (seeds 0 … 399)', (height, aside) => {
    const radius = 0.5;
    const light = testLight({ center: [0, height! * radius, 0], radius, radiance: 7 });
    const d2 = height! ** 2 + aside! ** 2;
    const exact = (7 * height!) / Math.sqrt(d2) / d2;
    const { mean, standardError } = meanAndError(shades([aside! * radius, 0, 0], light, 16, 400));
    expect(Math.abs(mean - exact)).toBeLessThan(4 * standardError + 1e-12);
    expect(standardError / exact).toBeLessThan(0.05);
  });

  test('the error falls faster than that of independent points (seeds 0 … 199)', () => {
    const light = testLight({ center: [0.2, 0.8, 0.1], radius: 0.5 });
    const distance = Math.hypot(0.2, 0.8, 0.1);
    const exact = (0.25 * 0.8) / distance ** 3;
    const rms = [4, 16, 64, 256].map((n) => {
      const errors = shades([0, 0, 0], light, n, 200).map((x) => (x - exact) ** 2);
      return Math.sqrt(errors.reduce((a, b) => a + b) / errors.length);
    });
    // Independent points would halve the error at each step.
    for (let k = 1; k < rms.length; k++) expect(rms[k]! / rms[k - 1]!).toBeLessThan(0.45);
  });

  test('1 sample and the 9 of the grid are exact sums, whatever the seed', () => {
    const light = testLight({ center: [0.3, 1.1, 0.2], radius: 0.4, radiance: 3 });
    const from = (p: Vec3) => (3 * 0.16 * p[1]) / length(p) ** 3;
    const [first, second] = shades([0, 0, 0], light, 1, 2);
    expect(first).toBeCloseTo(from(light.center), 12);
    expect(second).toBe(first);
    const steps = [-0.2, 0, 0.2];
    const grid = steps.flatMap((x) => steps.map((z) => from(add(light.center, [x, 0, z]))));
    expect(shades([0, 0, 0], light, 9, 1)[0]).toBeCloseTo(grid.reduce((a, b) => a + b) / 9, 12);
  });
});

/** Shares of visible sample points from `point` on the floor, one for each seed. */
function visibleShares(
  shapes: Record<string, Shape>,
  point: Vec3,
  center: Vec3,
  radius: number,
  seeds: number,
): number[] {
  const scene = prepareScene(testScene({ floor, ...shapes }, {}));
  const eye: Vec3 = add(point, [0, 3, 4]);
  return Array.from({ length: seeds }, (_, seed) => {
    const points = samplePoints(64, lightRandoms(hashOfSample(3, 5, 0, seed), 0, 0));
    const visible = points.filter((offset) => {
      const toPoint = subtract(addScaled(center, offset, radius), point);
      const ray = rayLeaving(
        { shape: scene.planes[0]!, point, outwardNormal: [0, 1, 0], triangle: -1 },
        normalize(toPoint),
        eye,
      );
      return !occluded(scene, ray, length(toPoint));
    });
    return visible.length / points.length;
  });
}

describe('penumbra of a straight edge', () => {
  const center: Vec3 = [0, 4, 0.3];
  const radius = 0.5;
  // Each covers x < 0 at height 2 and is as good as endless; its edge is the line x = 0, y = 2.
  const quad: Shape = { type: 'quad', corner: [-500, 2, -500], u: [500, 0, 0], v: [0, 0, 1000], material: 'white' };
  const size: Vec3 = [500, 1e-6, 1000];
  const box: Shape = { type: 'box', center: [-250, 2.0000005, 0], size, rotation: [0, 0, 0], material: 'white' };
  const turned: Shape = { ...box, size: [1000, 1e-6, 500], rotation: [0, 90, 0] };
  const places = [-0.75, -0.49, -0.4, -0.25, -0.1, 0, 0.05, 0.2, 0.35, 0.45, 0.499, 0.75];

  test.each([
    ['quad', quad],
    ['box', box],
    ['turned box', turned],
  ] as const)('%s: the visible share of the sphere is (1 + h / radius) / 2 (seeds 0 … 149)', (_, occluder) => {
    let before = -1;
    for (const x of places) {
      const { mean, standardError } = meanAndError(visibleShares({ occluder }, [x, 0, 0], center, radius, 150));
      // The plane through the point and the edge: its normal looks to the side that is open.
      const normal = normalize([2, x, 0]);
      const h = dot(subtract(center, [x, 0, 0]), normal);
      const share = Math.min(Math.max((1 + h / radius) / 2, 0), 1);
      // A box is seen from below: its lower edge is the one that counts. One point in 64 · 150 is the grain.
      expect(Math.abs(mean - share), `x = ${x}`).toBeLessThan(4 * standardError + 2e-4);
      expect(mean).toBeGreaterThanOrEqual(before);
      before = mean;
    }
  });
});

test('the light ball casts no shadow, and what stands behind the light neither (seed 3)', () => {
  const random = seededRandom(3);
  const behind: Shape = { type: 'quad', corner: [-9, 2, -9], u: [18, 0, 0], v: [0, 0, 18], material: 'white' };
  for (let k = 0; k < 50; k++) {
    const point: Vec3 = [between(random, -3, 3), 0, between(random, -3, 3)];
    const light = testLight({ center: [0, 1, 0], radius: 0.3, visible: true });
    const open = prepareClassic(testScene({ floor }, { light }), {
      width: 1,
      height: 1,
      camera: lookingAt(point, [2, 1.5, 7]),
    });
    const covered = testScene({ floor, behind }, { light });
    const tracer = prepareClassic(covered, { width: 1, height: 1, camera: lookingAt(point, [2, 1.5, 7]) });
    expect(tracePixel(tracer, 0, 0)[0]).toBe(tracePixel(open, 0, 0)[0]);
    expect(tracePixel(tracer, 0, 0)[0]).toBeCloseTo(0.09 / (1 + point[0] ** 2 + point[2] ** 2) ** 1.5, 12);
  }
});

test('diffuse, specular and ambient of two lights, written out (seed 4)', () => {
  const random = seededRandom(4);
  for (let k = 0; k < 200; k++) {
    const material = testMaterial({ baseColor: [0.2, 0.5, 0.7], specular: 0.6, roughness: between(random, 0, 1) });
    const center: Vec3 = add([0, 3, 0], inCube(random, 1));
    const lamp = testLight({ center, diffuse: [1, 0.9, 0.8], specular: [0.3, 0.4, 0.5], ambient: [0.01, 0.02, 0.03] });
    const below = testLight({ center: [0, -1, 0], specular: [9, 9, 9], ambient: [0.5, 0.5, 0.5] });
    const scene = testScene({ floor }, { lamp, below }, { materials: { white: material } });
    const eye: Vec3 = [between(random, -4, 4), 1, between(random, -4, 4)];
    const tracer = prepareClassic(scene, { width: 1, height: 1, camera: lookingAt([0, 0, 0], eye) });
    const l = normalize(center);
    const nh = normalize(add(l, normalize(eye)))[1];
    const highlight = 0.6 * nh ** Math.max(2 / Math.max(material.roughness, 0.05) ** 4 - 2, 0);
    const w = 0.01 / dot(center, center);
    const expected = [0, 1, 2].map((c) => {
      const ambient = (lamp.ambient[c]! + 0.5) * material.baseColor[c]!;
      return ambient + w * (material.baseColor[c]! * lamp.diffuse[c]! * l[1] + highlight * lamp.specular[c]!);
    });
    tracePixel(tracer, 0, 0).forEach((value, c) => {
      expect(value).toBeCloseTo(expected[c]!, 10);
    });
  }
});

test('a surface lit from inside a sphere is lit, and dark for lights outside (seed 5)', () => {
  const random = seededRandom(5);
  for (let k = 0; k < 200; k++) {
    const radius = 10 ** between(random, -3, 4);
    const shell: Shape = { type: 'sphere', center: [0, 0, 0], radius, material: 'white' };
    const at = (share: number) => scale(inCube(random, 0.5), radius * share);
    const inside = testLight({ center: at(1), radius: radius / 100 });
    const outside = testLight({ center: [0, 3 * radius, 0], radius: radius / 10 });
    const camera = lookingAt(add(at(1), [radius, 0, 0]), at(1));
    const light = (lamp: typeof inside) =>
      tracePixel(prepareClassic(testScene({ shell }, { lamp }), { width: 1, height: 1, camera }), 0, 0)[0];
    expect(light(inside)).toBeGreaterThan(0);
    expect(light(outside)).toBe(0);
  }
});
