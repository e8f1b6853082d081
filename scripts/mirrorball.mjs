#!/usr/bin/env node
// npm run mirrorball -- render …: the command line from its sources: built when they changed, then run. All of it runs this way,
// also threads and the page for Chromium, which a loader for TypeScript would not reach.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildCliIfStale } from './build-cli.mjs';
import { root } from './run-command.mjs';

const code = await buildCliIfStale();
if (code !== 0) process.exit(code);
// The program takes its arguments from the process, where they begin at the same place.
const { main } = await import(pathToFileURL(join(root, 'packages/cli/dist/mirrorball.mjs')).href);
await main();
