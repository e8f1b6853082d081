import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, runNode, tools } from './run-command.mjs';

const folder = 'packages/cli/dist';

/** Builds the command line, packages/cli/dist/mirrorball.mjs, and the page it shows to a headless Chromium. Gives the exit code. */
export async function buildCli() {
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
  const size = readFileSync(join(root, folder, 'mirrorball.mjs')).length;
  console.log(`${folder}/mirrorball.mjs: ${(size / 1000).toFixed(1)} KB`);
  return 0;
}
