#!/usr/bin/env node
/** `mirrorball`: the program. Threads of the CPU backend start here too. */
import { isMainThread } from 'node:worker_threads';
import { type Actions, createProgram, exitOfCommander } from './arguments.ts';
import { serveRows } from './backends/cpu-worker.ts';
import { bench } from './commands/bench.ts';
import { compare } from './commands/compare.ts';
import { convert } from './commands/convert.ts';
import { doctor } from './commands/doctor.ts';
import { info } from './commands/info.ts';
import { merge } from './commands/merge.ts';
import { render } from './commands/render.ts';
import { schema } from './commands/schema.ts';
import { validate } from './commands/validate.ts';
import { setEntry } from './entry.ts';
import { BadSceneError, CommandError, EXIT, type ExitCode } from './exit-codes.ts';
import { openTerminal, type Terminal } from './terminal.ts';
import { version } from './version.ts';

let terminal = openTerminal(process.argv.includes('--json'));
const withJson = ({ json }: { readonly json?: boolean }): Terminal => (terminal = openTerminal(json === true));

const actions: Actions = {
  render: (scene, options) => render(scene, options, withJson(options)),
  merge: (parts, options) => merge(parts, options, withJson(options)),
  convert: (scene, output, options) => convert(scene, output, options, withJson(options)),
  compare: (a, b, options) => compare(a, b, withJson(options)),
  validate: (scenes, options) => validate(scenes, withJson(options)),
  schema,
  info: (files, options) => info(files, withJson(options)),
  doctor: (options) => doctor(withJson(options)),
  bench: (options) => bench(options, withJson(options)),
};

function report(error: unknown): ExitCode {
  const ended = exitOfCommander(error);
  if (ended !== null) {
    if (ended !== EXIT.done) terminal.event('error', { code: ended, message: (error as Error).message });
    return ended;
  }
  if (error instanceof BadSceneError) {
    for (const { file, problems } of error.scenes)
      for (const problem of problems) {
        terminal.event('problem', { file, ...problem });
        if (!terminal.json) terminal.error(`${file}${problem.path && `#${problem.path}`}: ${problem.message}`);
      }
  }
  const known = error instanceof CommandError;
  const message = known ? error.message : `The render failed: ${(error as Error)?.stack ?? error}`;
  const code = known ? error.code : EXIT.failed;
  terminal.event('error', { code, message });
  if (!terminal.json) terminal.error(message);
  return code;
}

async function main(): Promise<void> {
  // Whoever reads the output may go away early, such as `head`.
  for (const stream of [process.stdout, process.stderr])
    stream.on('error', (error: NodeJS.ErrnoException) => {
      if (error.code === 'EPIPE') process.exit(EXIT.done);
      throw error;
    });
  let code: ExitCode = EXIT.done;
  try {
    await createProgram(version, actions).parseAsync();
  } catch (error) {
    code = report(error);
  }
  await Promise.all([process.stdout, process.stderr].map((stream) => new Promise((done) => stream.write('', done))));
  // Dawn keeps threads that would keep the program.
  process.exit(code);
}

setEntry(import.meta.url);
if (isMainThread) await main();
else serveRows();
