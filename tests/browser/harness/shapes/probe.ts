/** Casts random rays at random shapes by the kernels' own functions on a GPU, and judges the answers. */
import type { Device, PassSource } from '../../../../packages/renderer/src/gpu/device.ts';
import { SCENE_TABLE, structSize, TABLE_WIDTH } from '../../../../packages/renderer/src/packed-scene/layout.ts';
import { type PackedScene, packScene } from '../../../../packages/renderer/src/packed-scene/pack-scene.ts';
import { createBlock, writeStruct } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { type PreparedAnalytic, prepareScene } from '../../../../packages/renderer/src/reference/prepare.ts';
import type { Scene } from '../../../../packages/renderer/src/scene/scene.ts';
import { ALL_SWITCHES } from '../../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import probeWgsl from '../generated/shape_probe.wgsl?raw';
import probeGlsl from '../generated/shapeProbe.glsl?raw';
import { type GpuBackend, probeDevice, probePass } from '../probe-device.ts';
import { expectation, fault } from './expectation.ts';
import { type RayCase, randomRays, randomScene, type Setting } from './ray-cases.ts';

const SIDE = 128;
const PROBE: PassSource = {
  label: 'shape probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl },
  entries: { vertex: 'fullScreen', fragment: 'shapeProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [{ block: 'Frame' }, SCENE_TABLE, { texture: 'rays' }],
  target: 'film',
  switches: ALL_SWITCHES,
};

export interface ProbeReport {
  readonly rays: number;
  readonly hits: number;
  /** Rays for which rounding leaves open whether and which side of the shape is met. */
  readonly open: number;
  readonly faults: number;
  /** The first few of them, in words. */
  readonly examples: string[];
}

/** The rays as texels: shape-probe.wesl reads them. `rows` tells where in the scene table a shape of the file lies. */
function rayTexels(rays: readonly RayCase[], rows: readonly number[]): Float32Array<ArrayBuffer> {
  const texels = new Float32Array(SIDE * SIDE * 8);
  rays.forEach((ray, k) => {
    texels.set([...ray.origin, rows[ray.shape]!, ...ray.direction, ray.rule], k * 8);
  });
  return texels;
}

/** t and normal for each ray. */
async function cast(device: Device, packed: PackedScene, texels: Float32Array<ArrayBuffer>): Promise<Float32Array> {
  const frame = device.createUniforms(structSize('Frame'));
  const block = createBlock(structSize('Frame'));
  writeStruct(block, 'Frame', 0, {
    shapeEnds: packed.shapeEnds,
    occluderEnd: packed.occluderEnd,
    rowHeight: 1 / packed.rows,
  });
  frame.write(block.bytes);
  const table = device.createTable(TABLE_WIDTH, packed.rows);
  table.write(packed.table.f32, packed.rows);
  const rays = device.createTable(2 * SIDE, SIDE);
  rays.write(texels, SIDE);
  const film = device.createFilm(SIDE, SIDE);
  const pass = await probePass(device, PROBE);
  device.draw(pass, film, [frame, table, rays], { width: SIDE, height: SIDE, firstRow: 0, rowCount: SIDE });
  const answers = await device.read(film.layers[0]!, SIDE, SIDE);
  for (const resource of [frame, table, rays, film]) resource.destroy();
  return answers;
}

/** The shapes for the reference, in the order of the file. */
function preparedShapes(scene: Scene): PreparedAnalytic[] {
  return Object.values(scene.shapes).map((shape) => {
    const { spheres, boxes, planes, quads } = prepareScene({ ...scene, shapes: { shape } });
    return [...spheres, ...boxes, ...planes, ...quads][0]!;
  });
}

/** SIDE² random rays at the random shapes of a setting. */
export async function probeShapes(backend: GpuBackend, setting: Setting): Promise<ProbeReport> {
  const scene = randomScene(setting);
  const rays = randomRays(setting, scene, SIDE * SIDE);
  const packed = packScene(scene, scene.camera.eye);
  const rows = Object.keys(scene.shapes).map((name) => packed.shapeNames.indexOf(name));
  const device = await probeDevice(backend);
  const answers = await cast(device, packed, rayTexels(rays, rows));
  const shapes = preparedShapes(scene);
  const report = { rays: rays.length, hits: 0, open: 0, faults: 0, examples: [] as string[] };
  rays.forEach((ray, k) => {
    const expected = expectation(shapes[ray.shape]!, ray, scene.camera.eye);
    const answer = Array.from(answers.subarray(4 * k, 4 * k + 4)) as [number, number, number, number];
    if (answer[0] < 1e30) report.hits++;
    if (!expected.decided) report.open++;
    const wrong = fault(expected, answer);
    if (wrong === null) return;
    report.faults++;
    const name = Object.keys(scene.shapes)[ray.shape];
    if (report.examples.length < 4)
      report.examples.push(
        `"${name}" ${wrong}: ${answer}; ray ${k} ${JSON.stringify(ray)}, ${JSON.stringify(expected)}`,
      );
  });
  return report;
}
