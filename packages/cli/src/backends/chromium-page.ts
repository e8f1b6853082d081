/** Runs in Chromium's page: a tracer on the browser's WebGPU, or its WebGL2, spoken to through `window.mirrorballPage`. */

import { DeviceError, type FilmJob, type FilmSums, GpuFilmTracer, openWebGl2, openWebGpu } from 'mirrorball/headless';
import type { EnvironmentMap } from 'mirrorball/scene';

/** Floats travel as base64 of their bytes. */
export interface PageTask {
  readonly first: number;
  readonly count: number;
  readonly onto: string | null;
  readonly stopped: boolean;
}

/** Progress is told at most so often, milliseconds. */
const TELL_EVERY = 100;

let tracer: GpuFilmTracer | null = null;
let running = new AbortController();
let told = 0;

async function open(): Promise<string> {
  const reasons: string[] = [];
  const ways = [() => openWebGpu(null), () => openWebGl2(document.createElement('canvas'))];
  for (const way of ways) {
    try {
      const device = await way();
      tracer = await GpuFilmTracer.create(device);
      return `${device.backend === 'webgpu' ? 'WebGPU' : 'WebGL2'}, ${tracer.description}`;
    } catch (error) {
      if (!(error instanceof DeviceError)) throw error;
      reasons.push(error.message);
    }
  }
  throw new Error(reasons.join(' '));
}

async function trace({ first, count, onto, stopped }: PageTask): Promise<string> {
  running = new AbortController();
  if (stopped) running.abort();
  const onProgress = (samples: number) => {
    if (performance.now() - told < TELL_EVERY) return;
    told = performance.now();
    void window.mirrorballProgress(samples);
  };
  return toBase64(
    await tracer!.trace(first, count, onto === null ? null : fromBase64(onto), { signal: running.signal, onProgress }),
  );
}

function toBase64(sums: FilmSums): string {
  const bytes = new Uint8Array(sums.buffer);
  let text = '';
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(text);
}

const fromBase64 = (text: string): FilmSums =>
  new Float32Array(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer);

/** The sky's map, which comes in pieces before the job that uses it. */
let map: EnvironmentMap | null = null;

function openMap({ width, height }: { width: number; height: number }): void {
  map = { width, height, data: new Float32Array(width * height * 3) };
}

function addToMap({ first, floats }: { first: number; floats: string }): void {
  map!.data.set(fromBase64(floats), first);
}

/** A scene that names an image has the map that was sent last. */
function begin(job: FilmJob): Promise<void> {
  const { sky } = job.scene;
  const scene = sky.image !== undefined && map ? { ...job.scene, sky: { ...sky, map } } : job.scene;
  return tracer!.begin({ ...job, scene });
}

const mirrorballPage = { open, openMap, addToMap, begin, trace, stop: () => running.abort() };

declare global {
  interface Window {
    mirrorballPage: typeof mirrorballPage;
    mirrorballProgress: (samples: number) => Promise<void>;
  }
}
window.mirrorballPage = mirrorballPage;
