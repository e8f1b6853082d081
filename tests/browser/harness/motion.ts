/** Scenes whose meshes move, drawn by the renderer itself. */

import type { DeviceCounts } from '../../../packages/renderer/src/gpu/device.ts';
import type { GpuRenderer } from '../../../packages/renderer/src/gpu-renderer.ts';
import { createRenderer } from '../../../packages/renderer/src/renderer.ts';
import type { Scene } from '../../../packages/renderer/src/scene/scene.ts';
import { trustScene } from '../../../packages/renderer/src/scene-file/trusted-scenes.ts';
import { arm, carousel, dough, swarm } from '../../fixtures/motion.ts';
import { seededRandom } from '../../fixtures/random.ts';
import type { GpuBackend } from './parity.ts';

const SIZE = 48;
const scenes: Readonly<Record<string, Scene>> = {
  arm: arm(30, 10),
  dough: dough(30, 10),
  swarm: swarm(seededRandom(1), 60),
  carousel: carousel(seededRandom(2), 60),
};

let open: { readonly renderer: GpuRenderer; readonly backend: GpuBackend } | null = null;

/** One for all that is asked of a backend in a row: what it is asked depends on nothing before. */
async function rendererOn(backend: GpuBackend): Promise<GpuRenderer> {
  if (open?.backend === backend) return open.renderer;
  open?.renderer.dispose();
  const canvas = document.createElement('canvas');
  canvas.width = SIZE;
  canvas.height = SIZE;
  const renderer = (await createRenderer(canvas, { backend, settings: { adaptive: false } })) as GpuRenderer;
  open = { renderer, backend };
  return renderer;
}

/** Nothing of it has been shown: a scene is known by being the same object. */
async function show(renderer: GpuRenderer, scene: Scene): Promise<void> {
  renderer.stop();
  renderer.playing = false;
  const copy = { ...scene };
  trustScene(copy);
  await renderer.setScene(copy);
  renderer.set({ maxSamples: 4, adaptive: false });
}

async function filmAt(renderer: GpuRenderer, time: number): Promise<Float32Array> {
  renderer.time = time;
  await renderer.render();
  return (await renderer.readFilm()).pixels;
}

const differing = (a: Float32Array, b: Float32Array): number => a.reduce((n, x, i) => n + (x === b[i] ? 0 : 1), 0);

export interface Played {
  /** Values of the film at the end that are others when the time is gone to at once. */
  readonly unlikeDirect: number;
  /** Share of values that are others than those of the film before. */
  readonly changed: readonly number[];
  /** Before the second time, and at the end. */
  readonly counts: readonly [DeviceCounts, DeviceCounts];
}

/** A scene goes to these times, one after the other. */
export async function playedFilms(backend: GpuBackend, times: readonly number[]): Promise<Record<string, Played>> {
  const found: Record<string, Played> = {};
  const renderer = await rendererOn(backend);
  for (const [name, scene] of Object.entries(scenes)) {
    await show(renderer, scene);
    const films: Float32Array[] = [];
    let before: DeviceCounts | null = null;
    for (const time of times) {
      films.push(await filmAt(renderer, time));
      before ??= { ...renderer.device.counts };
    }
    const counts = [before!, { ...renderer.device.counts }] as const;
    await show(renderer, scene);
    const direct = await filmAt(renderer, times.at(-1)!);
    found[name] = {
      unlikeDirect: differing(films.at(-1)!, direct),
      changed: films.slice(1).map((film, i) => differing(film, films[i]!) / film.length),
      counts,
    };
  }
  return found;
}

/** Plays a scene until so many frames are drawn; the scene's times of the frames. */
export async function playFrames(backend: GpuBackend, name: string, frames: number): Promise<number[]> {
  const renderer = await rendererOn(backend);
  await show(renderer, scenes[name]!);
  await renderer.render();
  const times: number[] = [];
  renderer.playing = true;
  renderer.start();
  let last = -1;
  while (times.length < frames) {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const { time } = renderer.stats;
    if (time !== last) times.push((last = time));
  }
  renderer.stop();
  return times;
}

/** Counts the workers of the page while `work` goes on. */
async function countingWorkers<T>(
  work: () => Promise<T>,
): Promise<T & { readonly workers: number; readonly ended: number }> {
  const Plain = Worker;
  let [workers, ended] = [0, 0];
  globalThis.Worker = class extends Plain {
    constructor(...how: ConstructorParameters<typeof Worker>) {
      super(...how);
      workers++;
    }
    override terminate(): void {
      ended++;
      super.terminate();
    }
  };
  try {
    return { ...(await work()), workers, ended };
  } finally {
    globalThis.Worker = Plain;
  }
}

/**
 * Plays a scene that a worker bends until the picture is of an earlier time than the world. The values of its film that are others than
 * those of a film of that time, and workers before and after another scene comes.
 */
export const playedLate = (backend: GpuBackend) =>
  countingWorkers(async () => {
    const renderer = await rendererOn(backend);
    const scene = arm(64, 36);
    await show(renderer, scene);
    await renderer.render();
    renderer.playing = true;
    renderer.start();
    let time: number;
    do {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      ({ time } = renderer.stats);
    } while (time === 0 || time === renderer.time);
    renderer.stop();
    // What has been submitted is told of.
    for (let i = 0; i < 2; i++) {
      await renderer.device.finished();
      await new Promise((resolve) => setTimeout(resolve));
    }
    const { samples } = renderer.stats;
    ({ time } = renderer.stats);
    const played = (await renderer.readFilm()).pixels;
    renderer.playing = false;
    renderer.time = -1;
    renderer.time = time;
    for (let i = 0; i < samples; i++) await renderer.render();
    const wanted = (await renderer.readFilm()).pixels;
    await show(renderer, scenes.swarm!);
    await renderer.render();
    return { unlike: differing(played, wanted) };
  });

/** Shows one scene after the other, each for two frames. */
export async function switchMovingScenes(backend: GpuBackend, times: number): Promise<DeviceCounts> {
  const renderer = await rendererOn(backend);
  const names = Object.keys(scenes);
  for (let i = 0; i < times; i++) {
    await show(renderer, scenes[names[i % names.length]!]!);
    await filmAt(renderer, 0.1);
    await filmAt(renderer, 0.1 + (i % 7) / 10);
  }
  await show(renderer, scenes.arm!);
  await filmAt(renderer, 1);
  return { ...renderer.device.counts };
}
