#!/usr/bin/env node
/** `mirrorball`: the program. Threads of the CPU backend start here too. */
import { realpathSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { isMainThread } from 'node:worker_threads';
import { serveRows } from './backends/cpu-worker.ts';
import { keepBackends } from './backends/open-backend.ts';
import { setEntry } from './entry.ts';
import { EXIT } from './exit-codes.ts';
import { run } from './run.ts';

export { keepBackends, run };

/** For who starts the program by importing it. */
export async function main(): Promise<void> {
  // Whoever reads the output may go away early, such as `head`.
  for (const stream of [process.stdout, process.stderr])
    stream.on('error', (error: NodeJS.ErrnoException) => {
      if (error.code === 'EPIPE') process.exit(EXIT.done);
      throw error;
    });
  const code = await run(process.argv.slice(2));
  await Promise.all([process.stdout, process.stderr].map((stream) => new Promise((done) => stream.write('', done))));
  // Dawn keeps threads that would keep the program.
  process.exit(code);
}

/** Whether this file is what Node was asked to start. */
function isStarted(): boolean {
  try {
    return realpathSync(process.argv[1] ?? '') === realpathSync(fileURLToPath(import.meta.url));
  } catch {
    return false;
  }
}

setEntry(import.meta.url);
if (!isMainThread) serveRows();
else if (isStarted()) await main();
