/** Whole frames on a GPU: packed, uploaded, one sample traced, and waited for. */
import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { FrameController } from '../../packages/renderer/src/frame-controller.ts';
import { DEFAULT_SETTINGS, openWebGpu, raysPerPixel } from '../../packages/renderer/src/headless/index.ts';
import { Motion } from '../../packages/renderer/src/scene/motion.ts';
import type { Scene } from '../../packages/renderer/src/scene/scene.ts';
import { Stages } from '../../packages/renderer/src/stages.ts';
import { median } from '../statistics.mjs';

const [WIDTH, HEIGHT] = [640, 360];
/** Frames of each kind in a round; the two kinds take turns, as machines change their pace. */
const ROUND = 20;
const ROUNDS = 10;

/** Milliseconds of each frame. `times`: of the scene. */
async function draw(stages: Stages, controller: FrameController, scene: Scene, motion: Motion, times: number[]) {
  const settings = { ...DEFAULT_SETTINGS, ...scene.render };
  const taken: number[] = [];
  for (const time of times) {
    const start = performance.now();
    const moment = motion.at(time);
    const { camera } = moment.scene;
    stages.begin({ ...moment, camera, settings, raysPerPixel: raysPerPixel(scene, settings) }, WIDTH, HEIGHT);
    await stages.addSamples(1, controller, () => {}, () => false); // biome-ignore format: one call
    taken.push(performance.now() - start);
  }
  return taken;
}

/** One row a scene: its name, frames a second of the still one and of the one that moves, and what the second is of the first. */
export async function framesASecond(scenes: ReadonlyMap<string, Scene>, step: number) {
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
    stages.film.reserve(WIDTH, HEIGHT, 2);
    const [still, moving]: [number[], number[]] = [[], []];
    for (let round = 0; round < ROUNDS; round++) {
      const times = Array.from({ length: ROUND }, (_, i) => step * (round * ROUND + i));
      const held = await draw(stages, controller, scene, motion, times.map(() => times[0]!)); // biome-ignore format: one call
      const played = await draw(stages, controller, scene, motion, times);
      // The first frames of a kind have the other's to put away.
      still.push(...held.slice(2));
      moving.push(...played.slice(2));
    }
    const [a, b] = [1000 / median(still), 1000 / median(moving)];
    rows.push([name, a.toFixed(1), b.toFixed(1), (b / a).toFixed(2)]);
  }
  const { description } = device;
  device.destroy();
  return { description: `${description}, ${WIDTH} × ${HEIGHT}, one sample a pixel and frame`, rows };
}
