import { backends, expect, test } from './fixtures.ts';
import { drawsAtRest, hookGpu, hooks } from './gpu-hooks.ts';
import { expectPicture, expectState, quick, rendererState, setHidden, settled, soon } from './studio.ts';

test.use({ viewport: { width: 480, height: 320 } });
for (const backend of backends)
  test.describe(`the page stays responsive (${backend})`, () => {
    test.beforeEach(({ page }) => hookGpu(page));

    // Alone: while a program is compiled on a crowded machine, a frame more may be on its way.
    test('while it starts, and never more than two frames are waited for', { tag: '@alone' }, async ({
      page,
      openStudio,
    }) => {
      await page.addInitScript(() => {
        const tasks: number[] = [];
        new PerformanceObserver((list) => {
          tasks.push(...list.getEntries().map(({ duration }) => Math.round(duration)));
        }).observe({ type: 'longtask', buffered: true });
        Object.assign(window, { longTasks: tasks });
      });
      await openStudio({ backend, query: { ...quick, size: 240, scale: 1, paused: 0 } });
      await expectPicture(page);
      await expectState(page, (state) => state.time > 0.5, true);
      const tasks = await page.evaluate(() => (window as unknown as { longTasks: number[] }).longTasks);
      console.log(`  ${backend}: tasks over 50 ms while starting: ${tasks.join(', ') || 'none'}`);
      expect((await hooks(page)).mostWaiting).toBeLessThanOrEqual(2);
    });

    test('with 64 reflections and 256 samples: short submits, and changes take hold', async ({ page, openStudio }) => {
      await openStudio({ backend, query: { ...quick, size: 160, scale: 1, paused: 1, scene: 'mirror-blocks' } });
      await settled(page);
      const longest = page.evaluate(async () => {
        const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
        const renderer = window.mirrorball.renderer!;
        await renderer.render();
        Object.assign(window.gpuHooks, { largestDraw: 0, firstDraw: 0, mostWaiting: 0 });
        renderer.set({ maxReflections: 64, lightSamples: 256 });
        let most = 0;
        for (let i = 0, before = performance.now(); i < 40; i++) {
          await frame();
          const now = performance.now();
          most = Math.max(most, now - before);
          before = now;
        }
        return most;
      });
      const milliseconds = Math.round(await longest);
      const { largestDraw, firstDraw, mostWaiting } = await hooks(page);
      console.log(
        `  ${backend}: first ${firstDraw}, at most ${largestDraw} pixels a submit, ${milliseconds} ms between frames of the page`,
      );
      // Once the cost is measured the parts may grow as far as the machine is fast.
      expect(firstDraw, 'the picture is begun with a small part').toBeLessThan((160 * 160) / 4);
      // Two of a sample, and the first of the next.
      expect(mostWaiting).toBeLessThanOrEqual(3);
      await page.evaluate(() => window.mirrorball.renderer!.set({ maxReflections: 1, lightSamples: 1 }));
      await settled(page);
    });

    test('a finished picture costs nothing more; exposure and tone mapping show it again without tracing', async ({
      page,
      openStudio,
    }) => {
      await openStudio({ backend, query: { ...quick, size: 160, paused: 1 } });
      await settled(page);
      const draws = await drawsAtRest(page);
      await expectState(page, (state) => state.stats.fps, 0);
      const before = await page.evaluate(() => window.gpuHooks.presented);
      await page.evaluate(() => window.mirrorball.renderer!.set({ exposure: -2 }));
      await soon(() => page.evaluate(() => window.gpuHooks.presented)).toBe(before + 1);
      await page.evaluate(() => window.mirrorball.renderer!.set({ toneMapping: 'aces' }));
      await soon(() => page.evaluate(() => window.gpuHooks.presented)).toBe(before + 2);
      expect((await hooks(page)).draws, 'nothing was traced').toBe(draws);
    });

    test('a hidden tab draws nothing, and goes on where it was', async ({ page, openStudio }) => {
      await openStudio({ backend, query: { ...quick, size: 160, paused: 0 } });
      await expectPicture(page);
      await setHidden(page, true);
      // A page that went on drawing would never come to rest.
      const draws = await drawsAtRest(page);
      const { time } = await rendererState(page);
      await page.waitForTimeout(100);
      expect(await drawsAtRest(page)).toBe(draws);
      expect((await rendererState(page)).time).toBe(time);
      await setHidden(page, false);
      await expectState(page, (state) => state.time > time, true);
      expect((await hooks(page)).draws).toBeGreaterThan(draws);
    });

    test('a canvas that is resized during a heavy sample is never left blank', async ({ page, openStudio }) => {
      await openStudio({ backend, query: { ...quick, scale: 1, adaptive: 0, paused: 1, scene: 'mirror-blocks' } });
      await settled(page);
      await page.evaluate(() => window.mirrorball.renderer!.set({ maxReflections: 64, lightSamples: 256 }));
      for (const width of [470, 440, 460]) {
        await page.setViewportSize({ width, height: 320 });
        await page.waitForTimeout(60);
        await expectPicture(page);
      }
    });
  });
