import type { Page } from '@playwright/test';
import type { SphereLight } from '../../packages/renderer/src/scene/scene.ts';
import { backends, expect, test } from './fixtures.ts';
import { hookGpu, hooks } from './gpu-hooks.ts';
import { choose, quick, scenes, settled, unfold } from './studio.ts';

for (const backend of backends)
  test(`after start-up nothing is compiled any more (${backend})`, async ({ page, openStudio }) => {
    await hookGpu(page);
    await openStudio({ backend, query: { ...quick, size: 160, paused: 1 } });
    // The path integrator is compiled when it is first wanted; that is its start-up. Its second program, for simpler scenes, comes
    // behind the first picture.
    await choose(page, 'Scene', 'Materials');
    await settled(page);
    await choose(page, 'Scene', scenes[0]!.en);
    await choose(page, 'Method', 'Path tracing');
    await settled(page);
    await choose(page, 'Method', 'Classic ray tracing');
    const compiled = await atRest(page);
    const unchanged = async (what: string) => {
      await settled(page);
      expect((await hooks(page)).compiled, `modules, pipelines and programs after ${what}`).toBe(compiled);
    };
    expect(compiled).toBeGreaterThanOrEqual(3);

    for (const { en } of scenes) await choose(page, 'Scene', en);
    await choose(page, 'Scene', scenes[0]!.en);
    await unchanged('switching scenes');
    await everyControl(page);
    await unchanged('changing every control');
    await page.evaluate(everySetting);
    await unchanged('changing every setting by the API');
    await page.evaluate(editedScenes);
    await unchanged('editing the scene');
    for (const width of [1000, 700, 500]) await page.setViewportSize({ width, height: 600 });
    await unchanged('resizing');
  });

/** How much was compiled, once a second has passed without more. */
async function atRest(page: Page): Promise<number> {
  let [before, { compiled }] = [-1, await hooks(page)];
  while (compiled !== before) {
    before = compiled;
    await page.waitForTimeout(1000);
    compiled = (await hooks(page)).compiled;
  }
  return compiled;
}

async function everyControl(page: Page): Promise<void> {
  await unfold(page, 'Performance');
  for (const value of ['0', '3']) await page.getByRole('slider', { name: 'Reflections' }).fill(value);
  for (const value of ['9', '1']) await choose(page, 'Samples per light', value);
  await choose(page, 'Method', 'Path tracing');
  for (const value of ['2', 'No limit']) await choose(page, 'Path segments', value);
  await choose(page, 'Method', 'Classic ray tracing');
  for (const mode of ['Reflections 1 · 2 · 10', 'Light samples 1 · 9 · 64', 'Off'])
    await choose(page, 'Side by side', mode);
  await page.getByRole('slider', { name: 'Exposure' }).fill('1');
  for (const value of ['ACES', 'AgX', 'Neutral', 'None']) await choose(page, 'Tone mapping', value);
  await page.getByRole('slider', { name: 'Time' }).fill('1');
  await page.getByRole('slider', { name: 'Resolution scale' }).fill('0.5');
  await choose(page, 'Target', '30 fps');
  await page.getByRole('switch', { name: 'Lower resolution in motion when slow' }).click();
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await choose(page, 'Speed', '2×');
  await page.getByRole('button', { name: 'Pause', exact: true }).click();
}

/** Runs in the page. */
async function everySetting(): Promise<void> {
  const renderer = window.mirrorball.renderer!;
  const panel = (maxReflections: number, lightSamples: number) => ({ maxReflections, lightSamples });
  for (const settings of [
    {
      maxReflections: 64,
      lightSamples: 2,
      seed: 3,
      exposure: -1,
      toneMapping: 'agx',
      adaptive: true,
      targetFps: 30,
      maxSamples: 2,
    },
    { comparison: { panels: [panel(0, 1), panel(2, 25), panel(5, 4)], dividers: [0.2, 0.9] } },
    {
      comparison: null,
      toneMapping: 'none',
      maxReflections: 1,
      lightSamples: 1,
      resolutionScale: 0.3,
      targetFps: 60,
      adaptive: false,
    },
  ] as const) {
    renderer.set(settings as Parameters<typeof renderer.set>[0]);
    await renderer.render();
  }
}

/** Runs in the page: numbers changed, a map of the sky, and a scene with far more shapes and lights. */
async function editedScenes(): Promise<void> {
  const renderer = window.mirrorball.renderer!;
  const scene = renderer.scene!;
  const [name, light] = Object.entries(scene.lights as Record<string, SphereLight>)[0]!;
  await renderer.setScene({ ...scene, lights: { ...scene.lights, [name]: { ...light, radius: light.radius * 2 } } });
  const map = { width: 64, height: 32, data: new Float32Array(64 * 32 * 3).fill(0.5) };
  const render = { ...scene.render, integrator: 'path' } as const;
  await renderer.setScene({ ...scene, sky: { ...scene.sky, map }, render });
  const ball = (i: number) => ({ type: 'sphere', center: [i / 50, i / 40, 0], radius: 0.1 });
  const material = Object.keys(scene.materials)[0]!;
  const balls = Array.from({ length: 100 }, (_, i) => [`ball ${i}`, { ...ball(i), material }]);
  await renderer.setScene({ ...scene, animation: [], shapes: Object.fromEntries(balls) });
}
