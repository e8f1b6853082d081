import type { Locator, Page } from '@playwright/test';
import { decode } from 'fast-png';
import type { Renderer } from '../../packages/renderer/src/renderer-types.ts';
import { expect } from './fixtures.ts';

/** The built-in scenes: their id, and their name in both languages. */
export const scenes = [
  { id: 'cube-room', en: 'Cube room', zh: '立方体房间' },
  { id: 'mirror-blocks', en: 'Mirror blocks', zh: '镜面积木' },
  { id: 'moving-shadows', en: 'Moving shadows', zh: '流动的阴影' },
  { id: 'materials', en: 'Materials', zh: '材质陈列' },
] as const;

/** Keeps software rendering quick: what these tests look at does not need many pixels. */
export const quick = { scale: 0.25, reflections: 3, samples: 1 } as const;
/** The same on a canvas that fills the page: 96 × 64 pixels. */
export const coarse = { ...quick, scale: 0.1 } as const;

type RendererState = Pick<Renderer, 'backend' | 'settings' | 'stats' | 'camera' | 'time' | 'playing' | 'speed'>;
/** What the page's renderer says of itself at this moment, or as soon as there is one: after a loss it may be away for a while. */
export async function rendererState(page: Page): Promise<RendererState> {
  const state = await page.waitForFunction(() => {
    const { renderer } = (window as unknown as { mirrorball: { renderer: Renderer | null } }).mirrorball;
    if (!renderer) return null;
    const { backend, settings, stats, camera, time, playing, speed } = renderer;
    return { backend, settings: { ...settings }, stats: { ...stats }, camera, time, playing, speed };
  });
  return (await state.jsonValue()) as RendererState;
}

/** Asks until the answer is as wished. Playwright's own pauses grow to a second, which is longer than most things here take. */
export const soon = <Value>(ask: () => Promise<Value>, message?: string) =>
  expect.poll(ask, { intervals: [20, 50, 100], ...(message === undefined ? {} : { message }) });

/** Waits until one property of the renderer's state is as wished: `await expectState(page, (s) => s.playing, false)`. */
export async function expectState<Value>(page: Page, read: (state: RendererState) => Value, wanted: Value) {
  await soon(async () => read(await rendererState(page))).toEqual(wanted);
}

/** A view that glides on after the hand has left it moves in each frame; one that is the same for so many stands still. */
const STILL_FRAMES = 6;

/** Makes four samples the whole picture, and waits until the film holds them and the view stands still. */
export async function settled(page: Page): Promise<void> {
  await page.waitForFunction(() => window.mirrorball?.renderer);
  const samples = () =>
    page.evaluate(async (frames) => {
      const renderer = window.mirrorball.renderer!;
      renderer.set({ maxSamples: 4, seed: 7 });
      const view = () => JSON.stringify([renderer.camera, renderer.time]);
      const before = view();
      for (let i = 0; i < frames; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
      const film = await renderer.readFilm().catch(() => null);
      return view() === before ? (film?.pixels[3] ?? 0) : 0;
    }, STILL_FRAMES);
  await soon(samples, 'samples in the film').toBe(4);
}

/**
 * Makes four samples the whole picture of the renderer there is. Drawn in software, a picture that gets finer on and on takes a
 * processor to itself, and what most tests look at does not.
 */
export async function fewSamples(page: Page): Promise<void> {
  await page.waitForFunction(() => {
    const renderer = window.mirrorball?.renderer;
    renderer?.set({ maxSamples: 4 });
    return Boolean(renderer);
  });
}

/** Lets the page believe that its tab is hidden, or seen again. */
export async function setHidden(page: Page, hidden: boolean): Promise<void> {
  await page.evaluate((value) => {
    Object.defineProperty(document, 'hidden', { value, configurable: true });
    Object.defineProperty(document, 'visibilityState', { value: value ? 'hidden' : 'visible', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  }, hidden);
}

/** A group of radio buttons by its name. */
export const group = (page: Page, name: string): Locator => page.getByRole('group', { name, exact: true });

/** Chooses in a group with the mouse. */
export async function choose(page: Page, groupName: string, option: string): Promise<void> {
  const radio = group(page, groupName).getByRole('radio', { name: option, exact: true });
  // Not check(): a backend is chosen only when it draws, a moment after the click.
  await radio.click();
  await expect(radio).toBeChecked();
}

/** Opens a section that is folded at first. */
export async function unfold(page: Page, heading: string): Promise<void> {
  const section = page.locator('details', { has: page.getByRole('heading', { name: heading, exact: true }) });
  if ((await section.getAttribute('open')) === null) await section.locator('summary').click();
}

interface Look {
  /** Different colours, five bits a channel. */
  readonly colours: number;
  /** Share of pixels that are not black. */
  readonly lit: number;
  /** 8 × 8 mean brightnesses: to tell one picture from another. */
  readonly thumbnail: readonly number[];
}

/** Looks at the left of the canvas, where no panel lies, as it is on the screen. */
export async function lookAtPicture(page: Page): Promise<Look> {
  const box = await page.locator('main canvas').first().boundingBox();
  if (!box) return { colours: 0, lit: 0, thumbnail: [] };
  // In the middle of the height: above it are notices, below it the status line.
  const clip = { x: box.x, y: box.y + box.height * 0.25, width: box.width * 0.5, height: box.height * 0.5 };
  const { width, height, channels, data } = decode(await page.screenshot({ clip, animations: 'allow' }));
  const colours = new Set<number>();
  const sums = new Array<number>(64).fill(0);
  let lit = 0;
  for (let i = 0, at = 0; i < width * height; i++, at += channels) {
    const [r, g, b] = [data[at]!, data[at + 1]!, data[at + 2]!];
    colours.add(((r >> 3) << 10) | ((g >> 3) << 5) | (b >> 3));
    if (r + g + b > 24) lit++;
    const cell = Math.floor((Math.floor(i / width) * 8) / height) * 8 + Math.floor(((i % width) * 8) / width);
    sums[cell] = sums[cell]! + (r + g + b) / 3;
  }
  const pixelsPerCell = (width * height) / 64;
  return { colours: colours.size, lit: lit / (width * height), thumbnail: sums.map((sum) => sum / pixelsPerCell) };
}

/** Waits for a ray traced picture: many colours, and not in the dark. */
export async function expectPicture(page: Page): Promise<Look> {
  let look = await lookAtPicture(page);
  await soon(async () => {
    const { colours, lit } = look;
    if (colours >= 8 && lit > 0.02) return true;
    look = await lookAtPicture(page);
    return false;
  }, 'a picture is on the canvas').toBe(true);
  return look;
}

/** Waits until the picture looks unlike another one, by more than this of 255 somewhere in the thumbnail, and gives it. */
export async function expectChange(page: Page, from: Look, least: number, message: string): Promise<Look> {
  let look = from;
  await soon(async () => {
    look = await lookAtPicture(page);
    return difference(from, look);
  }, message).toBeGreaterThan(least);
  return look;
}

/** The largest difference between the thumbnails of two pictures, 0 … 255. */
const difference = (a: Look, b: Look): number =>
  Math.max(...a.thumbnail.map((value, i) => Math.abs(value - (b.thumbnail[i] ?? 0))));
