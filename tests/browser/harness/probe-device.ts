/**
 * One device on each backend for all that is asked of the kernels' own functions, and each program that answers compiled once for all
 * questions: to compile it takes longer than most answers.
 */
import type { Device, Pass, PassSource } from '../../../packages/renderer/src/gpu/device.ts';
import { openWebGl2 } from '../../../packages/renderer/src/gpu/webgl2/webgl2-device.ts';
import { openWebGpu } from '../../../packages/renderer/src/gpu/webgpu/webgpu-device.ts';
import type { GpuBackend } from './parity.ts';

export type { GpuBackend };

const devices = new Map<GpuBackend, Promise<Device>>();

/** Whoever makes something on it destroys that; the device stays. */
export function probeDevice(backend: GpuBackend): Promise<Device> {
  let device = devices.get(backend);
  if (!device) {
    device = backend === 'webgpu' ? openWebGpu(null) : openWebGl2(document.createElement('canvas'));
    devices.set(backend, device);
  }
  return device;
}

const passes = new WeakMap<Device, Map<string, Promise<Pass>>>();

/** Sources with the same label are the same but for their switches. */
export function probePass(device: Device, source: PassSource): Promise<Pass> {
  const made = passes.get(device) ?? new Map<string, Promise<Pass>>();
  passes.set(device, made);
  const key = JSON.stringify([source.label, source.switches]);
  const pass = made.get(key) ?? device.createPass(source);
  made.set(key, pass);
  return pass;
}
