import { statSync } from 'node:fs';
import { join } from 'node:path';
import { root, runNpm } from './run-command.mjs';

/** @param {string} path */
function changedAt(path) {
  return statSync(join(root, path), { throwIfNoEntry: false })?.mtimeMs ?? 0;
}

/**
 * Installs the npm packages when they are missing or older than the lock file; else does nothing.
 * Always `npm ci`: it installs exactly what the lock file says and never rewrites it.
 */
export async function installPackages() {
  // npm writes this file at the end of an install, so half an install counts as none.
  if (changedAt('node_modules/.package-lock.json') >= changedAt('package-lock.json')) return;
  console.log('Installing packages (npm ci) …');
  const code = await runNpm(['ci', '--no-fund', '--no-audit', '--loglevel=error']);
  if (code === 0) return;
  console.error(
    '\nThe packages could not be installed: npm ci failed, and says why above. Is there a network connection?',
  );
  process.exit(1);
}
