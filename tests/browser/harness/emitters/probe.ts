/** Asks the kernels' own light sampling on a GPU, question by question. */
import { GeometryBuffer } from '../../../../packages/renderer/src/geometry-buffer.ts';
import { type Device, type Pass, type PassSource, shareOfRow } from '../../../../packages/renderer/src/gpu/device.ts';
import { loadGeometryPacker } from '../../../../packages/renderer/src/packed-scene/geometry-packer.ts';
import {
  GEOMETRY,
  SCENE_TABLE,
  structSize,
  TABLE_WIDTH,
  TEXELS,
} from '../../../../packages/renderer/src/packed-scene/layout.ts';
import type { PackedEnvironment } from '../../../../packages/renderer/src/packed-scene/pack-environment.ts';
import { packFrame } from '../../../../packages/renderer/src/packed-scene/pack-frame.ts';
import type { PackedGeometry } from '../../../../packages/renderer/src/packed-scene/pack-geometry.ts';
import { packPathScene } from '../../../../packages/renderer/src/packed-scene/pack-path-scene.ts';
import { createBlock, writeStruct } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { stillMoment } from '../../../../packages/renderer/src/scene/motion.ts';
import type { Scene, Vec3 } from '../../../../packages/renderer/src/scene/scene.ts';
import { ALL_SWITCHES } from '../../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import { DEFAULT_SETTINGS } from '../../../../packages/renderer/src/view.ts';
import probeWgsl from '../generated/emitter_probe.wgsl?raw';
import sampledWgsl from '../generated/emitter_probe_sampled.wgsl?raw';
import probeGlsl from '../generated/emitterProbe.glsl?raw';
import { type GpuBackend, probeDevice, probePass } from '../probe-device.ts';

export type { GpuBackend };

/** What is asked: emitter-probe.wesl has the same numbers. */
export const ASK = {
  directionAndPdf: 0,
  radianceAndDistance: 1,
  pdfOfSample: 2,
  pdfOfDirection: 3,
  choice: 4,
} as const;

export interface Question {
  readonly ask: (typeof ASK)[keyof typeof ASK];
  readonly emitter: number;
  /** From the eye. */
  readonly point: Vec3;
  readonly u: readonly [number, number];
  /** Direction of `pdfOfDirection`, normal of `choice`. */
  readonly vector?: Vec3;
}
export type Answer = readonly [number, number, number, number];

/** Questions are drawn as a square picture. */
const SIDE = 128;
export const MOST_QUESTIONS = SIDE * SIDE;

const PROBE: PassSource = {
  label: 'emitter probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl, sampled: sampledWgsl },
  entries: { vertex: 'fullScreen', fragment: 'emitterProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [
    { block: 'Frame' },
    SCENE_TABLE,
    { texture: 'questions' },
    { texture: 'unused' },
    { texture: 'environment' },
    GEOMETRY,
    TEXELS,
  ],
  target: 'film',
  switches: ALL_SWITCHES,
};

interface PackedLights {
  readonly table: Float32Array<ArrayBuffer>;
  readonly rows: number;
  readonly frame: ArrayBuffer;
  readonly environment: PackedEnvironment;
  readonly geometry: PackedGeometry;
}

function packLights(scene: Scene): PackedLights {
  const packed = packPathScene(stillMoment(scene), scene.camera.eye);
  const block = createBlock(structSize('Frame'));
  const settings = { ...DEFAULT_SETTINGS, seed: 0 };
  packFrame(block, { width: SIDE, height: SIDE }, scene.camera, packed, settings, 0);
  writeStruct(block, 'Frame', 0, { rowHeight: 1 / packed.rows, geometryShare: shareOfRow(packed.geometry!) });
  return {
    table: packed.table.f32,
    rows: packed.rows,
    frame: block.bytes,
    environment: packed.environment!,
    geometry: packed.geometry!,
  };
}

function questionTexels(questions: readonly Question[]): Float32Array<ArrayBuffer> {
  const texels = new Float32Array(SIDE * SIDE * 12);
  questions.forEach(({ ask, emitter, point, u, vector = [0, 0, 1] }, k) => {
    texels.set([...point, emitter, ...u, 0, ask, ...vector, 0], k * 12);
  });
  return texels;
}

/** One GPU with the probe ready. */
export class EmitterProbe {
  readonly #device: Device;
  readonly #pass: Pass;
  private constructor(device: Device, pass: Pass) {
    this.#device = device;
    this.#pass = pass;
  }

  static async open(backend: GpuBackend): Promise<EmitterProbe> {
    const device = await probeDevice(backend);
    await loadGeometryPacker();
    return new EmitterProbe(device, await probePass(device, PROBE));
  }

  async ask(scene: Scene, questions: readonly Question[]): Promise<Answer[]> {
    if (questions.length > MOST_QUESTIONS) throw new RangeError(`At most ${MOST_QUESTIONS} questions.`);
    const device = this.#device;
    const packed = packLights(scene);
    const frame = device.createUniforms(structSize('Frame'));
    frame.write(packed.frame);
    const table = device.createTable(TABLE_WIDTH, packed.rows);
    table.write(packed.table, packed.rows);
    const { environment } = packed;
    const map = device.createTable(environment.width, environment.rows);
    map.write(environment.texels, environment.rows);
    const geometry = new GeometryBuffer(device);
    geometry.hold(packed.geometry);
    const texels = device.createData(1, 'textures');
    const asked = device.createTable(3 * SIDE, SIDE);
    asked.write(questionTexels(questions), SIDE);
    const film = device.createFilm(SIDE, SIDE);
    device.draw(this.#pass, film, [frame, table, asked, asked, map, geometry.buffer, texels], {
      width: SIDE,
      height: SIDE,
      firstRow: 0,
      rowCount: SIDE,
    });
    const values = await device.read(film.layers[0]!, SIDE, SIDE);
    for (const resource of [frame, table, asked, map, film, geometry.buffer, texels]) resource.destroy();
    return questions.map((_, k) => Array.from(values.subarray(4 * k, 4 * k + 4)) as unknown as Answer);
  }
}

/** Does the work with the probe of the backend. */
export async function withProbe<T>(backend: GpuBackend, work: (probe: EmitterProbe) => Promise<T>): Promise<T> {
  return work(await EmitterProbe.open(backend));
}

export const rounded = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];

/** For scenes whose points are relative to the eye as they are. */
export const eyeAtOrigin = {
  camera: { eye: [0, 0, 0], target: [0, 0, -1], up: [0, 1, 0], verticalFov: 60 },
} as const;
