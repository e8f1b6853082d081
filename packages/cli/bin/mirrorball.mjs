#!/usr/bin/env node
// Starts the built program; in a fresh checkout, says how to build it.
import { existsSync } from 'node:fs';

const program = new URL('../dist/mirrorball.mjs', import.meta.url);
if (!existsSync(program)) {
  console.error('Mirrorball’s command line is not built yet. Please run: npm run build');
  process.exit(1);
}
const { main } = await import(program.href);
await main();
