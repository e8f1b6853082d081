import { beforeAll, expect, test } from 'vitest';
import { landscape } from '../../../../tests/fixtures/meshes.ts';
import { inCube, randomDirection, seededRandom } from '../../../../tests/fixtures/random.ts';
import { testScene } from '../../../../tests/fixtures/scenes.ts';
import { loadGeometryPacker } from '../packed-scene/geometry-packer.ts';
import { packPathScene } from '../packed-scene/pack-path-scene.ts';
import { closestHit } from '../reference/cast.ts';
import { prepareScene } from '../reference/prepare.ts';
import { cameraRay } from '../reference/ray.ts';
import { stillMoment } from '../scene/motion.ts';
import type { MeshShape, Vec3 } from '../scene/scene.ts';
import { subtract } from '../scene/vec3.ts';
import { GeometryWalk } from './geometry-walk.ts';
import { sketchInSteps } from './sketch.ts';

beforeAll(async () => {
  await loadGeometryPacker();
});

const shape = (mesh: string, translation: Vec3, more: Partial<MeshShape> = {}): MeshShape => ({
  type: 'mesh',
  mesh,
  material: 'white',
  translation,
  rotation: [10, 20, 30],
  scale: [1, 1, 1],
  ...more,
});

/** Four meshes at several places, turned, scaled and mirrored. */
function crowd() {
  const meshes = Object.fromEntries([0, 1].map((seed) => [`m${seed}`, { data: landscape(seededRandom(seed), 12) }]));
  const shapes = {
    a: shape('m0', [0, 0, 0]),
    b: shape('m1', [0.5, 0.3, -1], { scale: [2, 0.5, 1] }),
    c: shape('m0', [-1, 0.4, 0.6], { scale: [-1, 1, 1] }),
    d: shape('m1', [0.2, -0.8, 0.9], { rotation: [80, 0, 45] }),
  };
  return testScene(shapes, {}, { meshes });
}

test('finds the triangles that the reference tracer finds (seed 61)', () => {
  const scene = crowd();
  const eye: Vec3 = [0.1, 0.2, 3];
  const walk = new GeometryWalk(packPathScene(stillMoment(scene), eye).geometry!);
  const reference = prepareScene(scene);
  const random = seededRandom(61);
  let hits = 0;
  const misses: number[] = [];
  for (let i = 0; i < 4000; i++) {
    const origin = inCube(random, 3);
    const direction = i % 2 ? randomDirection(random) : (subtract(inCube(random, 0.7), origin) as Vec3);
    const length = Math.hypot(...direction);
    const unit = direction.map((x) => x / length) as unknown as Vec3;
    const expected = closestHit(reference, cameraRay(origin, unit)).t;
    const found = walk.closest(subtract(origin, eye), unit, Infinity);
    if (found) hits++;
    // Triangles are held in 32 bits; a ray that passes by an edge may see another than in double precision.
    const difference = Math.abs((found ? walk.t : Infinity) - expected);
    if (!(difference <= 1e-4) && !(expected === Infinity && !found)) misses.push(difference);
  }
  expect(hits).toBeGreaterThan(500);
  expect(misses.length).toBeLessThanOrEqual(2);
});
test('a sketch of a white mesh in a white sky is white, and the sky around it is the sky', () => {
  const meshes = { m: { data: landscape(seededRandom(3), 8) } };
  const scene = testScene(
    { m: shape('m', [0, 0, 0], { rotation: [0, 0, 0], material: 'own' }) },
    {},
    {
      meshes,
      sky: { horizon: [0.7, 0.7, 0.7], zenith: [0.7, 0.7, 0.7] },
    },
  );
  const own = { ...scene.materials.white!, baseColor: [1, 1, 1] as const };
  const whole = { ...scene, materials: { ...scene.materials, own } };
  const camera = { eye: [0, 3, 0.1], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 60 } as const;
  const packed = packPathScene(stillMoment(whole), camera.eye);
  const [width, height] = [16, 12];
  const pixels = new Float32Array(4 * width * height);
  const rows = [...sketchInSteps({ scene: whole, camera, framing: null, width, height, geometry: packed.geometry!, shapeNames: packed.shapeNames }, pixels)]; // biome-ignore format: one call
  expect(rows.length).toBe(height);
  for (let i = 0; i < pixels.length; i += 4) {
    for (let c = 0; c < 3; c++) expect(pixels[i + c]).toBeCloseTo(0.7, 1.5);
    expect(pixels[i + 3]).toBe(1);
  }
});
