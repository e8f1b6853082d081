/** Whole frames on a GPU: packed, uploaded, one sample traced, and waited for. */
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { FrameController } from '../../packages/renderer/src/frame-controller.ts';
import { DEFAULT_SETTINGS, openWebGpu, raysPerPixel } from '../../packages/renderer/src/headless/index.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../packages/renderer/src/stages.ts';
import { median } from '../statistics.mjs';

/** Frames of each kind in a round; the two kinds take turns, as machines change their pace. */
const ROUND = 40;
/** As in painter.ts. */
const MOST_IN_FLIGHT = 2;

export interface FrameOptions {
  /** Of a frame, pixels; it is 9/16 as high. */
  readonly width: number;
  readonly rounds: number;
  /** Of the scene's time from frame to frame, seconds. */
  readonly step: number;
}

/** Draws these times of the scene as a page does, with the next frame packed while the device has one; gives milliseconds a frame. */
async function draw(stages: Stages, scene: Scene, motion: Motion, times: readonly number[], width: number) {
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const controller = new FrameController();
  controller.watched = false;
  const inFlight: Promise<boolean>[] = [];
  const start = performance.now();
  for (const time of times) {
    while (stages.pending || inFlight.length >= MOST_IN_FLIGHT) await inFlight.shift();
    const moment = motion.at(time);
    const { camera } = moment.scene;
    stages.begin({ ...moment, camera, settings, raysPerPixel: raysPerPixel(scene, settings) }, width, heightOf(width));
    inFlight.push(stages.addSamples(1, controller, () => {}, () => false)); // biome-ignore format: one call
  }
  await Promise.all(inFlight);
  return (performance.now() - start) / times.length;
}

const heightOf = (width: number) => Math.round((width * 9) / 16);

/** One row a scene: its name, milliseconds of a frame of the still one and of the one that moves, and the difference. */
export async function framesOnGpu(scenes: ReadonlyMap<string, Scene>, { width, rounds, step }: FrameOptions) {
  const device = await openWebGpu(null, { gpu: await dawnGpu() });
  const stages = await Stages.open(device, 'exact');
  const rows: string[][] = [];
  for (const [name, scene] of scenes) {
    const motion = new Motion(scene);
    const { scene: first } = motion.at(0);
    const settings = { ...DEFAULT_SETTINGS, ...scene.render };
    await stages.ready({ scene: first, camera: first.camera, settings });
    stages.film.reserve(width, heightOf(width), 2);
    const [still, moving]: [number[], number[]] = [[], []];
    for (let round = 0; round < rounds; round++) {
      const times = Array.from({ length: ROUND }, (_, i) => step * (round * ROUND + i));
      const standing = times.map(() => times[0]!);
      still.push(await draw(stages, scene, motion, standing, width));
      moving.push(await draw(stages, scene, motion, times, width));
    }
    const [a, b] = [median(still), median(moving)];
    rows.push([name, a.toFixed(2), b.toFixed(2), (b - a).toFixed(2)]);
  }
  const { description } = device;
  device.destroy();
  return { description: `${description}, ${width} × ${heightOf(width)}, one sample a pixel and frame`, rows };
}
