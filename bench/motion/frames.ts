/** Whole frames on a GPU: packed, uploaded, one sample traced, and waited for. */
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { FrameController } from '../../packages/renderer/src/frame-controller.ts';
import { DEFAULT_SETTINGS, openWebGpu, raysPerPixel } from '../../packages/renderer/src/headless/index.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../packages/renderer/src/stages.ts';
import { median } from '../statistics.mjs';

/** Frames of each kind in a round; the two kinds take turns, as machines change their pace. */
const ROUND = 20;

export interface FrameOptions {
  /** Of a frame, pixels; it is 9/16 as high. */
  readonly width: number;
  readonly rounds: number;
  /** Of the scene's time from frame to frame, seconds. */
  readonly step: number;
}

/** Milliseconds of each frame. `times`: of the scene. */
async function draw(
  stages: Stages,
  controller: FrameController,
  scene: Scene,
  motion: Motion,
  times: number[],
  width: number,
) {
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const taken: number[] = [];
  for (const time of times) {
    const start = performance.now();
    const moment = motion.at(time);
    const { camera } = moment.scene;
    stages.begin({ ...moment, camera, settings, raysPerPixel: raysPerPixel(scene, settings) }, width, heightOf(width));
    await stages.addSamples(1, controller, () => {}, () => false); // biome-ignore format: one call
    taken.push(performance.now() - start);
  }
  return taken;
}

/** One row a scene: its name, frames a second of the still one and of the one that moves, and what the second is of the first. */
const heightOf = (width: number) => Math.round((width * 9) / 16);

export async function framesASecond(scenes: ReadonlyMap<string, Scene>, { width, rounds, step }: FrameOptions) {
  const device = await openWebGpu(null, { gpu: await dawnGpu() });
  const stages = await Stages.open(device, 'exact');
  const rows: string[][] = [];
  for (const [name, scene] of scenes) {
    const controller = new FrameController();
    controller.watched = false;
    const motion = new Motion(scene);
    const { scene: first } = motion.at(0);
    const settings = { ...DEFAULT_SETTINGS, ...scene.render };
    await stages.ready({ scene: first, camera: first.camera, settings });
    stages.film.reserve(width, heightOf(width), 2);
    const [still, moving]: [number[], number[]] = [[], []];
    for (let round = 0; round < rounds; round++) {
      const times = Array.from({ length: ROUND }, (_, i) => step * (round * ROUND + i));
      const held = await draw(stages, controller, scene, motion, times.map(() => times[0]!), width); // biome-ignore format: one call
      const played = await draw(stages, controller, scene, motion, times, width);
      // The first frames of a kind have the other's to put away.
      still.push(...held.slice(2));
      moving.push(...played.slice(2));
    }
    const [a, b] = [1000 / median(still), 1000 / median(moving)];
    rows.push([name, a.toFixed(1), b.toFixed(1), (b / a).toFixed(2)]);
  }
  const { description } = device;
  device.destroy();
  return { description: `${description}, ${width} × ${heightOf(width)}, one sample a pixel and frame`, rows };
}
