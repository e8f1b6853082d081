import { readFileSync } from 'node:fs';
import { chromium } from '@playwright/test';
import { chromiumFlags } from '../scripts/chromium.mjs';

const probe = readFileSync(new URL('probe.js', import.meta.url), 'utf8');

/** The picture's pixels along one side. */
export const SIZE = 512;

/**
 * A Chromium with a new profile and no cache of compiled shaders, for `use` alone; ended afterwards whatever happens.
 * @template Result
 * @param {string} executablePath
 * @param {(browser: import('@playwright/test').Browser) => Promise<Result>} use
 */
export async function withBrowser(executablePath, use) {
  const args = [...chromiumFlags, '--disable-gpu-shader-disk-cache', '--disable-gpu-program-cache'];
  const browser = await chromium.launch({ executablePath, args });
  try {
    return await use(browser);
  } finally {
    await browser.close();
  }
}

/**
 * Opens an address with the probe in it.
 * @param {import('@playwright/test').Browser} browser
 * @param {string} address
 */
export async function openProbed(browser, address) {
  const page = await browser.newPage({ viewport: { width: SIZE, height: SIZE } });
  await page.addInitScript({ content: probe });
  await page.goto(address, { waitUntil: 'commit' });
  return page;
}

/**
 * Waits for the page's first picture: milliseconds since its navigation began.
 * @param {import('@playwright/test').Page} page
 * @returns {Promise<number>}
 */
export async function firstPicture(page) {
  // Asked seldom, as each question takes time from the page.
  const found = await page.waitForFunction(() => /** @type {any} */ (window).benchProbe?.firstPicture, undefined, {
    polling: 200,
    timeout: 60_000,
  });
  return /** @type {number} */ (await found.jsonValue());
}
