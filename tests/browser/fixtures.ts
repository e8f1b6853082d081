import { writeFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { test as base, expect, type Page, type TestInfo } from '@playwright/test';
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

/** Errors that a page reported: uncaught, in its console, or by failing to load something. */
export class PageProblems {
  readonly found: string[] = [];
  private readonly allowed: RegExp[] = [];

  /** Says that this test provokes such errors. */
  allow(pattern: RegExp): void {
    this.allowed.push(pattern);
  }

  watch(page: Page): void {
    page.on('console', (message) => {
      // Chromium reports what a driver refuses as a warning.
      if (message.type() === 'error' || /GL_INVALID|Invalid(Enum|Value|Operation)/.test(message.text()))
        this.found.push(`console: ${message.text()}`);
    });
    page.on('pageerror', (error) => this.found.push(`uncaught: ${error.stack ?? error.message}`));
    page.on('crash', () => this.found.push('the page crashed'));
  }

  get unexpected(): string[] {
    return this.found.filter((problem) => !this.allowed.some((pattern) => pattern.test(problem)));
  }
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
  /** Fails the test at its end when the page reported an error. Always on. */
  problems: PageProblems;
  /** Opens the studio in `page`. */
  openStudio: (address?: StudioAddress) => Promise<void>;
  /** A page with `window.harness` ready. */
  harness: Page;
}

export const test = base.extend<Fixtures>({
  problems: [
    async ({ page }, use) => {
      const problems = new PageProblems();
      problems.watch(page);
      await use(problems);
      expect(problems.unexpected, 'errors reported by the page').toEqual([]);
    },
    { auto: true },
  ],
  openStudio: async ({ page }, use) => {
    await use(async (address = {}) => void (await page.goto(studioAddress(address))));
  },
  harness: async ({ page }, use) => {
    await page.goto(served('/tests/index.html'));
    await page.waitForFunction(() => window.harness !== undefined);
    await use(page);
  },
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
