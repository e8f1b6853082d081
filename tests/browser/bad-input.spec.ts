import type { Page } from '@playwright/test';
import {
  brokenAnimation,
  brokenObjects,
  brokenParts,
  brokenShapes,
} from '../../packages/renderer/src/scene-file/broken/broken-scenes.ts';
import { goodScene } from '../../packages/renderer/src/scene-file/broken/good-scene.ts';
import { backends, expect, test } from './fixtures.ts';
import { hookGpu, hooks } from './gpu-hooks.ts';
import { expectPicture, expectState, fewSamples, quick, rendererState, soon } from './studio.ts';

/** Broken scenes as the text of a file; what only an object can hold has none. */
function brokenFiles(): { name: string; text: string }[] {
  const files: { name: string; text: string }[] = [];
  for (const [defect, breakIt] of [...brokenParts, ...brokenShapes, ...brokenAnimation, ...brokenObjects]) {
    const scene = goodScene();
    breakIt(scene);
    const text = textOf(scene);
    if (text !== null && text !== JSON.stringify(goodScene())) files.push({ name: `${defect}.json`, text });
  }
  return files;
}

function textOf(scene: unknown): string | null {
  try {
    return JSON.stringify(scene);
  } catch {
    return null; // a cycle or the like
  }
}

interface Listed {
  readonly path: string;
  readonly message: string;
}
/** A file by its text, or by its size in MiB and the byte that it is full of. */
type Given = { name: string; text: string } | { name: string; mebibytes: number; byte: number };

const NO_SCENES: readonly Given[] = [
  { name: 'empty.json', text: '' },
  { name: 'words.json', text: 'not a scene' },
  { name: 'page.html', text: '<!doctype html><title>x</title>' },
  { name: 'noise.bin', mebibytes: 1, byte: 0xff },
  { name: 'zeros.bin', mebibytes: 1, byte: 0 },
  { name: 'large.json', mebibytes: 50, byte: 32 },
];

/** Drops each file on the page, or chooses it in the panel, in turn, and gives what the dialog lists. */
function openAll(page: Page, files: readonly Given[]): Promise<Listed[][]> {
  return page.evaluate(async (given) => {
    const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
    const input = document.querySelector<HTMLInputElement>('#scene-file')!;
    const lists: Listed[][] = [];
    for (const [index, one] of given.entries()) {
      const content = 'text' in one ? one.text : new Uint8Array(one.mebibytes * 2 ** 20).fill(one.byte);
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], one.name));
      if (index % 2 === 0) dispatchEvent(new DragEvent('drop', { dataTransfer, cancelable: true }));
      else {
        input.files = dataTransfer.files;
        input.dispatchEvent(new Event('change', { bubbles: true }));
      }
      const dialog = document.querySelector<HTMLDialogElement>('#problems')!;
      for (let i = 0; !dialog.open && i < 1000; i++) await pause(5);
      const texts = (item: Element, part: string) => item.querySelector(part)?.textContent ?? '';
      lists.push(
        [...dialog.querySelectorAll('.problems li')].map((item) => ({
          // What is wrong with all of a file has no place in it.
          path: item.querySelector('.path') ? texts(item, '.path') : 'the file',
          message: texts(item, 'p'),
        })),
      );
      dialog.close();
      while (document.querySelector('#problems li')) await pause(5);
    }
    return lists;
  }, files);
}

for (const backend of backends)
  test(`broken scene files list their problems, and the scene runs on (${backend})`, async ({ page, openStudio }) => {
    await hookGpu(page);
    await openStudio({ backend, query: { ...quick, size: 64, paused: 0 } });
    await expectPicture(page);
    await rendererState(page); // There is one a moment after its first picture.
    await page.evaluate(() => Object.assign(window, { sceneBefore: window.mirrorball.renderer!.scene }));
    const { draws } = await hooks(page);
    const { time } = await rendererState(page);

    const broken = brokenFiles();
    expect(broken.length).toBeGreaterThanOrEqual(60);
    // Files are read before any backend sees them: each of the two gets every other one.
    const files = [...broken, ...NO_SCENES].filter((_, i) => i % 2 === (backend === 'webgl2' ? 0 : 1));
    const lists = await openAll(page, files);
    for (const [i, problems] of lists.entries()) {
      expect(problems.length, `problems of ${files[i]!.name}`).toBeGreaterThan(0);
      for (const parts of problems)
        for (const [part, text] of Object.entries(parts)) expect(text, `${part} in ${files[i]!.name}`).not.toBe('');
    }

    const same = () =>
      page.evaluate(
        () => window.mirrorball.renderer!.scene === (window as unknown as { sceneBefore: unknown }).sceneBefore,
      );
    expect(await same(), 'it is the same scene').toBe(true);
    await soon(async () => (await hooks(page)).draws, 'frames went on').toBeGreaterThan(draws);
    await expectState(page, (state) => state.time > time && state.playing, true);
    await expectPicture(page);
  });

test('junk by the API throws a TypeError and changes nothing', async ({ page, openStudio }) => {
  await openStudio({ backend: 'webgl2', query: { ...quick, size: 160, paused: 1 } });
  await fewSamples(page);
  await expectPicture(page);
  const before = await rendererState(page);
  const answers = await page.evaluate(async () => {
    const renderer = window.mirrorball.renderer!;
    const scene = renderer.scene!;
    const { camera } = renderer;
    const found: string[] = [];
    const attempt = async (action: () => unknown) => {
      try {
        await action();
        found.push('accepted');
      } catch (error) {
        found.push((error as Error).name);
      }
    };
    const junk = [
      undefined,
      null,
      3,
      '{}',
      [],
      {},
      { animation: [] },
      { ...scene, shapes: null },
      { ...scene, camera },
    ];
    junk[8] = { ...scene, camera: { ...camera, eye: [Number.NaN, 0, 0] } };
    for (const value of junk) await attempt(() => renderer.setScene(value as never));
    for (const value of [undefined, {}, { ...camera, up: [0, 0] }, { ...camera, verticalFov: 0 }])
      await attempt(() => Object.assign(renderer, { camera: value }));
    await attempt(() => Object.assign(renderer, { camera: { ...camera, target: camera.eye } }));
    await attempt(() => renderer.set({ comparison: 5 } as never));
    return found;
  });
  expect(answers).toEqual([...Array(13).fill('TypeError'), 'RangeError', 'RangeError']);
  await page.waitForTimeout(100);
  const { stats: _, ...after } = await rendererState(page);
  expect(before).toMatchObject(after);
  await expectPicture(page);
});
