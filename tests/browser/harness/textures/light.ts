/** Light through and from meshes with textures and opacity, where the exact answer is known. */
import type { Camera, Light, Material, MeshShape, Scene } from '../../../../packages/renderer/src/scene/scene.ts';
import { flat, sheet } from '../../../fixtures/meshes/sheet.ts';
import { testMaterial, testScene } from '../../../fixtures/scenes.ts';
import type { GpuBackend } from '../parity.ts';
import { renderBy, renderPath } from '../path.ts';
import { tracerBy, tracerOfAll } from '../tracers.ts';

/** All pixels look at one point, within a millimetre, unless it says otherwise. */
export interface LightCase {
  readonly what: string;
  /** Of red. */
  readonly expected: number;
  readonly mean: number;
  /** Standard error of the mean as the closed form has it; 0: every sample is exact. */
  readonly error: number;
}

const SIZE = 16;
const SAMPLES = 64;
const AT: Omit<MeshShape, 'mesh' | 'material'> = {
  type: 'mesh',
  translation: [0, 0, 0],
  rotation: [0, 0, 0],
  scale: [1, 1, 1],
};
const sheetAt = (
  z: number,
  material: string,
  rotation: MeshShape['rotation'] = [0, 0, 0],
  mesh = 'sheet',
): MeshShape => ({
  ...AT,
  translation: [0, 0, z],
  rotation,
  material,
  mesh,
});
const black = (part: Partial<Material> = {}) => testMaterial({ baseColor: [0, 0, 0], ...part });
const camera: Camera = { eye: [0.31, 0.17, 5], target: [0.31, 0.17, 0], up: [0, 1, 0], verticalFov: 0.01 };
/** Red 1, and the alphas in a row of four. */
const alphas = [0, 85, 170, 255];
const image = { width: 4, height: 1, rgba: Uint8Array.from(alphas.flatMap((a) => [255, 128, 0, a])) };
const glow = black({ emission: [3, 3, 3] });

function scene(
  shapes: Record<string, MeshShape>,
  materials: Record<string, Material>,
  part: Partial<Scene> = {},
  lights: Record<string, Light> = {},
): Scene {
  const base = sheet(1, flat);
  const colors = Float32Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? 0.4 : 1));
  return {
    ...testScene(shapes, lights, {
      camera,
      materials: { glow, ...materials },
      meshes: {
        sheet: { data: { ...base, colors: undefined } },
        veil: { data: { ...base, colors } },
      } as unknown as NonNullable<Scene['meshes']>,
      render: { integrator: 'path', maxDepth: 2, maxReflections: 0, lightSamples: 1, exposure: 0, toneMapping: 'none' },
    }),
    images: { alphas: { data: image } },
    textures: { alphas: { image: 'alphas', filter: 'nearest' } },
    ...part,
  };
}

const blend = (opacity: number, part: Partial<Material> = {}) => black({ alphaMode: 'blend', opacity, ...part });
const sun: Light = { type: 'directional', direction: [0, 0.6, -0.8], irradiance: 2, color: [1, 1, 1], angle: 0 };
const render1 = (s: Scene): Scene => ({ ...s, render: { ...s.render, maxDepth: 1 } });

/** What is seen, and its exact value; `chance` of a sample to be `most`, else 0. */
interface Question {
  readonly scene: Scene;
  readonly most: number;
  readonly chance: number;
}

