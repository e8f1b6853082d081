import { expect, test } from 'vitest';
import { readParameters } from './url-parameters.ts';

const scenes = ['cube-room', 'mirror-blocks'];

test('an empty address leaves everything open and shows the controls', () => {
  const { ui, problems, unknown, ...rest } = readParameters('', scenes);
  expect(ui).toBe(true);
  expect([...problems, ...unknown]).toEqual([]);
  expect(Object.values(rest).every((value) => value === null)).toBe(true);
});

test('every parameter is read', () => {
  const address =
    '?scene=mirror-blocks&backend=webgl2&size=512&reflections=10&samples=9&exposure=-0.5&tone=agx&integrator=path&depth=8&aperture=0.02&focus=3.5&view=normal&compare=samples&time=1.3&paused=1&lang=zh&ui=0&scale=0.5&adaptive=0&seed=1';
  expect(readParameters(address, scenes)).toEqual({
    scene: 'mirror-blocks',
    backend: 'webgl2',
    size: 512,
    reflections: 10,
    samples: 9,
    exposure: -0.5,
    tone: 'agx',
    integrator: 'path',
    depth: 8,
    aperture: 0.02,
    focus: 3.5,
    view: 'normal',
    compare: 'samples',
    time: 1.3,
    paused: true,
    lang: 'zh',
    ui: false,
    scale: 0.5,
    adaptive: false,
    seed: 1,
    problems: [],
    unknown: [],
  });
});

test('what cannot be understood is left out and named', () => {
  const parameters = readParameters(
    '?scene=nope&reflections=65&samples=2.5&time=&scale=NaN&paused=yes&aperture=-1&focus=1e10',
    scenes,
  );
  expect(parameters).toMatchObject({ scene: null, reflections: null, samples: null, time: null, scale: null });
  expect(parameters.problems).toEqual([
    'scene=nope (cube-room, mirror-blocks)',
    'aperture=-1 (0 … 1000000000)',
    'focus=1e10 (0 … 1000000000)',
    'reflections=65 (0 … 64)',
    'samples=2.5 (1 … 256)',
    'time= (0 … 1000000)',
    'paused=yes (0, 1)',
    'scale=NaN (0.1 … 1)',
  ]);
});

test('what stands there twice counts once, and is named', () => {
  const { reflections, unknown } = readParameters('?reflections=3&seed=1&reflections=9&seed=1', scenes);
  expect([reflections, unknown]).toEqual([3, ['reflections=9', 'seed=1']]);
});

test('parameters that there are not are named, and not without end', () => {
  expect(readParameters('?reflection=10&scene=nope&size', scenes).unknown).toEqual(['reflection=10']);
  const many = Array.from({ length: 1000 }, (_, k) => `x${k}=${'y'.repeat(100)}`).join('&');
  expect(readParameters(many, scenes).unknown.join().length).toBeLessThan(400);
});
