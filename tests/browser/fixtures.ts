import { writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { test as base, type ConsoleMessage, expect, type Page, type TestInfo } from '@playwright/test';
import { encode } from 'fast-png';
import type {} from './harness/harness.ts';
import { studioPage } from './serve-harness.ts';

export { expect };

export const backends = ['webgpu', 'webgl2'] as const;
export type Backend = (typeof backends)[number];
/** How the studio's page reaches the browser: by the local server, or opened by a double-click. */
export const origins = ['served', 'file'] as const;
export type Origin = (typeof origins)[number];
/** Each backend with each origin, for tests that must hold on all four. */
export const everywhere = backends.flatMap((backend) => origins.map((origin) => ({ backend, origin })));

/** Lets a page be used, and fails the test when it reported an error: uncaught, in its console, or by failing to load something. */
async function watched(page: Page, use: (page: Page) => Promise<void>): Promise<void> {
  const problems: string[] = [];
  const onConsole = (message: ConsoleMessage) => {
    // Chromium reports what a driver refuses as a warning.
    if (message.type() === 'error' || /GL_INVALID|Invalid(Enum|Value|Operation)/.test(message.text()))
      problems.push(`console: ${message.text()}`);
  };
  const onError = (error: Error) => problems.push(`uncaught: ${error.stack ?? error.message}`);
  const onCrash = () => problems.push('the page crashed');
  page.on('console', onConsole).on('pageerror', onError).on('crash', onCrash);
  await use(page);
  page.off('console', onConsole).off('pageerror', onError).off('crash', onCrash);
  expect(problems, 'errors reported by the page').toEqual([]);
}

const served = (path: string) => `${process.env.MIRRORBALL_ORIGIN}${path}`;

export interface StudioAddress {
  readonly origin?: Origin;
  readonly backend?: Backend;
  /** Further parameters of the address, such as { scene: 'cube-room', paused: 1 }. */
  readonly query?: Readonly<Record<string, string | number>>;
}
/** The address of the studio's page. */
export function studioAddress({ origin = 'served', backend, query = {} }: StudioAddress): string {
  const address = new URL(origin === 'file' ? pathToFileURL(studioPage).href : served('/index.html'));
  if (backend) address.searchParams.set('backend', backend);
  for (const [name, value] of Object.entries(query)) address.searchParams.set(name, String(value));
  return address.href;
}

interface Fixtures {
  /** Opens the studio in `page`. */
  openStudio: (address?: StudioAddress) => Promise<void>;
  /** A page with `window.harness` ready. */
  harness: Page;
}
interface WorkerFixtures {
  /**
   * The harness of all tests of a worker: what it is asked depends on nothing that was asked before, and a page of its own for each
   * test took longer than most tests. A test that fails ends the worker, so the next one has a fresh page.
   */
  sharedHarness: Page;
}

export const test = base.extend<Fixtures, WorkerFixtures>({
  page: ({ page }, use) => watched(page, use),
  openStudio: async ({ page }, use) => {
    await use(async (address = {}) => void (await page.goto(studioAddress(address))));
  },
  harness: ({ sharedHarness }, use) => watched(sharedHarness, use),
  sharedHarness: [
    async ({ browser }, use) => {
      const page = await browser.newPage();
      await page.goto(served('/tests/index.html'));
      await page.waitForFunction(() => window.harness !== undefined);
      await use(page);
      await page.close();
    },
    { scope: 'worker' },
  ],
});

/** An 8-bit RGB or RGBA picture, row 0 on top, as `page.evaluate` can return it. */
export interface Picture {
  readonly width: number;
  readonly height: number;
  readonly pixels: ArrayLike<number>;
}
/** Writes a picture to the test's folder in test-results/, which stays there only when the test fails. */
export async function keepPicture(testInfo: TestInfo, name: string, picture: Picture): Promise<void> {
  const { width, height } = picture;
  const channels = picture.pixels.length / (width * height);
  const path = testInfo.outputPath(`${name}.png`);
  await writeFile(path, encode({ width, height, channels, depth: 8, data: Uint8Array.from(picture.pixels) }));
  await testInfo.attach(name, { path, contentType: 'image/png' });
}
