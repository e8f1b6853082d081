import { seriousProblems } from './axe.ts';
import { expect, test } from './fixtures.ts';
import { choose, coarse, expectPicture, fewSamples, group, rendererState, scenes, soon, unfold } from './studio.ts';

const address = { backend: 'webgl2', query: { ...coarse, paused: 1 } } as const;

for (const colorScheme of ['light', 'dark'] as const) {
  test(`axe finds no serious problem (${colorScheme})`, async ({ page, openStudio }) => {
    await page.emulateMedia({ colorScheme });
    await openStudio(address);
    await fewSamples(page);
    await expectPicture(page);
    for (const section of ['Performance', 'Page']) await unfold(page, section);
    await choose(page, 'Side by side', 'Reflections 1 · 2 · 10');
    expect(await seriousProblems(page)).toEqual([]);
    await page.getByRole('button', { name: 'Keys and gestures' }).click();
    await expect(page.getByRole('dialog', { name: 'Keys and gestures' })).toBeVisible();
    expect(await seriousProblems(page), 'with the list of keys open').toEqual([]);
  });
}

test.describe('in Chinese', () => {
  test.use({ locale: 'zh-CN' });
  test('all is said in Chinese, until another language is chosen', async ({ page, openStudio }) => {
    await openStudio(address);
    await fewSamples(page);
    await expectPicture(page);
    await test.step('what is wrong with a scene file is said in Chinese, and once', async () => {
      const buffer = Buffer.from(JSON.stringify({ version: 1, name: 'x', camera: { eye: [0, 1, 5], target: 7 } }));
      await page.locator('#scene-file').setInputFiles({ name: 'x.json', mimeType: 'application/json', buffer });
      const dialog = page.getByRole('dialog', { name: '无法打开 x.json' });
      await expect(dialog).toContainText('在 /camera/target 处：值为 7，应为由三个数组成的列表');
      for (const problem of await dialog.getByRole('listitem').all())
        expect((await problem.innerText()).match(/应为/g), 'what is allowed is told once').toHaveLength(1);
      await page.keyboard.press('Escape');
      await expect(dialog).toBeHidden();
    });

    await test.step('nothing but names is left in English', async () => {
      for (const section of ['性能', '页面']) await unfold(page, section);
      const text = await page.getByRole('complementary').innerText();
      const words = text.match(/[A-Za-z]{3,}/g) ?? [];
      const names = ['Mirrorball', 'WebGPU', 'WebGL', 'CPU', 'English', 'json', 'scene', 'fps', 'ACES', 'AgX'];
      names.push('glTF', 'GLB', 'OBJ', 'PLY', 'STL', 'zip', 'hdr', 'exr');
      expect(words.filter((word) => !names.includes(word))).toEqual([]);
    });

    await test.step('the browser’s language is taken, and can be changed', async () => {
      await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN');
      await expect(page.getByRole('slider', { name: '反射次数' })).toBeVisible();
      for (const { zh } of scenes) {
        await choose(page, '场景', zh);
        await expect(page.getByRole('img', { name: zh })).toBeVisible();
      }
      await choose(page, '场景', scenes[0]!.zh);
      expect(await seriousProblems(page)).toEqual([]);
      await unfold(page, '页面');
      // The group is renamed by the click itself.
      await group(page, '语言').getByRole('radio', { name: 'English', exact: true }).click();
      await expect(page.locator('html')).toHaveAttribute('lang', 'en');
      await expect(page.getByRole('slider', { name: 'Reflections' })).toBeVisible();
      await page.reload();
      await expect(page.getByRole('slider', { name: 'Reflections' }), 'the choice is remembered').toBeVisible();
    });
  });
});

test.describe('on a phone on its side', () => {
  test.use({ viewport: { width: 780, height: 390 }, hasTouch: true, isMobile: true, locale: 'zh-CN' });

  test('the panel is folded at first, and the figures stay in one line beside it', async ({ page, openStudio }) => {
    await openStudio(address);
    await fewSamples(page);
    await expectPicture(page);
    await expect(page.getByRole('slider', { name: '反射次数' })).toBeHidden();
    const status = page.getByRole('region', { name: '上一帧的渲染数据' });
    const folded = (await status.boundingBox())!.height;
    await page.getByRole('button', { name: '展开面板' }).tap();
    await expect(page.getByRole('slider', { name: '反射次数' })).toBeInViewport();
    const box = (await status.boundingBox())!;
    expect(box.height).toBe(folded);
    expect(box.height).toBeLessThan(36);
    const inside = await status.evaluate((element) => element.scrollWidth <= element.clientWidth);
    expect(inside, 'nothing is cut off').toBe(true);
  });
});

test.describe('on a phone', () => {
  test.use({ viewport: { width: 390, height: 700 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });

  test('the panel folds away, everything fits, and a finger orbits', async ({ page, openStudio }) => {
    await openStudio(address);
    await fewSamples(page);
    await expectPicture(page);
    await test.step('the panel folds away, opens by touch, and everything fits', async () => {
      const slider = page.getByRole('slider', { name: 'Reflections' });
      await expect(slider, 'the panel is folded at first').toBeHidden();
      await page.getByRole('button', { name: 'Show controls' }).tap();
      await expect(slider).toBeInViewport();
      await group(page, 'Scene').getByRole('radio', { name: 'Mirror blocks' }).tap();
      await expect(page.getByRole('img', { name: 'Mirror blocks' })).toBeVisible();
      await page.getByRole('button', { name: 'Reset view' }).scrollIntoViewIfNeeded();
      await expect(page.getByRole('button', { name: 'Reset view' })).toBeInViewport();
      const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(overflow, 'no scrolling sideways').toBeLessThanOrEqual(0);
      expect(await seriousProblems(page)).toEqual([]);
      await page.getByRole('button', { name: 'Hide controls' }).tap();
      await expect(slider).toBeHidden();
    });

    await test.step('the scene’s middle square fits into what the controls leave', async () => {
      const framing = async () => (await rendererState(page)).settings.framing!;
      // The page measures the sheet when it has been laid out, a frame after it was folded.
      await soon(async () => Math.round((await framing()).height * 700)).toBe(390);
      const folded = await framing();
      await page.getByRole('button', { name: 'Show controls' }).tap();
      await soon(async () => (await framing()).height).toBeLessThan(folded.height);
      const open = await framing();
      const sheet = (await page.getByRole('complementary', { name: 'Controls' }).boundingBox())!;
      expect((open.center[1] + open.height / 2) * 700).toBeLessThanOrEqual(sheet.y + 1);
    });

    // Last: a browser may take a tap so soon after it for the end of the same gesture.
    await test.step('a finger orbits', async () => {
      await page.getByRole('button', { name: 'Hide controls' }).tap();
      // Real touches, which Playwright itself cannot move.
      const devtools = await page.context().newCDPSession(page);
      const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x?: number) =>
        devtools.send('Input.dispatchTouchEvent', { type, touchPoints: x === undefined ? [] : [{ x, y: 300 }] });
      const eye = async () => (await rendererState(page)).camera.eye;
      const start = await eye();
      await touch('touchStart', 120);
      for (const x of [140, 170, 200]) await touch('touchMove', x);
      await touch('touchEnd');
      await soon(eye).not.toEqual(start);
    });
  });
});
