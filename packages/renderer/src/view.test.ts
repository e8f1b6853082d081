import { describe, expect, test } from 'vitest';
import { swarm } from '../../../tests/fixtures/motion.ts';
import { seededRandom } from '../../../tests/fixtures/random.ts';
import { testLight, testScene } from '../../../tests/fixtures/scenes.ts';
import type { RendererSettings } from './renderer-types.ts';
import type { Scene, Shape } from './scene/scene.ts';
import { requireScene } from './scene-file/require-scene.ts';
import { trustScene } from './scene-file/trusted-scenes.ts';
import { DEFAULT_SETTINGS, View } from './view.ts';

const ball: Shape = { type: 'sphere', center: [0, 0, 0], radius: 1, material: 'white' };
const still = requireScene(testScene({ ball }, { lamp: testLight() }));
const moving = requireScene({
  ...still,
  animation: [
    {
      target: '/shapes/ball/radius',
      interpolation: 'linear',
      repeat: 'loop',
      keys: [
        { time: 0, value: 1 },
        { time: 10, value: 11 },
      ],
    },
  ],
});
function viewOf(scene: Scene, settings: Partial<RendererSettings> = {}): View {
  const view = new View(settings);
  view.setScene(requireScene(scene));
  return view;
}
/** How much each revision grows by what is done. */
function growth(view: View, act: () => void): { film: number; shown: number } {
  const { revision, shownRevision } = view;
  act();
  return { film: view.revision - revision, shown: view.shownRevision - shownRevision };
}

describe('settings', () => {
  const wrong: [string, unknown, RegExp][] = [
    ['maxReflections', 65, /whole number from 0 to 64/],
    ['maxReflections', -1, /from 0 to 64/],
    ['maxReflections', 1.5, /whole number/],
    ['lightSamples', 0, /from 1 to 256/],
    ['lightSamples', '9', /"9"/],
    ['exposure', Number.NaN, /stops/],
    ['toneMapping', 'ACES', /one of none, aces, agx, neutral/],
    ['resolutionScale', 0, /0\.1 to 1/],
    ['resolutionScale', 1.01, /0\.1 to 1/],
    ['adaptive', 1, /true or false/],
    ['targetFps', 50, /30 or 60/],
    ['maxSamples', 0, /from 1/],
    ['seed', -1, /from 0/],
    ['seed', 2 ** 32, /4294967295/],
    ['comparison', {}, /three panels/],
    ['framing', { center: [0.5, 1.5], height: 1 }, /two shares/],
    ['framing', { center: [0.5, 0.5], height: 0 }, /height from 0\.01/],
    ['comparison', { panels: [{}, {}, {}], dividers: [0, 1] }, /three panels/],
  ];
  test.each(wrong)('%s = %j is refused, with what is allowed', (key, value, message) => {
    const part = { [key]: value } as Partial<RendererSettings>;
    const view = viewOf(still);
    const before = view.settings;
    expect(() => view.set(part)).toThrow(message);
    expect(() => view.set(part)).toThrow(`"${key}"`);
    expect(view.settings).toBe(before);
    expect(() => new View(part)).toThrow(RangeError);
  });

  test('a setting that does not exist is refused, and those that do are told', () => {
    const view = viewOf(still);
    const part = { bounces: 3 } as Partial<RendererSettings>;
    expect(() => view.set(part)).toThrow(/no setting "bounces".*maxReflections/s);
  });

  test('one wrong setting keeps the good ones beside it from being taken', () => {
    const view = viewOf(still);
    expect(() => view.set({ seed: 7, lightSamples: 0 })).toThrow();
    expect(view.settings.seed).toBe(0);
  });

  test('the ends of every range are allowed', () => {
    const least = { maxReflections: 0, lightSamples: 1, resolutionScale: 0.1, maxSamples: 1, seed: 0 };
    const most = { maxReflections: 64, lightSamples: 256, resolutionScale: 1, maxSamples: 2 ** 24, seed: 2 ** 32 - 1 };
    for (const settings of [least, most]) expect(viewOf(still, {}).set(settings)).toBeUndefined();
  });

  test('a scene brings its own', () => {
    const own = { maxReflections: 7, lightSamples: 3, maxDepth: 8, exposure: -1, toneMapping: 'agx' } as const;
    const render = { integrator: 'classic', ...own } as const;
    const view = viewOf({ ...still, render }, { seed: 5, maxReflections: 1 });
    expect(view.settings).toEqual({
      ...DEFAULT_SETTINGS,
      ...own,
      seed: 5,
    });
  });
});

