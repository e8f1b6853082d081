import type { Page } from '@playwright/test';
import { expect, test } from './fixtures.ts';
import { coarse, expectPicture, expectState, fewSamples, rendererState, scenes, settled, soon } from './studio.ts';

/** What the focused element is, in few words; radio buttons count by their group, as Tab stops once in each. */
function focused(page: Page): Promise<string> {
  return page.evaluate(() => {
    const element = document.activeElement;
    if (!(element instanceof HTMLElement) || element === document.body) return '';
    const fieldset = element.closest('fieldset')?.querySelector('legend');
    const label = (element as HTMLInputElement).labels?.[0];
    const name = fieldset ?? label;
    return (name?.textContent ?? element.getAttribute('aria-label') ?? element.textContent ?? '').trim();
  });
}

/** Presses Tab until the focus comes round again. */
async function tabStops(page: Page): Promise<string[]> {
  const stops: string[] = [];
  for (let i = 0; i < 60; i++) {
    await page.keyboard.press('Tab');
    const stop = await focused(page);
    if (stop !== '' && stop === stops[0] && stops.length > 5) break;
    if (stop !== '') stops.push(stop);
  }
  return stops;
}

/** All on one page: to open it takes longer than most keys. Each step leaves the page as it was, but for folded sections. */
test('all can be done by keyboard', async ({ page, openStudio }) => {
  test.setTimeout(180_000);
  await openStudio({ backend: 'webgl2', query: { ...coarse, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);

  await test.step('Tab reaches every control, and the picture', async () => {
    for (const heading of ['Performance', 'Page']) {
      await page.locator('summary', { hasText: heading }).focus();
      await page.keyboard.press('Enter');
    }
    const stops = await tabStops(page);
    const wanted = [
      'Hide controls',
      'Scene',
      'Open files…',
      'Open a folder…',
      'Reflections',
      'Samples per light',
      'Exposure',
    ];
    wanted.push('Tone mapping');
    wanted.push('Side by side', 'Play', 'Step 1/60 s', 'Time', 'Speed', 'Reset view', 'Keys and gestures');
    wanted.push('Drawn by', 'Resolution scale', 'Target', 'Lower resolution in motion when slow', 'Language', 'Theme');
    for (const name of wanted) expect(stops, `Tab reaches “${name}”`).toContain(name);
    expect(
      stops.some((stop) => stop.startsWith('Ray traced picture')),
      'Tab reaches the picture',
    ).toBe(true);
  });

  await test.step('the focus can be seen', async () => {
    await page.getByRole('button', { name: 'Reset view' }).focus();
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Tab');
    const mark = await page.evaluate(() => {
      const style = getComputedStyle(document.activeElement as Element);
      return style.outlineStyle !== 'none' || style.boxShadow !== 'none';
    });
    expect(mark).toBe(true);
  });

  await test.step('shortcuts: scenes, reflections, comparison, play, step', async () => {
    await page.locator('main canvas').first().focus();
    for (const [index, { en }] of scenes.entries()) {
      await page.keyboard.press(String(index + 1));
      await expect(page.getByRole('img', { name: en })).toBeVisible();
    }
    await page.keyboard.press('1');
    await expect(page.getByRole('img', { name: scenes[0]!.en })).toBeVisible();
    const { maxReflections } = (await rendererState(page)).settings;
    await page.keyboard.press(']');
    await expectState(page, (state) => state.settings.maxReflections, maxReflections + 1);
    await page.keyboard.press('[');
    await expectState(page, (state) => state.settings.maxReflections, maxReflections);
    await page.keyboard.press('c');
    await expectState(page, (state) => state.settings.comparison !== null, true);
    await page.keyboard.press('c');
    await page.keyboard.press('c');
    await expectState(page, (state) => state.settings.comparison, null);
    const { time } = await rendererState(page);
    await page.keyboard.press('.');
    await expectState(page, (state) => Math.round((state.time - time) * 60), 1);
    await page.keyboard.press('Space');
    await expectState(page, (state) => state.playing, true);
    await page.keyboard.press('Space');
    await expectState(page, (state) => state.playing, false);
  });

  await test.step('the view moves by keys and comes back', async () => {
    await page.locator('main canvas').first().focus();
    const camera = async () => (await rendererState(page)).camera;
    const start = await camera();
    for (const key of ['ArrowLeft', 'Shift+ArrowUp', '+']) {
      const before = await camera();
      await page.keyboard.press(key, { delay: 150 });
      await soon(camera, `${key} moves the view`).not.toEqual(before);
    }
    // What was pressed may glide on for a moment.
    await settled(page);
    await page.keyboard.press('r');
    await soon(async () => (await camera()).eye).toEqual(start.eye);
  });

  await test.step('the panel and the list of keys open and close', async () => {
    await page.locator('main canvas').first().focus();
    await page.keyboard.press('p');
    await expect(page.getByRole('slider', { name: 'Reflections' })).toBeHidden();
    await page.keyboard.press('p');
    await expect(page.getByRole('slider', { name: 'Reflections' })).toBeVisible();
    await page.keyboard.press('h');
    const help = page.getByRole('dialog', { name: 'Keys and gestures' });
    await expect(help).toBeVisible();
    await page.keyboard.press('Escape');
    await expect(help).toBeHidden();
  });

  await test.step('comparison dividers move by arrow keys', async () => {
    await page.locator('main canvas').first().focus();
    await page.keyboard.press('c');
    const divider = page.getByRole('separator', { name: 'Divider 1 of 2' });
    const at = Number(await divider.getAttribute('aria-valuenow'));
    await divider.focus();
    for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowLeft');
    await soon(async () => Number(await divider.getAttribute('aria-valuenow'))).toBeLessThan(at);
    await page.keyboard.press('c');
    await page.keyboard.press('c');
    await expectState(page, (state) => state.settings.comparison, null);
  });
});
