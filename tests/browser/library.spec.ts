import { readFileSync } from 'node:fs';
import { decode } from 'fast-png';
import { codeBlocks, root } from '../documents/documents.ts';
import { expect, test } from './fixtures.ts';

// Drawn in software, a large picture takes its time.
test.use({ viewport: { width: 480, height: 320 } });

test('both READMEs show the same first page', () =>
  expect(codeBlocks('README.zh-CN.md', 'html')).toEqual(codeBlocks('README.md', 'html')));

/** What a newcomer copies from the README, in a page of its own, with the built library beside it. */
test('the page in README.md draws a picture', async ({ page }) => {
  const library = readFileSync(`${root}packages/renderer/dist/mirrorball.js`);
  await page.route('**/first-page/**', (route) => {
    const asked = new URL(route.request().url()).pathname;
    if (asked === '/first-page/') {
      return route.fulfill({ contentType: 'text/html', body: codeBlocks('README.md', 'html')[0]! });
    }
    if (asked === '/first-page/mirrorball/mirrorball.js') {
      return route.fulfill({ contentType: 'text/javascript', body: library });
    }
    return route.fulfill({ status: 404 });
  });
  await page.goto(`${process.env.MIRRORBALL_ORIGIN}/first-page/`);
  const colours = async () => {
    const { data } = decode(await page.locator('canvas').screenshot());
    const seen = new Set<number>();
    for (let at = 0; at < data.length; at += 3 * 97) seen.add((data[at]! >> 4) * 256 + data[at + 1]!);
    return seen.size;
  };
  await expect.poll(colours, 'colours in the picture').toBeGreaterThan(50);
});
