/** What the camera sees first of meshes with textures, held against the double-precision tracer. */
import { addReferenceSample, type FilmJob, referenceRows } from 'mirrorball/headless';
import type { MeshShape, Scene } from '../../../../packages/renderer/src/scene/scene.ts';
import type { ImagePixels } from '../../../../packages/renderer/src/scene/textures.ts';
import { flat, sheet, wavy } from '../../../fixtures/meshes/sheet.ts';
import { seededRandom } from '../../../fixtures/random.ts';
import { testMaterial, testScene } from '../../../fixtures/scenes.ts';
import type { GpuBackend } from '../parity.ts';
import { tracerOn } from '../tracers.ts';

const WIDTH = 60;
const HEIGHT = 40;
const SAMPLES = 3;

const place = (x: number, y: number): Omit<MeshShape, 'mesh' | 'material'> => ({
  type: 'mesh',
  translation: [x, y, 0],
  rotation: [20, 30, 10],
  scale: [1, 1, 1],
});

function noise(seed: number, width: number, height: number, middle: readonly number[], spread: number): ImagePixels {
  const random = seededRandom(seed);
  const byte = (c: number) => Math.round(255 * (middle[c]! + spread * (random() - 0.5)));
  return { width, height, rgba: Uint8Array.from({ length: 4 * width * height }, (_, i) => byte(i % 4)) };
}

/** Sheets side by side, one with holes, one behind one that is not there from behind, one of them seen at grazing angles; of the last two one is mirrored, one stretched, turned and seen from behind. */
export const texturedScene: Scene = {
  ...testScene(
    {
      colored: { ...place(-2.4, 1.3), mesh: 'sheet', material: 'white' },
      textured: { ...place(0, 1.3), mesh: 'plain', material: 'textured' },
      glowing: { ...place(2.4, 1.3), mesh: 'plain', material: 'glowing' },
      away: { ...place(2.4, 1.3), mesh: 'flat', material: 'oneSided', translation: [2, 1, 1.5], rotation: [0, 160, 0] },
      towards: {
        ...place(2.4, 1.3),
        mesh: 'flat',
        material: 'oneSided',
        translation: [3, 2, 1.5],
        scale: [0.5, -0.5, 1],
      },
      bumpy: { ...place(-2.4, -1.3), mesh: 'plain', material: 'bumpy', rotation: [-60, 20, 0] },
      mirrored: { ...place(0, -1.3), mesh: 'sheet', material: 'bumpy', scale: [-1, 1, 0.7] },
      behind: { ...place(2.4, -1.3), mesh: 'flat', material: 'bumpy', rotation: [0, 150, 0], scale: [1, 0.8, 1.2] },
    },
    {},
    {
      camera: { eye: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], verticalFov: 31, projection: 'perspective' },
      materials: {
        white: testMaterial(),
        textured: testMaterial({
          baseColor: [0.9, 0.8, 0.7],
          baseColorTexture: { texture: 'colors', uvSet: 1, offset: [0.3, 0.1], rotation: 25, scale: [0.7, 0.9] },
          alphaMode: 'mask',
          alphaCutoff: 0.4,
        }),
        glowing: testMaterial({
          baseColor: [0.1, 0.1, 0.1],
          emission: [0.9, 0.4, 0.2],
          emissionTexture: { texture: 'colors' },
        }),
        oneSided: testMaterial({ baseColor: [0.2, 0.9, 0.2], doubleSided: false }),
        bumpy: testMaterial({
          type: 'metallicRoughness',
          baseColor: [0.5, 0.6, 0.7],
          normalTexture: { texture: 'bumps', normalScale: 4 },
        }),
      },
      meshes: {
        sheet: { data: sheet(9, wavy) },
        plain: { data: { ...sheet(9, wavy), colors: undefined } },
        flat: { data: { ...sheet(1, flat), colors: undefined } },
      },
    },
  ),
  images: {
    colors: { data: noise(3, 11, 6, [0.5, 0.5, 0.5, 1], 1) },
    bumps: { data: noise(4, 7, 7, [0.5, 0.5, 0.9, 1], 0.2) },
  },
  textures: {
    colors: { image: 'colors', wrapU: 'mirror' },
    bumps: { image: 'bumps' },
  },
} as Scene;

/** Share of the sums that differ by more than rounding of directions to 16 bits does; and how much of the picture there is to see. */
export async function texturedSights(backend: GpuBackend, seed: number) {
  const tracer = await tracerOn(backend);
  const settings = { integrator: 'path', maxDepth: -1, maxReflections: 0, lightSamples: 1, seed } as const;
  const area = { x: 0, y: 0, width: WIDTH, height: HEIGHT };
  const job: FilmJob = { scene: texturedScene, settings, width: WIDTH, height: HEIGHT, area, content: 'features' };
  await tracer.begin(job);
  const film = await tracer.trace(0, SAMPLES, null);
  const expected = new Float32Array(film.length);
  const rows = referenceRows(job);
  for (let s = 0; s < SAMPLES; s++) addReferenceSample(expected, rows(s, 0, HEIGHT), job);
  const pixels = WIDTH * HEIGHT;
  const differences = Array.from({ length: 2 * pixels }, (_, p) =>
    Math.max(...[0, 1, 2, 3].map((c) => Math.abs(film[4 * p + c]! - expected[4 * p + c]!))),
  );
  const off = (layer: number, tolerance: number) =>
    differences.slice(layer * pixels, (layer + 1) * pixels).filter((d) => !(d <= SAMPLES * tolerance)).length / pixels;
  const hits = Array.from({ length: pixels }, (_, p) => expected[4 * (pixels + p) + 3]!);
  const covered = hits.filter((n) => n > 0).length / pixels;
  // Octahedral vectors are off by 1.4e-4, and a map tilts what they span.
  return { albedoOff: off(0, 2e-4), normalsOff: off(1, 1e-3), covered };
}
