/** Runs in Chromium's page: a tracer on the browser's WebGPU, or its WebGL2, spoken to through `window.mirrorballPage`. */

import { DeviceError, type FilmJob, type FilmSums, GpuFilmTracer, openWebGl2, openWebGpu } from 'mirrorball/headless';
import { type ArrayKind, attach, createArray, type NumberArray } from './job-content.ts';

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

/** Tells at once, and then not until a while has passed. */
function seldom(tell: (number: number) => Promise<void>): (number: number) => void {
  let told = -Infinity;
  return (number) => {
    if (performance.now() - told < TELL_EVERY) return;
    told = performance.now();
    void tell(number);
  };
}

async function trace({ first, count, onto, stopped }: PageTask): Promise<string> {
  running = new AbortController();
  if (stopped) running.abort();
  const onProgress = seldom((samples) => window.mirrorballProgress(samples));
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

const bytesOf = (text: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
const fromBase64 = (text: string): FilmSums => new Float32Array(bytesOf(text).buffer);

/** Large parts of scenes, which come before the job that uses them, and the lists of numbers of the one that is coming. */
const contents = new Map<number, object>();
let arrays: NumberArray[] = [];

interface OpenedContent {
  readonly number: number;
  readonly frame: object;
  readonly arrays: readonly { readonly kind: ArrayKind; readonly length: number }[];
}

function openContent({ number, frame, arrays: sizes }: OpenedContent): void {
  arrays = sizes.map(({ kind, length }) => createArray(kind, length));
  contents.set(number, attach(frame, (index) => arrays[index]!)); // biome-ignore format: short
}

function addToContent({ index, first, numbers }: { index: number; first: number; numbers: string }): void {
  const array = arrays[index]!;
  new Uint8Array(array.buffer).set(bytesOf(numbers), first * array.BYTES_PER_ELEMENT);
}

function forget(numbers: readonly number[]): void {
  for (const number of numbers) contents.delete(number);
}

const begin = (job: FilmJob): Promise<void> =>
  tracer!.begin(
    attach(job, (number) => contents.get(number)!),
    { onProgress: seldom((share) => window.mirrorballBuilt(share)) },
  );

const mirrorballPage = { open, openContent, addToContent, forget, begin, trace, stop: () => running.abort() };

declare global {
  interface Window {
    mirrorballPage: typeof mirrorballPage;
    mirrorballProgress: (samples: number) => Promise<void>;
    mirrorballBuilt: (share: number) => Promise<void>;
  }
}
window.mirrorballPage = mirrorballPage;
