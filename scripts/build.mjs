#!/usr/bin/env node
// npm run build: the studio as one file, apps/studio/dist/index.html, the library, packages/renderer/dist/mirrorball.js, and the
// command line, packages/cli/dist/mirrorball.mjs.
import { buildAll } from './build-all.mjs';
import { installPackages } from './install-packages.mjs';
import { requireNode } from './node-version.mjs';

requireNode();
await installPackages();
process.exitCode = await buildAll();
