import { firstPicture, openProbed, SIZE, withBrowser } from './browser.mjs';
import { markdownTable, median, withSpread } from './statistics.mjs';

const REFERENCE = 'course-style page, WebGL2';
const studio = `/index.html?scene=cube-room&size=${SIZE}&ui=0&paused=0`;
/** @type {Readonly<Record<string, string>>} */
const contestants = {
  [REFERENCE]: `/course-style/index.html?size=${SIZE}&hits=10`,
  'Mirrorball, WebGL2': `${studio}&backend=webgl2`,
  'Mirrorball, WebGPU': `${studio}&backend=webgpu`,
};

/**
 * How long a person waits for the first picture. Each measurement has a browser of its own; the contestants take
 * turns, so that whatever else the machine does hits all of them.
 * @param {{ chromium: string, origin: string, repeat: number, log: (line: string) => void }} options
 * @returns {Promise<string>} a Markdown table
 */
export async function measureColdStart({ chromium, origin, repeat, log }) {
  /** @type {Record<string, number[]>} */
  const times = Object.fromEntries(Object.keys(contestants).map((name) => [name, []]));
  for (let round = 1; round <= repeat; round++) {
    for (const [name, path] of Object.entries(contestants)) {
      const time = await measureOnce(chromium, origin + path).catch((/** @type {Error} */ error) => {
        log(`  ${name}: no picture (${error.message.split('\n')[0]})`);
        return Number.NaN;
      });
      times[name]?.push(time);
      log(`  cold start ${round}/${repeat}  ${name}: ${time.toFixed(0)} ms`);
    }
  }
  const reference = median(times[REFERENCE] ?? []);
  const rows = Object.entries(times).map(([name, values]) => {
    const share = median(values) / reference;
    return [name, withSpread(values, ' ms'), Number.isFinite(share) ? share.toFixed(2) : '–'];
  });
  return markdownTable(['page', 'first picture: median (spread)', '÷ course-style'], rows);
}

/**
 * @param {string} chromium
 * @param {string} address
 */
function measureOnce(chromium, address) {
  return withBrowser(chromium, async (browser) => {
    // The browser itself is to be awake: what is measured is the page's start, not the program's.
    await new Promise((resolve) => setTimeout(resolve, 700));
    return firstPicture(await openProbed(browser, address));
  });
}
