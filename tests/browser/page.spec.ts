import type { Page } from '@playwright/test';
import { fromInterleaved, writeNpy } from '../../packages/renderer/src/export/index.ts';
import { backends, everywhere, expect, test } from './fixtures.ts';
import {
  choose,
  coarse,
  expectChange,
  expectPicture,
  expectState,
  fewSamples,
  group,
  lookAtPicture,
  quick,
  rendererState,
  scenes,
  soon,
  unfold,
} from './studio.ts';

/** Every scene on each backend, and as each origin's; the other two pairs show that a scene comes up and moves. */
const ALL_SCENES = ['webgpu, file', 'webgl2, served'];

for (const { backend, origin } of everywhere) {
  const where = `${backend}, ${origin}`;
  const all = ALL_SCENES.includes(where);
  test(`shows ${all ? 'each of the three scenes' : 'a scene'}, moving (${where})`, async ({ page, openStudio }) => {
    await openStudio({ backend, origin, query: { ...coarse, paused: 1 } });
    await fewSamples(page);
    let look = await expectPicture(page);
    await expectState(page, (state) => state.backend, backend);
    // The first is shown already: begin with the second and come back to it.
    for (const { en } of all ? [scenes[1], scenes[2], scenes[0]] : []) {
      await choose(page, 'Scene', en);
      await expect(page.getByRole('img', { name: en })).toBeVisible();
      await expectChange(page, look, 10, `${en} looks different from the scene before`);
      look = await expectPicture(page);
    }

    const before = await lookAtPicture(page);
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await expectChange(page, before, 3, 'the scene moves');
  });
}

/** All on one page: to open it, with all that it compiles, takes longer than most controls. Each step leaves the page as it was. */
for (const backend of backends)
  test(`each control does what it says (${backend})`, async ({ page, openStudio }) => {
    test.setTimeout(180_000);
    await openStudio({ backend, query: { ...coarse, paused: 1 } });
    await fewSamples(page);
    await expectPicture(page);

    await test.step('the status line has figures', async () => {
      const status = page.getByRole('region', { name: 'Figures of the last frame' });
      await expect(status).toContainText(backend === 'webgpu' ? 'WebGPU' : 'WebGL2');
      await expect(status).toContainText(/\d+ × \d+/);
      await expect(status).toContainText(/[1-9]\d* samples/);
    });

    await test.step('light: reflections, samples, exposure', async () => {
      await page.getByRole('slider', { name: 'Reflections' }).fill('7');
      await expectState(page, (state) => state.settings.maxReflections, 7);
      await choose(page, 'Samples per light', '9');
      await expectState(page, (state) => state.settings.lightSamples, 9);
      await choose(page, 'Samples per light', 'Other');
      const samples = page.getByRole('spinbutton', { name: 'Samples per light: 1 to 256' });
      await samples.fill('5');
      await expectState(page, (state) => state.settings.lightSamples, 5);
      const told = page.getByText('Samples per light: 1 to 256');
      await samples.fill('257');
      await expect(told).toBeVisible();
      await samples.blur();
      await expect(samples).toHaveValue('5');
      await expect(told).toBeHidden();
      const before = await lookAtPicture(page);
      await page.getByRole('slider', { name: 'Exposure' }).fill('-3');
      await expectState(page, (state) => state.settings.exposure, -3);
      let look = await expectChange(page, before, 10, 'it gets darker');
      for (const [name, toneMapping] of [
        ['ACES', 'aces'],
        ['AgX', 'agx'],
        ['Neutral', 'neutral'],
        ['None', 'none'],
      ] as const) {
        await choose(page, 'Tone mapping', name);
        await expectState(page, (state) => state.settings.toneMapping, toneMapping);
        look = await expectChange(page, look, 3, `${name} looks different`);
      }
      await page.getByRole('slider', { name: 'Exposure' }).fill('0');
      await choose(page, 'Samples per light', '1');
      await page.getByRole('slider', { name: 'Reflections' }).fill('3');
    });

    if (backend === 'webgpu') await controlsOfThePage(page);
    else await controlsOfMethodAndView(page);

    // The last one: the other backend stays.
    await test.step('performance: backend, resolution, target, adaptive', async () => {
      await unfold(page, 'Performance');
      await page.getByRole('slider', { name: 'Resolution scale' }).fill('0.5');
      await expectState(page, (state) => state.settings.resolutionScale, 0.5);
      await choose(page, 'Target', '30 fps');
      await expectState(page, (state) => state.settings.targetFps, 30);
      const adaptive = page.getByRole('switch', { name: 'Lower resolution in motion when slow' });
      await adaptive.click();
      await expect(adaptive).not.toBeChecked();
      await expectState(page, (state) => state.settings.adaptive, false);
      const other = backend === 'webgpu' ? 'webgl2' : 'webgpu';
      await choose(page, 'Drawn by', other === 'webgpu' ? 'WebGPU' : 'WebGL2');
      await expectState(page, (state) => [state.backend, state.settings.resolutionScale], [other, 0.5]);
      await expectPicture(page);
    });
  });

