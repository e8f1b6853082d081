import { dawnGpu } from '../../packages/cli/src/backends/webgpu.ts';
import { GpuFilmTracer, openWebGpu } from '../../packages/renderer/src/headless/index.ts';
import { fuzzScenes, leastOf } from '../../tests/fixtures/fuzz/fuzz.ts';

/** One program with all features; the compute entry, also where the adapter is software. */
export async function openDawnTracer() {
  const device = await openWebGpu(null, { gpu: await dawnGpu(), computes: true });
  return { tracer: await GpuFilmTracer.create(device, 'one'), fuzzScenes, leastOf };
}
