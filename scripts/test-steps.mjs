// The steps of `npm test`, in order. A step gives its exit code and, when it runs test cases, how they went.
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { buildAll } from './build-all.mjs';
import { ensureChromium } from './install-chromium.mjs';
import { root, runNode, tools } from './run-command.mjs';

/** @typedef {{ passed: number, failed: number, skipped: number }} Cases */
/** @typedef {{ ok: boolean, cases: Cases | null }} Outcome */
/** @typedef {{ name: string, about: string, needs?: string, run: () => Promise<Outcome> }} Step */

/**
 * An empty report file of its own, so that an old one is never read in place of one that was not written.
 * @param {string} name
 */
function freshReport(name) {
  const path = join(root, '.cache/test-reports', `${name}.json`);
  mkdirSync(dirname(path), { recursive: true });
  rmSync(path, { force: true });
  return path;
}

/**
 * @param {string} path
 * @returns {any}
 */
function readReport(path) {
  return existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : null;
}

/**
 * A step with no case at all has failed too: a wrong pattern must not look like success.
 * @param {number} code
 * @param {Cases | null} cases
 * @returns {Outcome}
 */
function judge(code, cases) {
  if (code === 0 && cases && cases.passed === 0) console.error('No test case ran.');
  return { ok: code === 0 && (cases?.passed ?? 1) > 0, cases };
}

async function unit() {
  const path = freshReport('unit');
  const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${path}`];
  const code = await runNode(tools.vitest, ['run', ...reporters]);
  const report = readReport(path);
  return judge(code, {
    passed: report?.numPassedTests ?? 0,
    failed: report?.numFailedTests ?? 0,
    skipped: (report?.numPendingTests ?? 0) + (report?.numTodoTests ?? 0),
  });
}

/** One case: the committed shaders are what the sources give. */
async function shaders() {
  const code = await runNode(tools.tsx, ['scripts/shaders.ts', '--check']);
  return judge(code, { passed: code === 0 ? 1 : 0, failed: code === 0 ? 0 : 1, skipped: 0 });
}

/** What has a bar in seconds has the machine to itself. */
async function browser() {
  const together = await playwright('browser', ['--grep-invert', '@alone']);
  const built = { MIRRORBALL_HARNESS_BUILT: '1' };
  const alone = await playwright('browser-alone', ['--grep', '@alone', '--workers', '1'], built);
  const sum = (/** @type {'passed' | 'failed' | 'skipped'} */ key) => together.cases[key] + alone.cases[key];
  const cases = { passed: sum('passed'), failed: sum('failed'), skipped: sum('skipped') };
  return judge(together.code || alone.code, cases);
}

/**
 * @param {string} report
 * @param {string[]} options
 * @param {Record<string, string>} [more]
 */
async function playwright(report, options, more) {
  const path = freshReport(report);
  const env = { CHROMIUM: await ensureChromium(), PLAYWRIGHT_JSON_OUTPUT_NAME: path, ...more };
  const code = await runNode(tools.playwright, ['test', '--reporter=list,json', ...options], env);
  const stats = readReport(path)?.stats;
  const cases = {
    passed: (stats?.expected ?? 0) + (stats?.flaky ?? 0),
    failed: stats?.unexpected ?? 0,
    skipped: stats?.skipped ?? 0,
  };
  return { code, cases };
}

/** @type {readonly Step[]} */
export const steps = [
  {
    name: 'types',
    about: 'TypeScript finds no wrong type',
    run: async () => judge(await runNode(tools.typescript, ['--noEmit']), null),
  },
  {
    name: 'lint',
    about: 'Biome finds nothing to mend (npm run format mends most)',
    run: async () => judge(await runNode(tools.biome, ['check', '.']), null),
  },
  { name: 'shaders', about: 'the committed WGSL and GLSL are fresh (npm run shaders writes them)', run: shaders },
  {
    name: 'build',
    about: 'the studio as one small file, the library as one module, the command line',
    run: async () => judge(await buildAll(), null),
  },
  // After the build: what tests the command line from outside would build it itself.
  { name: 'unit', about: 'Vitest, in Node', run: unit },
  { name: 'browser', about: 'Playwright, in Chromium on WebGPU and WebGL2', needs: 'build', run: browser },
];