describe('the film is begun anew only when its content changes', () => {
  const cases: [string, (view: View) => void, { film: number; shown: number }][] = [
    ['reflections', (v) => v.set({ maxReflections: 3 }), { film: 1, shown: 1 }],
    ['the seed', (v) => v.set({ seed: 1 }), { film: 1, shown: 1 }],
    ['two at once', (v) => v.set({ seed: 1, lightSamples: 4 }), { film: 1, shown: 1 }],
    ['exposure', (v) => v.set({ exposure: 1 }), { film: 0, shown: 1 }],
    ['tone mapping', (v) => v.set({ toneMapping: 'agx' }), { film: 0, shown: 1 }],
    ['the target', (v) => v.set({ targetFps: 30 }), { film: 0, shown: 1 }],
    ['a setting that has this value', (v) => v.set({ seed: 0, exposure: 0 }), { film: 0, shown: 0 }],
    ['nothing', (v) => v.set({}), { film: 0, shown: 0 }],
    ['the time', (v) => void (v.time = 2), { film: 1, shown: 1 }],
    ['the same time', (v) => void (v.time = 0), { film: 0, shown: 0 }],
    ['the camera', (v) => void (v.camera = still.camera), { film: 1, shown: 1 }],
    ['the scene', (v) => v.setScene(still), { film: 1, shown: 1 }],
    ['time passing in a scene that stands still', (v) => v.advance(0.1), { film: 0, shown: 0 }],
  ];
  test.each(cases)('%s', (_, act, expected) => {
    const view = viewOf(still);
    expect(growth(view, () => act(view))).toEqual(expected);
  });

  test('time passing in a moving scene, not when it is paused or has no speed', () => {
    const view = viewOf(moving);
    expect(growth(view, () => view.advance(0.1)).film).toBe(1);
    expect(growth(view, () => view.advance(0)).film).toBe(0);
    view.speed = 0;
    expect(growth(view, () => view.advance(0.1)).film).toBe(0);
    view.speed = 1;
    view.playing = false;
    expect(growth(view, () => view.advance(0.1)).film).toBe(0);
    expect(view.moves).toBe(false);
  });
});

describe('time', () => {
  test('passes with its speed, also backwards, and the scene follows', () => {
    const view = viewOf(moving);
    const radius = () => (view.momentNow().scene.shapes.ball as { radius: number }).radius;
    view.advance(0.2);
    expect(radius()).toBeCloseTo(1.2, 12);
    view.speed = 3;
    view.advance(0.2);
    expect(view.time).toBeCloseTo(0.8, 12);
    view.speed = -1;
    view.advance(0.1);
    expect(view.time).toBeCloseTo(0.7, 12);
    expect(radius()).toBeCloseTo(1.7, 12);
  });

  test('a tab that slept goes on where it was', () => {
    const view = viewOf(moving);
    view.advance(3600);
    expect(view.time).toBeLessThanOrEqual(0.25);
  });

  test.each([Number.NaN, Number.POSITIVE_INFINITY])('%f is no time and no speed', (value) => {
    const view = viewOf(moving);
    expect(() => (view.time = value)).toThrow(RangeError);
    expect(() => (view.speed = value)).toThrow(RangeError);
    expect([view.time, view.speed]).toEqual([0, 1]);
  });

  test('a new scene starts at time 0 with its own camera', () => {
    const view = viewOf(moving);
    view.time = 5;
    view.camera = { ...still.camera, eye: [9, 9, 9] };
    view.setScene(still);
    expect(view.time).toBe(0);
    expect(view.camera).toEqual(still.camera);
  });
});

test('a camera may leave out its projection and lens, not have wrong ones', () => {
  const view = viewOf(still);
  const { eye, target, up, verticalFov } = still.camera;
  view.camera = { eye, target, up, verticalFov };
  for (const part of [{ projection: 'fisheye' }, { viewHeight: 0 }, { aperture: -1 }, { focusDistance: Number.NaN }])
    expect(() => (view.camera = { ...still.camera, ...part } as typeof still.camera)).toThrow(TypeError);
  expect(view.camera).toEqual({ eye, target, up, verticalFov });
});

test('what is no scene is refused and the old one stays', () => {
  const view = viewOf(still);
  const { revision, scene } = view;
  expect(() => view.setScene({ ...still, shapes: null } as unknown as Scene)).toThrow(TypeError);
  expect(view.scene).toBe(scene);
  expect(view.revision).toBe(revision);
});

test('rays per pixel: a camera ray and its mirror rays, each with a shadow ray a light sample', () => {
  const two = testScene({ ball }, { a: testLight(), b: testLight() });
  const view = viewOf(two);
  view.set({ maxReflections: 2, lightSamples: 9 });
  expect(view.raysPerPixel()).toBe(3 * (1 + 2 * 9));
  const panel = (maxReflections: number) => ({ maxReflections, lightSamples: 1 });
  view.set({ comparison: { panels: [panel(0), panel(1), panel(2)], dividers: [0.3, 0.6] } });
  expect(view.raysPerPixel()).toBe((3 + 6 + 9) / 3);
});

describe('clips', () => {
  const playing = (): View => {
    const scene = swarm(seededRandom(1), 3);
    trustScene(scene);
    return viewOf(scene);
  };

  test('move the picture as keyframes do, unless none plays', () => {
    const view = playing();
    expect(view.moves).toBe(true);
    expect(growth(view, () => view.advance(0.1))).toEqual({ film: 1, shown: 1 });
    const { clip: _, ...resting } = view.scene!;
    trustScene(resting);
    expect(viewOf(resting).moves).toBe(false);
  });

  test('what frames are made of goes with the time', () => {
    const view = playing();
    const moment = view.momentNow();
    expect(view.momentNow()).toBe(moment);
    view.advance(0.2);
    expect(view.momentNow().time).toBeCloseTo(0.2);
    expect(view.momentNow().scene, 'nothing but meshes moves').toBe(moment.scene);
  });
});
