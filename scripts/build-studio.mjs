import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { PARTS_START } from './lazy-parts.mjs';
import { root, runNode, tools } from './run-command.mjs';

export const studioFolder = join(root, 'apps/studio/dist');
const page = join(studioFolder, 'index.html');

/**
 * What every visitor waits for may weigh so much, minified and gzipped. 1 KB = 1000 bytes, the stricter reading. What follows in the
 * file, for models only, is neither waited for nor unpacked before it is needed (lazy-parts.mjs).
 */
const LIMIT = 150_000;
/** The whole file: with what opens models, and the decoders of Draco and Basis Universal, a fifth of a megabyte each, as nothing may be fetched. */
const WHOLE_LIMIT = 850_000;

/** @param {number} bytes */
const kilobytes = (bytes) => `${(bytes / 1000).toFixed(1)} KB`;

/**
 * Builds apps/studio/dist/index.html, says how large it is, and gives the exit code:
 * not 0 when Vite fails or when the page is too heavy.
 */
export async function buildStudio() {
  const code = await runNode(tools.vite, ['build', 'apps/studio', '--logLevel', 'warn']);
  if (code !== 0) return code;
  if (!existsSync(page)) {
    console.error(
      'The build made no apps/studio/dist/index.html. Does apps/studio/vite.config.ts still build one file?',
    );
    return 1;
  }
  const html = readFileSync(page, 'utf8');
  const cut = html.indexOf(PARTS_START);
  const whole = gzipped(html);
  const start = cut < 0 ? whole : gzipped(html.slice(0, cut));
  console.log(
    `apps/studio/dist/index.html: ${kilobytes(html.length)}, gzipped ${kilobytes(whole)}; its start ${kilobytes(start)}`,
  );
  if (start <= LIMIT && whole <= WHOLE_LIMIT) return 0;
  const [found, most] = start > LIMIT ? [`its start ${kilobytes(start)}`, LIMIT] : [kilobytes(whole), WHOLE_LIMIT];
  console.error(
    `The page is too heavy: ${found} gzipped, and at most ${kilobytes(most)} are allowed. ` +
      'See what grew with `git diff` of package.json, or load the new part lazily.',
  );
  return 1;
}

const gzipped = (/** @type {string} */ text) => gzipSync(text, { level: 9 }).length;
