import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { root, runNode, tools } from './run-command.mjs';

export const studioFolder = join(root, 'apps/studio/dist');
const page = join(studioFolder, 'index.html');

/**
 * The page may weigh so much, minified and gzipped; 1 KB = 1000 bytes, the stricter reading. What few need lies in files beside it
 * (lazy-parts.mjs).
 */
const LIMIT = 150_000;

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
  const files = readdirSync(studioFolder).filter((name) => /\.(html|js)$/.test(name));
  for (const name of files) {
    const text = readFileSync(join(studioFolder, name), 'utf8');
    console.log(`apps/studio/dist/${name}: ${kilobytes(text.length)}, gzipped ${kilobytes(gzipped(text))}`);
  }
  const found = gzipped(readFileSync(page, 'utf8'));
  if (found <= LIMIT) return 0;
  console.error(
    `The page is too heavy: ${kilobytes(found)} gzipped, and at most ${kilobytes(LIMIT)} are allowed. ` +
      'See what grew with `git diff` of package.json, or load the new part lazily.',
  );
  return 1;
}

const gzipped = (/** @type {string} */ text) => gzipSync(text, { level: 9 }).length;
