import { describeDevices } from './devices.ts';
import { parity, pictureOf } from './parity.ts';
import { probeShapes } from './shapes/probe.ts';

/**
 * What specs call inside the browser: `page.evaluate((size) => window.harness.something(size), 64)`.
 * Arguments and results go through JSON-like copying, so results are plain objects and ordinary arrays.
 */
export const harness = { describeDevices, parity, pictureOf, probeShapes };

declare global {
  interface Window {
    harness: typeof harness;
  }
}
window.harness = harness;
