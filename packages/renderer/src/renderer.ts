import { CpuRenderer } from './cpu-renderer.ts';
import { type Device, DeviceError } from './gpu/device.ts';
import { openWebGl2 } from './gpu/webgl2/webgl2-device.ts';
import { openWebGpu } from './gpu/webgpu/webgpu-device.ts';
import { GpuRenderer } from './gpu-renderer.ts';
import type { Backend, Renderer, RendererOptions } from './renderer-types.ts';
import { describe } from './scene-file/problem.ts';

/**
 * A renderer that draws on this canvas. The canvas's `width` and `height` are the caller's: they are read for every frame and
 * never set. A canvas serves one backend for life; for another one give a fresh canvas.
 *
 * Throws `DeviceError` when the backend that `options` name cannot be had. With 'auto' that cannot happen: without WebGPU and
 * WebGL2 the double-precision tracer makes still pictures, and `renderer.backend` says 'cpu'. Throws `TypeError` for what is no canvas
 * element, and for a backend that there is not.
 */
export async function createRenderer(canvas: HTMLCanvasElement, options: RendererOptions = {}): Promise<Renderer> {
  const wanted = options.backend ?? 'auto';
  checkArguments(canvas, wanted);
  const tries: readonly Backend[] = wanted === 'auto' ? BACKENDS : [wanted];
  const reasons: string[] = [];
  for (const backend of tries) {
    try {
      return await open(backend, canvas, options);
    } catch (error) {
      if (!(error instanceof DeviceError)) throw error;
      reasons.push(error.message);
    }
  }
  throw new DeviceError(reasons.join(' '));
}

const BACKENDS: readonly Backend[] = ['webgpu', 'webgl2', 'cpu'];

/** For programs without types. */
function checkArguments(canvas: unknown, backend: unknown): void {
  if (typeof (canvas as HTMLCanvasElement | null)?.getContext !== 'function')
    throw new TypeError(`createRenderer draws on a canvas element; it was given ${describe(canvas)}.`);
  if (backend !== 'auto' && !BACKENDS.some((known) => known === backend))
    throw new TypeError(`The backend is ${describe(backend)}; expected "auto", "webgpu", "webgl2" or "cpu".`);
}

async function open(backend: Backend, canvas: HTMLCanvasElement, options: RendererOptions): Promise<Renderer> {
  if (backend === 'cpu') return CpuRenderer.create(canvas, options);
  const device: Device = await (backend === 'webgpu' ? openWebGpu(canvas) : openWebGl2(canvas));
  return GpuRenderer.create(canvas, device, options);
}
