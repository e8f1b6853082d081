/** Tracers that all tests share: a program is compiled once for all scenes that need the same of it. */
import { GpuFilmTracer, openWebGpu } from '../../../packages/renderer/src/headless/index.ts';
import { type GpuBackend, probeDevice } from './probe-device.ts';

/** WebGPU twice: passes that draw, and those that compute. A software adapter would draw; the compute entry needs proof too. */
export type Entry = 'webgpu, drawn' | 'webgpu, computed' | 'webgl2';

const tracers = new Map<Entry, Promise<GpuFilmTracer>>();

export function tracerBy(entry: Entry): Promise<GpuFilmTracer> {
  let tracer = tracers.get(entry);
  if (!tracer) {
    const device =
      entry === 'webgpu, computed'
        ? openWebGpu(null, { computes: true })
        : probeDevice(entry === 'webgl2' ? 'webgl2' : 'webgpu');
    tracers.set(entry, (tracer = device.then((d) => GpuFilmTracer.create(d))));
  }
  return tracer;
}

const ofAll = new Map<GpuBackend, Promise<GpuFilmTracer>>();

/** With one program that has all features: nothing is compiled for a scene. On WebGPU it computes. */
export function tracerOfAll(backend: GpuBackend): Promise<GpuFilmTracer> {
  let tracer = ofAll.get(backend);
  if (!tracer) {
    const device = backend === 'webgpu' ? openWebGpu(null, { computes: true }) : probeDevice(backend);
    ofAll.set(backend, (tracer = device.then((d) => GpuFilmTracer.create(d, 'one'))));
  }
  return tracer;
}

/** What a device that is opened without further wishes gives: in software it draws. */
export const tracerOn = (backend: GpuBackend): Promise<GpuFilmTracer> =>
  tracerBy(backend === 'webgpu' ? 'webgpu, drawn' : 'webgl2');
