import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { root, runNode, tools } from './run-command.mjs';

const folder = 'packages/cli/dist';

/**
 * Builds the command line, packages/cli/dist/mirrorball.mjs, and the page it shows to a headless Chromium. Gives the exit code.
 * @param {{ quiet?: boolean }} [options]
 */
export async function buildCli({ quiet = false } = {}) {
  for (const config of ['vite.config.ts', 'vite.page.config.ts']) {
    const code = await runNode(tools.vite, [
      'build',
      'packages/cli',
      '--config',
      `packages/cli/${config}`,
      '--logLevel',
      'warn',
    ]);
    if (code !== 0) return code;
  }
  if (quiet) return 0;
  const size = readFileSync(join(root, folder, 'mirrorball.mjs')).length;
  console.log(`${folder}/mirrorball.mjs: ${(size / 1000).toFixed(1)} KB`);
  return 0;
}

/** @param {string} folder */
function newestIn(folder) {
  const files = readdirSync(join(root, folder), { recursive: true, withFileTypes: true }).filter((f) => f.isFile());
  return Math.max(...files.map((file) => statSync(join(file.parentPath, file.name)).mtimeMs));
}

/** Builds it, quietly, when a source is newer than what was built. */
export async function buildCliIfStale() {
  const built = statSync(join(root, folder, 'chromium-page.js'), { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const stale = ['packages/cli/src', 'packages/renderer/src'].some((sources) => newestIn(sources) > built);
  return stale ? buildCli({ quiet: true }) : 0;
}
