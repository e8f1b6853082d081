/** Textures looked up by the kernels' own function, held against a lookup in double precision. */
import { type PassSource, shareOfRow } from '../../../../packages/renderer/src/gpu/device.ts';
import { GEOMETRY, geometryRows, structSize, TEXELS } from '../../../../packages/renderer/src/packed-scene/layout.ts';
import { packTextures } from '../../../../packages/renderer/src/packed-scene/pack-textures.ts';
import { createBlock, writeStruct } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { lookUp, prepareTexture } from '../../../../packages/renderer/src/reference/texture.ts';
import type { Material, Scene } from '../../../../packages/renderer/src/scene/scene.ts';
import {
  type ImagePixels,
  type Texture,
  type TextureUse,
  textureTransform,
} from '../../../../packages/renderer/src/scene/textures.ts';
import { ALL_SWITCHES } from '../../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import { TexelBuffer } from '../../../../packages/renderer/src/texel-buffer.ts';
import { between, pick, type Random, seededRandom } from '../../../fixtures/random.ts';
import { testMaterial, testScene } from '../../../fixtures/scenes.ts';
import probeWgsl from '../generated/texture_probe.wgsl?raw';
import sampledWgsl from '../generated/texture_probe_sampled.wgsl?raw';
import probeGlsl from '../generated/textureProbe.glsl?raw';
import { type GpuBackend, probeDevice, probePass } from '../probe-device.ts';

const PROBE: PassSource = {
  label: 'texture probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl, sampled: sampledWgsl },
  entries: { vertex: 'fullScreen', fragment: 'textureProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [
    { block: 'Frame' },
    { texture: 'questions' },
    // Not asked; they stand where the kernels have others.
    { texture: 'previousFilm' },
    { texture: 'previousSquares' },
    { texture: 'environment' },
    GEOMETRY,
    TEXELS,
  ],
  target: 'film',
  switches: ALL_SWITCHES,
};

const SIZES = [
  [1, 1],
  [1, 7],
  [5, 3],
  [16, 16],
  [33, 17],
] as const;
const WRAPS = ['repeat', 'clamp', 'mirror'] as const;
const QUESTIONS = 64;

function randomImage(random: Random, width: number, height: number): ImagePixels {
  const bytes = Uint8Array.from({ length: 4 * width * height + 3 }, () => Math.floor(256 * random()));
  // Some that do not begin at a word.
  const rgba = random() < 0.5 ? bytes.subarray(0, -3) : bytes.subarray(3);
  return { width, height, rgba };
}

interface Case {
  readonly material: Material;
  readonly use: TextureUse;
  readonly isColor: boolean;
}

/** Every pair of wraps and both filters, for each size of image. */
function randomCases(random: Random): { scene: Scene; cases: Case[] } {
  const images: Record<string, { data: ImagePixels }> = {};
  const textures: Record<string, Texture> = {};
  const cases: Case[] = [];
  for (const [width, height] of SIZES) {
    const image = `${width} × ${height}`;
    images[image] = { data: randomImage(random, width, height) };
    for (const wrapU of WRAPS)
      for (const wrapV of WRAPS)
        for (const filter of ['linear', 'nearest'] as const) {
          const texture = `${image} ${wrapU} ${wrapV} ${filter}`;
          textures[texture] = { image, wrapU, wrapV, filter };
          const moved = {
            offset: [between(random, -2, 2), between(random, -2, 2)],
            rotation: between(random, -180, 180),
            scale: [between(random, -3, 3), between(random, -3, 3)],
          } as const;
          const use: TextureUse = {
            texture,
            ...pick(random, [{}, moved]),
            ...pick(random, [{}, { uvSet: 1 as const }]),
          };
          const isColor = random() < 0.5;
          const type = 'metallicRoughness';
          const part = isColor
            ? ({ type, baseColorTexture: use } as const)
            : ({ type, metallicRoughnessTexture: use } as const);
          cases.push({ material: testMaterial(part), use, isColor });
        }
  }
  return { scene: { ...testScene({}, {}), images, textures }, cases };
}

/** How far rounding may move coordinates, in texels of an image with so many along a side. */
const roundingOf = (terms: readonly number[], size: number): number =>
  size * 2 ** -21 * (1 + terms.reduce((sum, x) => sum + Math.abs(x), 0));

export async function probeLookups(backend: GpuBackend, seed: number) {
  const random = seededRandom(seed);
  const { scene, cases } = randomCases(random);
  const { textures, rowOf } = packTextures(
    scene,
    cases.map(({ material }) => material),
  );
  const device = await probeDevice(backend);
  const texels = new TexelBuffer(device);
  texels.hold(textures);
  const questions = new Float32Array(cases.length * QUESTIONS * 4);
  cases.forEach(({ material }, c) => {
    for (let k = 0; k < QUESTIONS; k++) {
      const at = 4 * (c * QUESTIONS + k);
      questions.set(
        [between(random, -3, 3), between(random, -3, 3), rowOf.get(material)! + geometryRows('MaterialTextures'), 0],
        at,
      );
    }
  });
  const frame = device.createUniforms(structSize('Frame'));
  const block = createBlock(structSize('Frame'));
  writeStruct(block, 'Frame', 0, { texelShare: shareOfRow(texels.buffer) });
  frame.write(block.bytes);
  const asked = device.createTable(QUESTIONS, cases.length);
  asked.write(questions, cases.length);
  const film = device.createFilm(QUESTIONS, cases.length);
  const pass = await probePass(device, PROBE);
  device.draw(pass, film, [frame, asked, asked, asked, asked, texels.buffer, texels.buffer], {
    width: QUESTIONS,
    height: cases.length,
    firstRow: 0,
    rowCount: cases.length,
  });
  const answers = await device.read(film.layers[0]!, QUESTIONS, cases.length);
  for (const resource of [frame, asked, film, texels.buffer]) resource.destroy();
  return judge(scene, cases, questions, answers);
}

function judge(scene: Scene, cases: readonly Case[], questions: Float32Array, answers: Float32Array) {
  const examples: string[] = [];
  let faults = 0;
  let open = 0;
  cases.forEach(({ use, isColor }, c) => {
    const prepared = prepareTexture(scene, use, isColor);
    const { width, height } = prepared.pixels;
    const { offset = [0, 0], scale = [1, 1] } = use;
    for (let k = 0; k < QUESTIONS; k++) {
      const at = 4 * (c * QUESTIONS + k);
      const uv = [questions[at]!, questions[at + 1]!] as const;
      const terms = [scale[0] * uv[0], scale[1] * uv[1], ...offset];
      const [errorU, errorV] = [roundingOf(terms, width), roundingOf(terms, height)];
      const [u, v] = textureTransform(use)(...uv);
      const beside = (x: number) => Math.abs(x - Math.round(x));
      if (prepared.texture.filter === 'nearest' && (beside(u * width) < errorU || beside(v * height) < errorV)) {
        open++;
        continue;
      }
      const expected = lookUp(prepared, uv);
      const tolerance = 1e-5 + (prepared.texture.filter === 'nearest' ? 0 : errorU + errorV);
      const got = Array.from(answers.subarray(at, at + 4));
      if (got.every((x, i) => Math.abs(x - expected[i]!) <= tolerance)) continue;
      faults++;
      if (examples.length < 4) examples.push(`${use.texture} at ${uv}: ${got} instead of ${expected} ± ${tolerance}`);
    }
  });
  return { asked: cases.length * QUESTIONS, open, faults, examples };
}
