import type { Page } from '@playwright/test';
import type { Device } from '../../packages/renderer/src/gpu/device.ts';
import { backends, expect, test } from './fixtures.ts';
import { drawsAtRest, hookGpu, hooks } from './gpu-hooks.ts';
import { expectPicture, quick, rendererState, setHidden, settled, soon } from './studio.ts';

/** Milliseconds from the loss to the picture, the median of some: one slow one may be the machine's. */
const RECOVERY_MS = 2000;
const LOSSES = 5;
/** Few pixels: what is looked at here is life and death. */
const small = { ...quick, size: 160, paused: 1 };
test.use({ viewport: { width: 480, height: 320 } });

/** All that a loss must leave as it was, down to the film's last pixel. */
async function whatIsShown(page: Page) {
  const { backend, settings, camera, time, stats } = await rendererState(page);
  const scene = await page.getByRole('img').first().getAttribute('aria-label');
  const film = await page.evaluate(async () => Array.from((await window.mirrorball.renderer!.readFilm()).pixels));
  return { backend, settings, camera, time, scene, samples: stats.samples, film };
}

for (const backend of backends) {
  test.describe(`a lost device (${backend})`, () => {
    test.beforeEach(({ page }) => hookGpu(page));

    test('the same picture is back within two seconds, time and again', { tag: '@alone' }, async ({
      page,
      openStudio,
    }) => {
      await openStudio({ backend, query: { ...small, time: 1.3, exposure: 0.5, scene: 'mirror-blocks' } });
      await expectPicture(page);
      const eye = async () => (await rendererState(page)).camera.eye;
      const start = await eye();
      await page.mouse.wheel(0, 120);
      await soon(eye, 'the wheel dollies').not.toEqual(start);
      await settled(page);
      const before = await whatIsShown(page);
      const times: number[] = [];
      for (let i = 0; i < LOSSES; i++) {
        times.push(await page.evaluate(() => window.gpuHooks.loseAndTime()));
        await settled(page);
        expect(await whatIsShown(page), `after loss ${i + 1}`).toEqual(before);
      }
      await expect(page.getByText('The graphics device was lost')).toBeHidden();
      console.log(`  ${backend}: back after ${times.map((ms) => Math.round(ms)).join(', ')} ms`);
      expect(times.sort((a, b) => a - b)[LOSSES >> 1]).toBeLessThanOrEqual(RECOVERY_MS);
    });

    // 1: while the renderer is being made; 3: the integrator, behind the first picture's display and preview.
    for (const nth of [1, 3])
      test(`while compiling program ${nth}`, async ({ page, openStudio }) => {
        await page.addInitScript((n) => {
          window.gpuHooks.loseAtCompile = n;
        }, nth);
        await openStudio({ backend, query: small });
        await settled(page);
        await expectPicture(page);
        expect((await rendererState(page)).backend).toBe(backend);
        expect(await page.evaluate(() => window.gpuHooks.loseAtCompile), 'it was lost').toBe(0);
      });

    test('while hidden', async ({ page, openStudio }) => {
      await openStudio({ backend, query: small });
      await settled(page);
      const before = await whatIsShown(page);
      await setHidden(page, true);
      await page.evaluate(() => window.gpuHooks.lose());
      await page.waitForTimeout(500);
      // A page that went on drawing would never come to rest.
      const draws = await drawsAtRest(page);
      await setHidden(page, false);
      await soon(async () => (await hooks(page)).draws).toBeGreaterThan(draws);
      await settled(page);
      await expectPicture(page);
      expect(await whatIsShown(page)).toEqual(before);
    });

    test('while a heavy sample is half submitted', async ({ page, openStudio }) => {
      await openStudio({
        backend,
        query: { ...small, scale: 1, reflections: 64, samples: 64, scene: 'mirror-blocks' },
      });
      await settled(page);
      await page.evaluate(() => {
        const { renderer } = window.mirrorball;
        renderer!.time = 2;
        return new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      });
      await page.evaluate(() => window.gpuHooks.loseAndTime());
      await settled(page);
      expect((await rendererState(page)).time).toBe(2);
    });
  });

  test(`200 scene switches leave nothing behind (${backend})`, async ({ page, openStudio }) => {
    await hookGpu(page);
    await openStudio({ backend, query: { ...small, size: 64 } });
    await settled(page);
    // So many that the browser has compiled what it is going to.
    await switchScenes(page, 60);
    const before = await footprint(page);
    await switchScenes(page, 200);
    const after = await footprint(page);
    console.log(`  ${backend}: ${JSON.stringify(before)} → ${JSON.stringify(after)}`);
    const { heap, ...counts } = before;
    expect(after).toMatchObject(counts);
    expect(after.heap - heap, 'growth of the JS heap, bytes').toBeLessThan(500_000);
    await expectPicture(page);
  });
}

/** Chooses the scenes in turn by the panel's radio buttons; the next one comes before or after the one before is drawn. */
async function switchScenes(page: Page, times: number): Promise<void> {
  await page.evaluate(async (n) => {
    const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
    for (let i = 1; i <= n; i++) {
      document.querySelectorAll<HTMLInputElement>('#section-scene input[type=radio]')[i % 3]!.click();
      for (let frames = i % 5; frames >= 0; frames--) await frame();
    }
  }, times);
  await settled(page);
}

async function footprint(page: Page) {
  const devtools = await page.context().newCDPSession(page);
  for (let i = 0; i < 3; i++) await devtools.send('HeapProfiler.collectGarbage');
  const { usedSize } = await devtools.send('Runtime.getHeapUsage');
  await devtools.detach();
  const { buffers, textures, compiled } = await hooks(page);
  const counts = await page.evaluate(() => (window.mirrorball.renderer as unknown as { device: Device }).device.counts);
  return { heap: usedSize, buffers, textures, compiled, counts };
}

/** A browser keeps 16 contexts and takes the oldest away. */
test('20 backend switches leave no context behind', async ({ page, openStudio }) => {
  const warnings: string[] = [];
  page.on('console', (message) => message.type() === 'warning' && warnings.push(message.text()));
  await openStudio({ backend: 'webgl2', query: { ...small, size: 64 } });
  await settled(page);
  await page.evaluate(async () => {
    const radios = document.querySelectorAll<HTMLInputElement>('#section-quality input[type=radio][value]');
    for (let i = 0; i < 20; i++) {
      const wanted = i % 2 === 0 ? 'webgpu' : 'webgl2';
      radios[i % 2]!.click();
      while (window.mirrorball.renderer?.backend !== wanted) await new Promise((resolve) => setTimeout(resolve, 10));
    }
  });
  await settled(page);
  expect(await page.locator('main canvas').count(), 'canvases').toBe(1);
  expect(warnings.filter((text) => /context|WebGL/i.test(text))).toEqual([]);
});
