#!/usr/bin/env node
// npm start: installs what is missing, builds the studio, serves it on this machine and shows it.
import { parseArgs } from 'node:util';
import { buildStudio, studioFolder } from './build-studio.mjs';
import { installPackages } from './install-packages.mjs';
import { requireNode } from './node-version.mjs';
import { hasDesktop, openBrowser } from './open-browser.mjs';
import { serveFolders } from './static-server.mjs';

const USAGE = `npm start -- [options], such as: npm start -- --port 8080 --no-open
  --port N    the first port to try, 5173 unless given; the next free one is taken
  --no-open   do not open a browser`;

/** @returns {{ port: number, open: boolean }} */
function readOptions() {
  try {
    const { values } = parseArgs({
      options: {
        port: { type: 'string', default: '5173' },
        'no-open': { type: 'boolean', default: false },
        help: { type: 'boolean', short: 'h', default: false },
      },
    });
    if (values.help) {
      console.log(USAGE);
      process.exit(0);
    }
    const port = Number(values.port);
    if (!Number.isInteger(port) || port < 0 || port > 65535) throw new Error(`--port ${values.port} is not a port`);
    return { port, open: !values['no-open'] };
  } catch (error) {
    console.error(`${/** @type {Error} */ (error).message}\n\n${USAGE}`);
    process.exit(2);
  }
}

requireNode();
const options = readOptions();
await installPackages();
const code = await buildStudio();
if (code !== 0) process.exit(code);

const server = await serveFolders({ mounts: { '/': studioFolder }, port: options.port });
console.log(`\n  Mirrorball is at  ${server.origin}/\n  Ctrl+C ends it.\n`);
if (options.open && hasDesktop()) openBrowser(`${server.origin}/`);
for (const signal of /** @type {const} */ (['SIGINT', 'SIGTERM'])) {
  process.on(signal, () => void server.close().then(() => process.exit(0)));
}
