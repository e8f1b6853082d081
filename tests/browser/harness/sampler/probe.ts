/** Draws random numbers by the kernels' own functions on a GPU, and compares them with those of the CPU. */
import type { PassSource } from '../../../../packages/renderer/src/gpu/device.ts';
import { structSize } from '../../../../packages/renderer/src/packed-scene/layout.ts';
import {
  PIXEL_FILTERS,
  type PixelFilter,
  packFilter,
} from '../../../../packages/renderer/src/packed-scene/pack-filter.ts';
import { createBlock, writeStruct } from '../../../../packages/renderer/src/packed-scene/write-struct.ts';
import { filterOffset } from '../../../../packages/renderer/src/reference/filter.ts';
import { Sampler } from '../../../../packages/renderer/src/reference/sampler.ts';
import { ALL_SWITCHES } from '../../../../packages/renderer/src/shading/features.ts';
import fullScreenWgsl from '../../../../packages/renderer/src/shading/generated/full_screen.wgsl?raw';
import fullScreenGlsl from '../../../../packages/renderer/src/shading/generated/fullScreen.glsl?raw';
import probeWgsl from '../generated/sampler_probe.wgsl?raw';
import probeGlsl from '../generated/samplerProbe.glsl?raw';
import { type GpuBackend, probeDevice, probePass } from '../probe-device.ts';

const SIDE = 64;
const PROBE: PassSource = {
  label: 'sampler probe',
  wgsl: { vertex: fullScreenWgsl, fragment: probeWgsl },
  entries: { vertex: 'fullScreen', fragment: 'samplerProbe' },
  glsl: { vertex: fullScreenGlsl, fragment: probeGlsl },
  bindings: [{ block: 'Frame' }],
  target: 'film',
  switches: ALL_SWITCHES,
};

/** What sampler-probe.wesl is asked for. */
export interface Order {
  /** Groups of dimensions left out before. */
  readonly groups: number;
  /** Numbers drawn at once; 0: an offset under the pixel filter. */
  readonly dimensions: 0 | 1 | 2 | 3;
  readonly sample: number;
  readonly seed: number;
  /** Of the film's first pixel. */
  readonly corner: readonly [number, number];
  readonly independent: boolean;
  readonly filter: PixelFilter;
}

/** Hard cases: large numbers, ends of ranges, all kinds. */
function orders(): Order[] {
  const samples = [0, 1, 2, 5, 63, 255, 4095, 65535, 65536, 2 ** 20 + 3, 2 ** 32 - 1];
  const corners = [
    [0, 0],
    [1000, 7],
    [4095, 65535],
  ] as const;
  const draws = samples.flatMap((sample, k) =>
    ([1, 2, 3] as const).map(
      (dimensions): Order => ({
        groups: [0, 1, 40, 511][(k + dimensions) % 4]!,
        dimensions,
        sample,
        seed: [0, 7, 2 ** 31, 2 ** 32 - 1][k % 4]!,
        corner: corners[k % 3]!,
        independent: k % 3 === 1,
        filter: 'box',
      }),
    ),
  );
  const filters = PIXEL_FILTERS.map((filter): Order => ({ ...draws[1]!, dimensions: 0, filter }));
  return [...draws, ...filters];
}

function expected(order: Order, x: number, y: number): readonly number[] {
  const kind = order.independent ? 'independent' : 'sobol';
  const [left, top] = order.corner;
  const sampler = new Sampler(left + x, top + y, order.sample, order.seed, kind).skip(order.groups);
  if (order.dimensions === 0) return filterOffset(order.filter, sampler.next2d());
  return [() => [sampler.next1d()], () => sampler.next2d(), () => sampler.next3d()][order.dimensions - 1]!();
}

export interface SamplerReport {
  readonly numbers: number;
  /** Of the filters' offsets, pixels. */
  readonly largestDifference: number;
  /** Random numbers that are not those of the CPU to the last bit: the first few, in words. */
  readonly faults: string[];
}

export async function probeSampler(backend: GpuBackend): Promise<SamplerReport> {
  const device = await probeDevice(backend);
  const frame = device.createUniforms(structSize('Frame'));
  const block = createBlock(structSize('Frame'));
  const film = device.createFilm(SIDE, SIDE);
  const pass = await probePass(device, PROBE);
  const report = { numbers: 0, largestDifference: 0, faults: [] as string[] };
  for (const order of orders()) {
    writeStruct(block, 'Frame', 0, {
      sampleIndex: order.sample,
      seed: order.seed,
      independent: order.independent ? 1 : 0,
      filterPieces: packFilter(order.filter),
      panels: [order.groups, order.dimensions, ...order.corner],
    });
    frame.write(block.bytes);
    device.draw(pass, film, [frame], { width: SIDE, height: SIDE, firstRow: 0, rowCount: SIDE });
    const answers = await device.read(film.layers[0]!, SIDE, SIDE);
    for (let pixel = 0; pixel < SIDE * SIDE; pixel++)
      expected(order, pixel % SIDE, Math.floor(pixel / SIDE)).forEach((value, d) => {
        const answer = answers[4 * pixel + d]!;
        report.numbers++;
        if (order.dimensions === 0)
          report.largestDifference = Math.max(report.largestDifference, Math.abs(answer - value));
        else if (answer !== value && report.faults.length < 4)
          report.faults.push(`${answer} for ${value}: pixel ${pixel}, number ${d} of ${JSON.stringify(order)}`);
      });
  }
  for (const resource of [frame, film]) resource.destroy();
  return report;
}