function questions(): Record<string, Question> {
  const behind = sheetAt(-1, 'glow');
  const texture = { baseColorTexture: { texture: 'alphas' } };
  // The eye looks at x = 0.31: the third column of four.
  const alpha = 170 / 255;
  const floor = testMaterial({ baseColor: [0.5, 0.5, 0.5] });
  const lit = (0.5 / Math.PI) * 2 * 0.8;
  // The sun's way to what the eye sees leads through the veil, which the eye's does not.
  const veilBeside: MeshShape = {
    ...sheetAt(0.5, 'veil'),
    translation: [0.31, 0.17 - 0.375, 0.5],
    scale: [0.2, 0.2, 1],
  };
  const unlit = black({ baseColor: [0.8, 0.8, 0.8], unlit: true, ...texture });
  return {
    'a lamp behind a veil, which is no segment': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil') }, { veil: blend(0.3) })),
      most: 3,
      chance: 0.7,
    },
    'behind two veils': {
      scene: render1(scene({ behind, a: sheetAt(0, 'veil'), b: sheetAt(0.5, 'veil') }, { veil: blend(0.3) })),
      most: 3,
      chance: 0.49,
    },
    'opacity at the vertices': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil', [0, 0, 0], 'veil') }, { veil: blend(0.5) })),
      most: 3,
      chance: 0.8,
    },
    'opacity of a texture': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil') }, { veil: blend(1, texture) })),
      most: 3,
      chance: 1 - alpha,
    },
    'a mask that is there': {
      scene: render1(
        scene(
          { behind, veil: sheetAt(0, 'veil') },
          { veil: black({ ...texture, alphaMode: 'mask', alphaCutoff: 0.6 }) },
        ),
      ),
      most: 3,
      chance: 0,
    },
    'a mask that is not': {
      scene: render1(
        scene(
          { behind, veil: sheetAt(0, 'veil') },
          { veil: black({ ...texture, alphaMode: 'mask', alphaCutoff: 0.7 }) },
        ),
      ),
      most: 3,
      chance: 1,
    },
    'opaque whatever its opacity': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil') }, { veil: black({ ...texture, opacity: 0.2 }) })),
      most: 3,
      chance: 0,
    },
    'one side, from the front': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil') }, { veil: black({ doubleSided: false }) })),
      most: 3,
      chance: 0,
    },
    'one side, from behind': {
      scene: render1(scene({ behind, veil: sheetAt(0, 'veil', [0, 180, 0]) }, { veil: black({ doubleSided: false }) })),
      most: 3,
      chance: 1,
    },
    'one side, mirrored': {
      scene: render1(
        scene({ behind, veil: { ...sheetAt(0, 'veil'), scale: [-1, 1, 1] } }, { veil: black({ doubleSided: false }) }),
      ),
      most: 3,
      chance: 0,
    },
    'no veil in the way of light': {
      scene: scene({ floor: sheetAt(0, 'floor') }, { floor }, {}, { sun }),
      most: lit,
      chance: 1,
    },
    'a veil in the way of light': {
      scene: scene({ floor: sheetAt(0, 'floor'), veilBeside }, { floor, veil: blend(0.3) }, {}, { sun }),
      most: lit,
      chance: 0.7,
    },
    'unlit: base colour times texture': {
      scene: scene({ picture: sheetAt(0, 'unlit') }, { unlit }, {}, { sun }),
      most: 0.8,
      chance: 1,
    },
    'emission times strength times texture': {
      scene: scene(
        { lamp: sheetAt(0, 'lamp') },
        { lamp: black({ emission: [0.5, 0.5, 0.5], emissionStrength: 6, emissionTexture: { texture: 'alphas' } }) },
      ),
      most: 3,
      chance: 1,
    },
  };
}

/** On WebGPU by programs for what each scene needs, on WebGL2 by one that has all features. */
export async function lightCases(backend: GpuBackend, seed: number): Promise<LightCase[]> {
  const tracer = await (backend === 'webgpu' ? tracerBy('webgpu, computed') : tracerOfAll(backend));
  const cases: LightCase[] = [];
  for (const [what, { scene: asked, most, chance }] of Object.entries(questions())) {
    const { sum } = await renderBy(tracer, asked, {
      width: SIZE,
      height: SIZE,
      samples: SAMPLES,
      firstSample: 0,
      seed,
    });
    const count = SIZE * SIZE * SAMPLES;
    const red = sum.reduce((total, x, i) => (i % 3 === 0 ? total + x : total), 0);
    const error = most * Math.sqrt((chance * (1 - chance)) / count);
    cases.push({ what, mean: red / count, expected: most * chance, error });
  }
  return cases;
}

/** Radiance of a matte sheet in the sun, whose normal map says the same everywhere; exact, and the map's normal's answer. */
export async function tiltedLight(
  backend: GpuBackend,
  texel: readonly [number, number, number],
  rotation: MeshShape['rotation'],
) {
  const map = { width: 1, height: 1, rgba: Uint8Array.of(...texel, 255) };
  const tilted = scene(
    { floor: sheetAt(0, 'floor', rotation) },
    { floor: testMaterial({ baseColor: [0.5, 0.5, 0.5], normalTexture: { texture: 'map' } }) },
    { images: { map: { data: map } }, textures: { map: { image: 'map' } } },
    { sun },
  );
  const { sum } = await renderPath(backend, tilted, { width: 4, height: 4, samples: 4, firstSample: 0, seed: 1 });
  return Array.from(sum).map((x) => x / 4);
}
