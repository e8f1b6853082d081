/** Whole frames on a GPU: packed, uploaded, one sample traced, and waited for. */
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { FrameController } from '../../packages/renderer/src/frame-controller.ts';
import type { Device } from '../../packages/renderer/src/gpu/device.ts';
import { DEFAULT_SETTINGS, openWebGpu, raysPerPixel } from '../../packages/renderer/src/headless/index.ts';
import { hasDeformables } from '../../packages/renderer/src/scene/deform.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../packages/renderer/src/stages.ts';
import { median } from '../statistics.mjs';

/** Frames of each kind in a round; the kinds take turns, as machines change their pace. */
const ROUND = 40;
/** Rounds that are not counted: engines and drivers take their time to compile. */
const WARM_UP = 10;
/** As in painter.ts. */
const MOST_IN_FLIGHT = 2;

export interface FrameOptions {
  /** Of a frame, pixels; it is 9/16 as high. */
  readonly width: number;
  readonly rounds: number;
  /** Of the scene's time from frame to frame, seconds. */
  readonly step: number;
}

/** One way to draw: on which stages, and whether time passes. */
interface Kind {
  readonly stages: Stages;
  readonly plays: boolean;
  /** Of each round: milliseconds a frame, and of these on this thread until all is submitted, the median. */
  readonly whole: number[];
  readonly thread: number[];
}

const heightOf = (width: number) => Math.round((width * 9) / 16);

/** Draws the scene at these times as a page does, with the next frame packed while the device has one. */
async function draw(
  { stages, whole, thread }: Kind,
  scene: Scene,
  motion: Motion,
  times: readonly number[],
  width: number,
) {
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const controller = new FrameController();
  controller.watched = false;
  const inFlight: Promise<boolean>[] = [];
  const own: number[] = [];
  const start = performance.now();
  for (const time of times) {
    while (stages.pending || inFlight.length >= MOST_IN_FLIGHT) await inFlight.shift();
    const begun = performance.now();
    const moment = motion.at(time);
    const { camera } = moment.scene;
    stages.begin({ ...moment, camera, settings, raysPerPixel: raysPerPixel(scene, settings) }, width, heightOf(width));
    inFlight.push(stages.addSamples(1, controller, () => {}, () => false)); // biome-ignore format: one call
    own.push(performance.now() - begun);
  }
  await Promise.all(inFlight);
  whole.push((performance.now() - start) / times.length);
  thread.push(median(own));
}

/** A device that leaves it to this thread to bend meshes. */
async function withoutKernels(): Promise<Device> {
  const device = await openWebGpu(null, { gpu: await dawnGpu() });
  return Object.defineProperty(device, 'compute', { value: null });
}

const figures = (times: readonly number[]): string[] => [Math.min(...times).toFixed(3), median(times).toFixed(3)];
/** Of rounds beside one another. */
const ratio = (a: readonly number[], b: readonly number[]): string =>
  median(a.map((time, i) => time / b[i]!)).toFixed(2);

async function measure(scene: Scene, ways: readonly Stages[], { width, rounds, step }: FrameOptions): Promise<Kind[]> {
  const motion = new Motion(scene);
  const { scene: first } = motion.at(0);
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const kindOf = (stages: Stages, plays: boolean): Kind => ({ stages, plays, whole: [], thread: [] });
  const kinds = [kindOf(ways[0]!, false), ...ways.map((stages) => kindOf(stages, true))];
  for (const stages of ways) {
    await stages.ready({ scene: first, camera: first.camera, settings });
    stages.film.reserve(width, heightOf(width), 2);
  }
  for (let round = -WARM_UP; round < rounds; round++) {
    const times = Array.from({ length: ROUND }, (_, i) => step * ((round + WARM_UP) * ROUND + i));
    const standing = times.map(() => times[0]!);
    for (const kind of kinds) await draw(kind, scene, motion, kind.plays ? times : standing, width);
    if (round < 0) for (const { whole, thread } of kinds) [whole.length, thread.length] = [0, 0];
  }
  for (const stages of ways) stages.leaveModel();
  return kinds;
}

export const FRAME_COLUMNS = [
  'scene',
  'meshes bent by',
  'still: shortest, ms',
  'median',
  'plays: shortest, ms',
  'median',
  'plays / still, median',
  'of this on the thread: still, ms',
  'plays, ms',
];

/** A row for each scene, or two: meshes bent by the device, and by this thread. Times of rounds, milliseconds a frame. */
export async function framesOnGpu(scenes: ReadonlyMap<string, Scene>, options: FrameOptions) {
  const device = await openWebGpu(null, { gpu: await dawnGpu() });
  const stages = await Stages.open(device, 'exact');
  const slow = await Stages.open(await withoutKernels(), 'exact');
  const rows: string[][] = [];
  for (const [name, scene] of scenes) {
    const bends = hasDeformables(scene);
    const [still, ...playing] = await measure(scene, bends && device.compute ? [stages, slow] : [stages], options);
    playing.forEach((kind, i) => {
      const by = bends ? (i === 0 && device.compute ? 'the device' : 'the thread') : '–';
      const thread = [still!, kind].map((of) => median(of.thread).toFixed(3));
      rows.push([
        name,
        by,
        ...figures(still!.whole),
        ...figures(kind.whole),
        ratio(kind.whole, still!.whole),
        ...thread,
      ]);
    });
  }
  const { description } = device;
  for (const { device } of [stages, slow]) device.destroy();
  const { width, rounds } = options;
  const what = `${description}, ${width} × ${heightOf(width)}, one sample a pixel and frame, ${rounds} rounds of ${ROUND} frames`;
  return { description: what, rows };
}
