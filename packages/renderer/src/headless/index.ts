/** Mirrorball without a window: `mirrorball/headless`. Sums of film samples on a GPU device or by the reference tracer. */
export { linearToSrgb, srgbToLinear } from '../display/srgb.ts';
export { type Device, DeviceError } from '../gpu/device.ts';
export { openWebGl2 } from '../gpu/webgl2/webgl2-device.ts';
export { openWebGpu } from '../gpu/webgpu/webgpu-device.ts';
export { type AovIds, aovIds } from '../integrator/aov/aov-ids.ts';
export { nearest } from '../scene-file/problem.ts';
export { DEFAULT_SETTINGS, raysPerPixel } from '../view.ts';
export * from './aovs.ts';
export * from './film-tracer.ts';
export { GpuFilmTracer } from './gpu-film-tracer.ts';
export { addReferenceSample, referenceLayers, referenceRows, type TraceRows } from './reference-film.ts';
