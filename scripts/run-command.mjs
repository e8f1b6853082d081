import { spawn } from 'node:child_process';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** The repository's root: every command runs there, whatever folder npm was called from. */
export const root = fileURLToPath(new URL('..', import.meta.url));

/**
 * Runs a program with our own terminal and resolves to its exit code; a program that cannot be started gives 127.
 * @param {string} command
 * @param {string[]} args
 * @param {{ env?: Record<string, string | undefined>, quiet?: boolean, shell?: boolean }} [options]
 * @returns {Promise<number>}
 */
export function runCommand(command, args, { env = {}, quiet = false, shell = false } = {}) {
  return new Promise((resolve) => {
    const child = spawn(command, args, {
      cwd: root,
      env: { ...process.env, ...env },
      // No standard input: nothing here may stop to ask a question.
      stdio: ['ignore', quiet ? 'ignore' : 'inherit', quiet ? 'ignore' : 'inherit'],
      shell,
    });
    child.on('error', () => resolve(127));
    child.on('close', (code) => resolve(code ?? 1));
  });
}

/**
 * Runs a script with this very Node. Installed tools are started this way and not through node_modules/.bin,
 * whose entries are shell scripts on one system and .cmd files on another.
 * @param {string} script path from the root
 * @param {string[]} args
 * @param {Record<string, string | undefined>} [env]
 */
export function runNode(script, args, env) {
  return runCommand(process.execPath, [join(root, script), ...args], { env });
}

/**
 * Runs npm: the one that started us, when there is one.
 * @param {string[]} args
 */
export function runNpm(args) {
  const starter = process.env.npm_execpath;
  if (starter && basename(starter).startsWith('npm')) return runCommand(process.execPath, [starter, ...args]);
  // npm is a .cmd file on Windows, which only a shell can start.
  return runCommand('npm', args, { shell: process.platform === 'win32' });
}

/** Where the installed tools have their entry points. */
export const tools = {
  biome: 'node_modules/@biomejs/biome/bin/biome',
  playwright: 'node_modules/@playwright/test/cli.js',
  tsx: 'node_modules/tsx/dist/cli.mjs',
  typescript: 'node_modules/typescript/bin/tsc',
  vite: 'node_modules/vite/bin/vite.js',
  vitest: 'node_modules/vitest/vitest.mjs',
};