/**
 * Controls that compile programs. On WebGPU no-recompiling.spec.ts chooses methods and path segments too, and aov.spec.ts looks at each view
 * on both canvases.
 */
async function controlsOfMethodAndView(page: Page): Promise<void> {
  await test.step('path tracing: method and path segments', async () => {
    const before = await lookAtPicture(page);
    await choose(page, 'Method', 'Path tracing');
    await expectState(page, (state) => state.settings.integrator, 'path');
    await expectChange(page, before, 3, 'another picture');
    await choose(page, 'Path segments', '2');
    await expectState(page, (state) => state.settings.maxDepth, 2);
    await expect(page.getByRole('slider', { name: 'Reflections' })).toHaveCount(0);
    await choose(page, 'Method', 'Classic ray tracing');
    await expectState(page, (state) => state.settings.integrator, 'classic');
  });

  await test.step('view: depth and shapes instead of the picture, and back', async () => {
    const menu = page.getByRole('combobox', { name: 'Show' });
    let before = await lookAtPicture(page);
    for (const [name, view] of [
      ['Depth', 'depth'],
      ['Shapes', 'primitive-id'],
      ['Picture', 'picture'],
    ] as const) {
      await menu.selectOption(name);
      await expectState(page, (state) => state.settings.view, view);
      before = await expectChange(page, before, 3, `${name} looks different`);
    }
  });
}

/** What only the page does, whatever draws: it is asked on one backend. */
async function controlsOfThePage(page: Page): Promise<void> {
  await test.step('comparison: strips with dividers that move', async () => {
    await choose(page, 'Side by side', 'Reflections 1 · 2 · 10');
    await expectState(page, (state) => state.settings.comparison?.panels.map((p) => p.maxReflections), [1, 2, 10]);
    const divider = page.getByRole('separator', { name: 'Divider 1 of 2' });
    const at = Number(await divider.getAttribute('aria-valuenow'));
    const box = (await divider.boundingBox())!;
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x - 60, box.y + box.height / 2, { steps: 3 });
    await page.mouse.up();
    await soon(async () => Number(await divider.getAttribute('aria-valuenow'))).toBeLessThan(at);
    const slider = page.getByRole('slider', { name: 'Reflections' });
    await expect(slider).toBeDisabled();
    await expect(slider).toHaveAccessibleDescription(/1 · 2 · 10/);
    await choose(page, 'Side by side', 'Light samples 1 · 9 · 64');
    await expect(slider).toBeEnabled();
    await expect(group(page, 'Samples per light')).toHaveAccessibleDescription(/1 · 9 · 64/);
    await expect(group(page, 'Samples per light').getByRole('radio').first()).toBeDisabled();
    await expectState(page, (state) => state.settings.comparison?.panels.map((p) => p.lightSamples), [1, 9, 64]);
    const show = page.getByRole('combobox', { name: 'Show' });
    await show.selectOption('Normals');
    await expectState(page, (state) => state.settings.comparison, null);
    await expect(group(page, 'Side by side')).toHaveAccessibleDescription(
      'Compares pictures: choose to show the picture first.',
    );
    await page.keyboard.press('c');
    const why = page.locator('.notice[data-subject=compare]');
    await expect(why).toBeVisible();
    await show.selectOption('Picture');
    await expect(why).toBeHidden();
    await choose(page, 'Side by side', 'Off');
    await expectState(page, (state) => state.settings.comparison, null);
  });

  await test.step('motion: play, pause, step, speed, time', async () => {
    await expectState(page, (state) => state.playing, false);
    const start = (await rendererState(page)).time;
    await page.getByRole('button', { name: 'Step 1/60 s' }).click();
    await expectState(page, (state) => Math.round((state.time - start) * 60), 1);
    await choose(page, 'Speed', '2×');
    await expectState(page, (state) => state.speed, 2);
    await page.getByRole('slider', { name: 'Time' }).fill('1');
    await expectState(page, (state) => Math.abs(state.time - 1) < 0.02, true);
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await expectState(page, (state) => state.playing && state.time > 1.1, true);
    await page.getByRole('button', { name: 'Pause', exact: true }).click();
    await expectState(page, (state) => state.playing, false);
    await choose(page, 'Speed', '1×');
  });

  await test.step('view: orbit, pan and dolly by mouse, then back', async () => {
    const eye = async () => (await rendererState(page)).camera.eye;
    const start = await eye();
    await page.mouse.move(200, 300);
    await page.mouse.down();
    await page.mouse.move(280, 330, { steps: 4 });
    await page.mouse.up();
    await soon(eye, 'a drag orbits').not.toEqual(start);
    const orbited = await eye();
    await page.mouse.wheel(0, 240);
    await soon(eye, 'the wheel dollies').not.toEqual(orbited);
    await page.getByRole('button', { name: 'Reset view' }).click();
    await soon(eye, 'the view is the scene’s again').toEqual(start);
  });
}

