#!/usr/bin/env node
// npm run bench: how fast Mirrorball starts and draws, beside a course-style page, in one run on this machine.
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus, type } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildStudio, studioFolder } from '../scripts/build-studio.mjs';
import { ensureChromium } from '../scripts/install-chromium.mjs';
import { installPackages } from '../scripts/install-packages.mjs';
import { requireNode } from '../scripts/node-version.mjs';
import { root } from '../scripts/run-command.mjs';
import { serveFolders } from '../scripts/static-server.mjs';

const USAGE = `npm run bench -- [options], such as: npm run bench -- --only frames --rounds 2
  --only start|frames   measure cold starts alone, or frames alone
  --repeat N            cold starts of each page, 5 unless given
  --rounds N            turns of each page when frames are measured, 8 unless given
  --write               put the tables into docs/benchmarks.md
  --no-build            measure the studio as it was built last`;

function readOptions() {
  try {
    const { values } = parseArgs({
      options: {
        only: { type: 'string' },
        repeat: { type: 'string', default: '5' },
        rounds: { type: 'string', default: '8' },
        write: { type: 'boolean', default: false },
        'no-build': { type: 'boolean', default: false },
        help: { type: 'boolean', short: 'h', default: false },
      },
    });
    if (values.help) {
      console.log(USAGE);
      process.exit(0);
    }
    const { only, write } = values;
    const [repeat, rounds] = [Number(values.repeat), Number(values.rounds)];
    if (only !== undefined && only !== 'start' && only !== 'frames') throw new Error(`--only ${only} is not known`);
    if (!(repeat >= 1 && rounds >= 1)) throw new Error('--repeat and --rounds are numbers from 1');
    return { only, repeat, rounds, write, build: !values['no-build'] };
  } catch (error) {
    console.error(`${/** @type {Error} */ (error).message}\n\n${USAGE}`);
    process.exit(2);
  }
}

/** @param {string} report */
function writeReport(report) {
  const path = join(root, 'docs/benchmarks.md');
  const [start, end] = ['<!-- npm run bench -- --write: start -->', '<!-- end -->'];
  const text = readFileSync(path, 'utf8');
  const [from, to] = [text.indexOf(start), text.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`docs/benchmarks.md has lost its marks ${start} and ${end}`);
  writeFileSync(path, `${text.slice(0, from + start.length)}\n\n${report}\n\n${text.slice(to)}`);
}

requireNode();
const options = readOptions();
await installPackages();
if (options.build && (await buildStudio()) !== 0) process.exit(1);
const chromium = await ensureChromium();
// Imported only now, as they need the installed packages.
const { withBrowser } = await import('./browser.mjs');
const { measureColdStart } = await import('./cold-start.mjs');
const { measureFrameCost } = await import('./frame-cost.mjs');

const server = await serveFolders({
  mounts: {
    '/': studioFolder,
    '/course-style/': join(root, 'bench/course-style'),
    '/rooms/': join(root, 'bench/rooms'),
  },
});
// By number: looking up "localhost" is none of the pages' business.
const origin = `http://127.0.0.1:${server.port}`;
const log = (/** @type {string} */ line) => console.error(line);
try {
  const version = await withBrowser(chromium, async (browser) => browser.version());
  const processors = cpus();
  const machine = `${processors.length} × ${processors[0]?.model.trim() ?? 'unknown processor'}, ${type()}`;
  const sections = [
    `${new Date().toISOString().slice(0, 10)} · ${machine} · Chromium ${version}, SwiftShader (no GPU)`,
  ];
  if (options.only !== 'frames') {
    sections.push('### Cold start', await measureColdStart({ chromium, origin, repeat: options.repeat, log }));
  }
  if (options.only !== 'start') {
    sections.push('### One picture', await measureFrameCost({ chromium, origin, rounds: options.rounds, log }));
  }
  const report = sections.join('\n\n');
  console.log(`\n${report}\n`);
  if (options.write) writeReport(report);
} finally {
  await server.close();
}
