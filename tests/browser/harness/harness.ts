import { chiSquareSamples, probeEdges, probeEvaluation, probeSamples } from './bsdf/probe.ts';
import { compileAll } from './compile.ts';
import { describeDevices } from './devices.ts';
import { hardNames, hardPicture, leaks, movedPicture } from './hard-pictures.ts';
import { parity, pictureOf } from './parity.ts';
import { shadeMean } from './shade-mean.ts';
import { probeShapes } from './shapes/probe.ts';

/**
 * What specs call inside the browser: `page.evaluate((size) => window.harness.something(size), 64)`.
 * Arguments and results go through JSON-like copying, so results are plain objects and ordinary arrays.
 */
export const harness = {
  describeDevices,
  hardNames,
  hardPicture,
  leaks,
  movedPicture,
  parity,
  pictureOf,
  probeShapes,
  shadeMean,
  compileAll,
  chiSquareSamples,
  probeEdges,
  probeEvaluation,
  probeSamples,
};

declare global {
  interface Window {
    harness: typeof harness;
  }
}
window.harness = harness;
