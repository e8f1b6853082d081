import { builtInScenes } from 'mirrorball/built-in';
import { DeviceError } from 'mirrorball/headless';
import { expect, test } from 'vitest';
import type { RenderOptions } from './arguments.ts';
import { areaOf, inParts, settingsOf, wantedOf } from './render-request.ts';

const size = { width: 64, height: 40 };
const scene = builtInScenes[0]!.scene;
const options = (given: Partial<RenderOptions>) => ({ seed: 3, ...given }) as RenderOptions;

test('a region or pixel must lie in the picture', () => {
  expect(areaOf({ size })).toEqual({ x: 0, y: 0, width: 64, height: 40 });
  expect(areaOf({ size, pixel: { x: 63, y: 39 } })).toEqual({ x: 63, y: 39, width: 1, height: 1 });
  expect(areaOf({ size, region: { x: 60, y: 0, width: 4, height: 40 } }).x).toBe(60);
  expect(() => areaOf({ size, pixel: { x: 64, y: 0 } })).toThrow(
    'The pixel 64,0 lies outside: the picture has 64 × 40',
  );
  expect(() => areaOf({ size, region: { x: 60, y: 0, width: 5, height: 1 } })).toThrow(
    'The region 60,0,5,1 reaches outside, to 65,1: the picture has 64 × 40 pixels',
  );
  expect(() => areaOf({ size, region: { x: 0, y: 40, width: 5, height: 1 } })).toThrow(
    'The region 0,40,5,1 lies outside:',
  );
});

test('a film too large for the device can be had in parts; other errors have no such remedy', () => {
  const limits = { available: 8192, needed: 20_000 };
  expect(inParts(new DeviceError('', { limit: 'maxTextureSize', ...limits }))).toContain('--region');
  expect([new DeviceError('', { limit: 'maxBufferSize', ...limits }), new Error('')].map(inParts)).toEqual(['', '']);
});

test('which samples', () => {
  expect(wantedOf({})).toEqual({ first: 0, last: 63 });
  expect(wantedOf({ spp: 5 })).toEqual({ first: 0, last: 4 });
  expect(wantedOf({ samples: { first: 8, last: 9 } })).toEqual({ first: 8, last: 9 });
  expect(wantedOf({ untilTime: 5 }).last).toBeGreaterThan(1e6 / 2);
  expect(() => wantedOf({ spp: 5, samples: { first: 0, last: 9 } })).toThrow('cannot both be given');
});

test("the scene's settings where none are given, and no setting that would be ignored", () => {
  const { maxReflections, lightSamples } = scene.render;
  expect(settingsOf(scene, options({}))).toMatchObject({
    integrator: 'classic',
    maxReflections,
    lightSamples,
    seed: 3,
  });
  expect(settingsOf(scene, options({ lightSamples: 4 }))).toMatchObject({ maxReflections, lightSamples: 4 });
  expect(() => settingsOf(scene, options({ maxDepth: 3 }))).toThrow(
    '--max-depth means nothing to the integrator "classic"',
  );
});

test('paths on the CPU are refused before anything is opened', () => {
  const paths = builtInScenes.find(({ id }) => id === 'materials')!.scene;
  expect(() => settingsOf(scene, options({ integrator: 'path', backend: 'cpu' }))).toThrow(
    'the classic integrator only. Say',
  );
  expect(() => settingsOf(paths, options({ backend: 'cpu' }))).toThrow(
    'and this scene asks for paths. Say --integrator classic',
  );
  expect(settingsOf(paths, options({ integrator: 'classic', backend: 'cpu' })).integrator).toBe('classic');
});
