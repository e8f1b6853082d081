import { expect, test } from './fixtures.ts';
import { choose, coarse, expectState, fewSamples, rendererState, soon } from './studio.ts';

const query = { ...coarse, scene: 'materials', paused: 1 };

test('a click focuses on what is there, a drag does not; so does a key, and the slider', async ({
  page,
  openStudio,
}) => {
  await openStudio({ backend: 'webgl2', query });
  await fewSamples(page);
  const focus = async () => (await rendererState(page))?.camera.focusDistance ?? 0;
  const distance = page.getByRole('slider', { name: 'Focus distance' });
  await expect(distance).toBeDisabled();
  await expect(distance).toHaveAccessibleDescription('With an aperture of 0 everything is sharp');
  await page.getByRole('slider', { name: 'Aperture (radius)' }).fill('40');
  await expectState(page, (state) => state.camera.aperture, 0.0148);
  await expect(distance).toBeEnabled();

  await page.mouse.click(320, 560);
  await soon(focus).toBeGreaterThan(1);
  const near = await focus();
  await page.mouse.click(320, 330);
  await soon(focus).toBeGreaterThan(near + 0.5);
  const far = await focus();
  await page.mouse.move(320, 560);
  await page.keyboard.press('o');
  await soon(focus).toBeCloseTo(near, 6);

  await page.mouse.click(320, 20);
  await expect(page.getByText('There is nothing there to focus on.')).toBeVisible();
  expect(await focus()).toBeCloseTo(near, 6);

  await page.mouse.move(320, 330);
  await page.mouse.down();
  await page.mouse.move(340, 330, { steps: 4 });
  await page.mouse.up();
  expect(await focus()).not.toBeCloseTo(far, 2);

  await choose(page, 'Method', 'Classic ray tracing');
  await expect(distance).toBeDisabled();
  await expect(distance).toHaveAccessibleDescription('Only path tracing uses this');
});

test('the address has a lens; it stays when the view is reset, and goes with the scene', async ({
  page,
  openStudio,
}) => {
  await openStudio({ backend: 'webgl2', query: { ...query, aperture: 0.05, focus: 2.5 } });
  await fewSamples(page);
  const lens = async () => {
    const { aperture = 0, focusDistance = 0 } = (await rendererState(page))?.camera ?? {};
    return [aperture, focusDistance];
  };
  await soon(lens).toEqual([0.05, 2.5]);
  await expect(page.getByRole('slider', { name: 'Focus distance' })).toHaveAttribute('aria-valuetext', '2.50 m');
  await page.getByRole('slider', { name: 'Aperture (radius)' }).fill('0');
  await soon(lens).toEqual([0, 2.5]);
  await page.keyboard.press('r');
  await soon(lens).toEqual([0.05, 2.5]);
  await page.keyboard.press('1');
  await soon(lens).toEqual([0, 0]);
});

test('a still by the CPU says that it traces no paths', async ({ page, openStudio }) => {
  await openStudio({ query: { ...query, backend: 'cpu', lang: 'zh' } });
  const notice = page.getByText('路径追踪需要 WebGPU 或 WebGL2。');
  await expect(notice).toBeVisible();
  const aperture = page.getByRole('slider', { name: '光圈半径' });
  await expect(aperture).toHaveAccessibleDescription('CPU 静帧不支持镜头景深。');
  expect(
    await page.evaluate(() => [window.mirrorball.renderer!.settings.integrator, window.mirrorball.renderer!.drawnBy]),
  ).toEqual(['path', 'classic']);
  await choose(page, '渲染方法', '经典光线追踪');
  await expect(notice).toBeHidden();
});

test('a scene made for paths says what classic ray tracing leaves out; what is no failure goes by itself', async ({
  page,
  openStudio,
}) => {
  await openStudio({ query: { ...query, backend: 'webgl2', integrator: 'classic', seed: 1 } });
  const notice = page.locator('.notice[data-subject=path]');
  await expect(notice).toContainText('made for path tracing');
  // Not while it is pointed at; then its time is let go by at once.
  await notice.hover();
  const state = () => notice.evaluate((element) => element.getAnimations().map(({ playState }) => playState));
  await soon(state).toEqual(['paused']);
  await page.mouse.move(5, 400);
  await soon(state).toEqual(['running']);
  await notice.evaluate((element) => element.getAnimations()[0]!.finish());
  await expect(notice).toBeHidden();
});
