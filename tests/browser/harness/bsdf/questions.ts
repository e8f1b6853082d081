/** What the kernels' BSDF is asked, and asking it on a GPU. */
import type { Device, PassSource } from '../../../../packages/renderer/src/gpu/device.ts';
import {
  SCENE_TABLE,
  structSize,
  TABLE_WIDTH,
  tableColumn,
} from '../../../../packages/renderer/src/packed-scene/layout.ts';
import { type Block, createBlock, writeStruct } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { isSmooth } from '../../../../packages/renderer/src/reference/bsdf/bsdf.ts';
import { type BsdfSurface, grey, mapColor } from '../../../../packages/renderer/src/reference/bsdf/surface.ts';
import type { Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { ALL_SWITCHES, SHAPE_FEATURES, switchesFor } from '../../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import probeWgsl from '../generated/bsdf_probe.wgsl?raw';
import probeGlsl from '../generated/bsdfProbe.glsl?raw';
import { probePass } from '../probe-device.ts';

/** As bsdf-probe.wesl numbers them. */
export const ASKED = { evaluation: 0, sampledDirection: 1, sampledWeight: 2 } as const;

export interface Question {
  /** Index of the surface. */
  readonly surface: number;
  readonly wo: Vec3;
  /** wi, or random numbers. */
  readonly second: Vec3;
  readonly asked: (typeof ASKED)[keyof typeof ASKED];
  /** Colour that the path goes on with: 0 white, 1 red, 2 green, 3 blue. */
  readonly hero?: number;
}
export type Answer = readonly [number, number, number, number];

const PROBE: PassSource = {
  label: 'BSDF probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl },
  entries: { vertex: 'fullScreen', fragment: 'bsdfProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [{ block: 'Frame' }, SCENE_TABLE, { texture: 'questions' }],
  target: 'film',
};
/** Questions in a row of the film. */
const WIDTH = 256;

/** All numbers as the scene table holds them. */
export const inFloats = (s: BsdfSurface): BsdfSurface => ({
  ...s,
  baseColor: mapColor(s.baseColor, Math.fround),
  eta: mapColor(s.eta, Math.fround),
  k: mapColor(s.k, Math.fround),
  reflectivity: Math.fround(s.reflectivity),
  metallic: Math.fround(s.metallic),
  alpha: Math.fround(s.alpha),
  ior: Math.fround(s.ior),
});
export const floatVector = ([x, y, z]: Vec3): Vec3 => [Math.fround(x), Math.fround(y), Math.fround(z)];

const KINDS = ['diffuse', 'metallicRoughness', 'conductor', 'dielectric'];

function surfaceTable(surfaces: readonly BsdfSurface[]) {
  const rowBytes = TABLE_WIDTH * 16;
  const block = createBlock(rowBytes * surfaces.length);
  surfaces.forEach((s, row) => {
    writeStruct(block, 'Surface', row * rowBytes + tableColumn('Surface') * 16, {
      baseColor: s.baseColor,
      code:
        KINDS.indexOf(s.type) +
        (s.thin ? 4 : 0) +
        (s.energyCompensation ? 8 : 0) +
        (isSmooth(s) ? 32 : 0) +
        (s.masking === 'separable' ? 64 : 0),
      reflectivity: s.reflectivity,
      // Of metallicRoughness it says where its layers are: there are none.
      eta: s.type === 'dielectric' ? grey(s.ior) : s.type === 'conductor' ? s.eta : grey(0),
      alpha: s.alpha,
      k: s.k,
      metallic: s.metallic,
    });
  });
  return block;
}

/** By a program without layers: one with layers samples metallicRoughness as the stack that it then is. */
export const ask = (device: Device, surfaces: readonly BsdfSurface[], questions: readonly Question[]) =>
  askTable(device, { rows: surfaceTable(surfaces) }, questions, switchesFor(SHAPE_FEATURES));

/** Rows of the scene table, each with a Surface; a question's `surface` is the number of its row. */
export interface SurfaceTable {
  readonly rows: Block;
  /** Normal of each one's coat in the frame of its base. */
  readonly coats?: readonly Vec3[];
}

/** Texels of a question. */
const TEXELS = 3;

export async function askTable(
  device: Device,
  { rows: scene, coats }: SurfaceTable,
  questions: readonly Question[],
  switches: PassSource['switches'] = ALL_SWITCHES,
): Promise<Answer[]> {
  const rows = scene.f32.length / (4 * TABLE_WIDTH);
  const height = Math.ceil(questions.length / WIDTH);
  const texels = new Float32Array(WIDTH * height * 4 * TEXELS);
  questions.forEach(({ surface, wo, second, asked, hero = 0 }, k) => {
    const coat = coats?.[surface] ?? [0, 0, 1];
    texels.set([...wo, surface, ...second, asked + 3 * hero, ...coat, 0], k * 4 * TEXELS);
  });
  const frame = device.createUniforms(structSize('Frame'));
  // As where there are lights: the direction of a question is the one to a light.
  const values = createBlock(structSize('Frame'));
  writeStruct(values, 'Frame', 0, { emitterCount: 1, rowHeight: 1 / rows });
  frame.write(values.bytes);
  const table = device.createTable(TABLE_WIDTH, rows);
  table.write(scene.f32, rows);
  const asked = device.createTable(TEXELS * WIDTH, height);
  asked.write(texels, height);
  const film = device.createFilm(WIDTH, height);
  const pass = await probePass(device, { ...PROBE, switches });
  device.draw(pass, film, [frame, table, asked], { width: WIDTH, height, firstRow: 0, rowCount: height });
  const all = await device.read(film.layers[0]!, WIDTH, height);
  for (const resource of [frame, table, asked, film]) resource.destroy();
  return questions.map((_, k) => Array.from(all.subarray(4 * k, 4 * k + 4)) as unknown as Answer);
}
