/** Random scenes by the path integrator: tests/fixtures/fuzz makes them, and says what is wrong with their films. */
import { GpuFilmTracer, openWebGl2, openWebGpu } from '../../../packages/renderer/src/headless/index.ts';
import { type BadScene, type FuzzKind, type FuzzReport, fuzzScenes, leastOf } from '../../fixtures/fuzz/fuzz.ts';
import type { GpuBackend } from './parity.ts';

const tracers = new Map<GpuBackend, Promise<GpuFilmTracer>>();

/** One program with all features: nothing is compiled for a scene. */
function tracerOn(backend: GpuBackend): Promise<GpuFilmTracer> {
  let tracer = tracers.get(backend);
  if (!tracer) {
    const device =
      backend === 'webgpu' ? openWebGpu(null, { computes: true }) : openWebGl2(document.createElement('canvas'));
    tracers.set(backend, (tracer = device.then((d) => GpuFilmTracer.create(d, 'one'))));
  }
  return tracer;
}

/** Traces `count` scenes from number `first` on. */
export async function fuzz(
  backend: GpuBackend,
  kind: FuzzKind,
  seed: number,
  first: number,
  count: number,
): Promise<FuzzReport> {
  return fuzzScenes(await tracerOn(backend), kind, seed, first, count);
}

export async function fuzzLeast(
  backend: GpuBackend,
  kind: FuzzKind,
  seed: number,
  index: number,
): Promise<BadScene | null> {
  return leastOf(await tracerOn(backend), kind, seed, index);
}