test('the CPU’s still picture can be chosen, and says that it is one', async ({ page, openStudio }) => {
  await page.setViewportSize({ width: 480, height: 320 });
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await page.getByRole('button', { name: 'Show controls' }).click();
  await unfold(page, 'Performance');
  await choose(page, 'Drawn by', 'CPU still');
  await expectState(page, (state) => state.backend, 'cpu');
  await expect(page.getByText('This is a still picture, computed by the CPU')).toBeVisible();
});

test('the CPU’s still picture by the address is not excused, gets finer, and does not pretend to play', async ({
  page,
  openStudio,
}) => {
  await openStudio({ query: { ...quick, backend: 'cpu', size: 64, paused: 1 } });
  await expect(page.getByText('This is a still picture, computed by the CPU')).toBeVisible();
  await expect(page.getByText('neither WebGPU nor WebGL2')).toBeHidden();
  await expectState(page, (state) => state.stats.samples, 16);
  const play = page.getByRole('button', { name: 'Play', exact: true });
  await expect(play).toBeDisabled();
  await expect(play).toHaveAccessibleDescription(/does not play/);
  await expect(group(page, 'Speed')).toHaveAccessibleDescription(/does not play/);
  await page.locator('main canvas').first().focus();
  await page.keyboard.press('Space');
  await expectState(page, (state) => state.playing, false);
  await page.getByRole('button', { name: 'Step 1/60 s' }).click();
  await expectState(page, (state) => Math.round(state.stats.time * 60), 1);
  await expectState(page, (state) => state.stats.samples, 16);
});

test('the address is taken as far as it is understood, and the rest is named', async ({ page, openStudio }) => {
  const strange = { exposure: 8, reflections: 99, colour: 'red' };
  await openStudio({ backend: 'webgl2', query: { ...coarse, ...strange, paused: 1 } });
  await fewSamples(page);
  await expect(page.getByRole('slider', { name: 'Exposure' })).toHaveValue('8');
  await expect(page.getByText('reflections=99 (0 … 64)')).toBeVisible();
  await expect(page.getByText('colour=red')).toBeVisible();
});

test('a scene file opens; a broken one lists its problems and changes nothing', async ({ page, openStudio }) => {
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  const file = (name: string, text: string) => ({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
  const input = page.locator('#scene-file');
  await input.setInputFiles(
    file('broken.json', '{ "version": 1, "shapes": { "ball": { "type": "sphere", "radius": -1 } } }'),
  );
  const dialog = page.getByRole('dialog', { name: /broken\.json/ });
  await expect(dialog).toContainText('radius');
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();
  await expect(group(page, 'Scene').getByRole('radio', { name: 'Cube room' })).toBeChecked();
});

test('a scene opens with its map of the sky when both files come together, and says so when the map is missing', async ({
  page,
  openStudio,
}) => {
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  const scene = `{ "version": 1, "name": "Under a map", "camera": { "eye": [0, 0, 5], "target": [0, 0, 0] }, "sky": { "image": "sky.npy" },
    "materials": { "grey": {} }, "shapes": { "ball": { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "grey" } } }`;
  const file = (name: string, content: string | Uint8Array) => ({
    name,
    mimeType: 'application/octet-stream',
    buffer: Buffer.from(content),
  });
  const input = page.locator('#scene-file');
  await input.setInputFiles([file('sky.json', scene)]);
  const dialog = page.getByRole('dialog', { name: /sky\.json/ });
  await expect(dialog).toContainText('did not come with it');
  await expect(dialog.getByRole('listitem')).toHaveText('sky.npy');
  await page.keyboard.press('Escape');
  const map = writeNpy(fromInterleaved(2, 1, ['R', 'G', 'B'], [1, 2, 3, 4, 5, 6]));
  await input.setInputFiles([file('sky.npy', map), file('sky.json', scene)]);
  await expect(group(page, 'Scene').getByRole('radio', { name: 'Under a map' })).toBeChecked();
});

test('prefers-reduced-motion starts paused', async ({ page, openStudio }) => {
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openStudio({ backend: 'webgl2', query: coarse });
  await expectState(page, (state) => state.playing, false);
  await expect(page.getByRole('button', { name: 'Play', exact: true })).toBeVisible();
});
