/** The GPU of this machine through Dawn for Node, Chromium's WebGPU without Chromium. */
import { tmpdir } from 'node:os';
import { DeviceError, type FilmTracer, GpuFilmTracer, openWebGpu } from 'mirrorball/headless';

declare global {
  /** Dawn ends the process when this is collected while devices live. */
  var mirrorballGpu: GPU | undefined;
}

/** Dawn's `navigator.gpu`, once. Rejects with `DeviceError` when the package is not installed or does not run here. */
export async function dawnGpu(): Promise<GPU> {
  if (globalThis.mirrorballGpu) return globalThis.mirrorballGpu;
  // Vulkan drivers complain on standard error when this is not set.
  if (process.platform === 'linux') process.env.XDG_RUNTIME_DIR ??= tmpdir();
  try {
    const { create, globals } = await import('webgpu');
    Object.assign(globalThis, globals);
    globalThis.mirrorballGpu = create([]);
    return globalThis.mirrorballGpu;
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    if (code === 'ERR_MODULE_NOT_FOUND' || code === 'MODULE_NOT_FOUND')
      throw new DeviceError('the package "webgpu" (Dawn for Node) is not installed');
    throw new DeviceError(`the package "webgpu" (Dawn for Node) does not run here: ${message.split('\n')[0]}`);
  }
}

export async function openDawn(): Promise<FilmTracer> {
  return GpuFilmTracer.create(await openWebGpu(null, { gpu: await dawnGpu() }));
}
