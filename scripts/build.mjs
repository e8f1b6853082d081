#!/usr/bin/env node
// npm run build: the studio as one file, apps/studio/dist/index.html.
import { buildStudio } from './build-studio.mjs';
import { installPackages } from './install-packages.mjs';
import { requireNode } from './node-version.mjs';

requireNode();
await installPackages();
process.exitCode = await buildStudio();
