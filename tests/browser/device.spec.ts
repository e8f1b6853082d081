import { expect, test } from './fixtures.ts';

test('this Chromium has WebGPU with compute, and WebGL2', async ({ harness }) => {
  const devices = await harness.evaluate(() => window.harness.describeDevices());
  console.log(`  WebGPU: ${devices.webgpu?.adapter}\n  WebGL2: ${devices.webgl2?.renderer}`);
  expect(devices.webgpu, 'WebGPU').not.toBeNull();
  expect(devices.webgpu?.compute, 'compute on WebGPU').toBe(true);
  expect(devices.webgl2, 'WebGL2').not.toBeNull();
});
