import { expect, test, vi } from 'vitest';
import { type Device, DeviceError, type Pass } from '../../gpu/device.ts';
import { COMMON_FEATURES, FEATURES, type Feature, PLAIN_MODEL_FEATURES } from '../../shading/features.ts';
import { isRelay } from './path.ts';
import { PathPrograms, type ProgramPlan } from './path-programs.ts';

/** On whatever machine. */
const LONG = { timeout: 60_000 };

/** A device whose programs are ready when they are let be. */
function slowDevice(pays: boolean) {
  const waiting: (() => void)[] = [];
  const passes: string[] = [];
  const createPass = ({ label }: { label: string }) => {
    passes.push(label);
    return new Promise<Pass>((resolve) => {
      if (label === 'path') waiting.push(() => resolve({ label, addsMany: false }));
      else resolve({ label, addsMany: false });
    });
  };
  const device = { createPass, relay: { pays, createPass } } as unknown as Device;
  const compileNext = async () => (await vi.waitUntil(() => waiting.shift(), LONG))();
  return { device, passes, compileNext };
}

const RELAY = ['path, begin', 'path, trace', 'path, light', 'path, scatter', 'path, end'];
const model: ReadonlySet<Feature> = new Set([...PLAIN_MODEL_FEATURES, 'hasTextures', 'hasEnvironment'] as const);

test('a page whose compiler is slow draws a model by several passes until the whole program is there', async () => {
  const { device, passes, compileNext } = slowDevice(true);
  const programs = new PathPrograms(device, 'three');
  await programs.ready(model);
  expect(passes).toEqual(RELAY);
  expect(isRelay(programs.get(model)!)).toBe(true);
  await compileNext();
  await vi.waitUntil(() => !isRelay(programs.get(model)!), LONG);
  expect(passes).toEqual([...RELAY, 'path']);
});

test('the first scene of such a page comes before the programs of others', async () => {
  const { device, passes, compileNext } = slowDevice(true);
  const programs = new PathPrograms(device, 'three');
  await programs.ready(new Set(['hasSpheres', 'hasQuads', 'hasQuadLights']));
  for (let i = 0; i < 3; i++) await compileNext();
  // The scene's, whole; the common one, which is short; the one of all shapes, and whole.
  expect(passes).toEqual([...RELAY, 'path', 'path', ...RELAY, 'path']);
});

test('a driver that refuses a pass of several gets the whole program', async () => {
  const { device, passes, compileNext } = slowDevice(true);
  Object.assign(device.relay!, { createPass: () => Promise.reject(new DeviceError('Too many outputs.')) });
  const programs = new PathPrograms(device, 'three');
  const ready = programs.ready(model);
  await compileNext();
  await ready;
  expect(passes).toEqual(['path']);
  expect(isRelay(programs.get(model)!)).toBe(false);
});

const whole: readonly [string, boolean, ProgramPlan, Iterable<Feature>][] = [
  ['a short program of shapes', true, 'three', COMMON_FEATURES],
  ['a short program of meshes', true, 'three', PLAIN_MODEL_FEATURES],
  ['a model where compilers are quick', false, 'three', model],
  ['a film without a window', true, 'exact', model],
  ['many films without a window', true, 'one', FEATURES],
];
for (const [what, pays, plan, features] of whole)
  test(`${what} is drawn by one pass`, async () => {
    const { device, passes, compileNext } = slowDevice(pays);
    const programs = new PathPrograms(device, plan);
    const needs = new Set(features);
    const ready = programs.ready(needs);
    await compileNext();
    await ready;
    expect(passes[0]).toBe('path');
    expect(isRelay(programs.get(needs)!)).toBe(false);
  });
