/** One run of the program: what was typed → what it does and says, and the exit code. A process may have several, one after the other. */
import { type Actions, createProgram, exitOfCommander } from './arguments.ts';
import { bench } from './commands/bench.ts';
import { compare } from './commands/compare.ts';
import { convert } from './commands/convert.ts';
import { doctor } from './commands/doctor.ts';
import { info } from './commands/info.ts';
import { merge } from './commands/merge.ts';
import { render } from './commands/render.ts';
import { schema } from './commands/schema.ts';
import { validate } from './commands/validate.ts';
import { BadFilesError, CommandError, EXIT, type ExitCode } from './exit-codes.ts';
import { openTerminal, type Streams, type Terminal } from './terminal.ts';
import { version } from './version.ts';

/** Never rejects. */
export async function run(args: readonly string[], streams: Streams = process): Promise<ExitCode> {
  let terminal = openTerminal(args.includes('--json'), process.env, streams);
  const withJson = ({ json }: { readonly json?: boolean }): Terminal =>
    (terminal = openTerminal(json === true, process.env, streams));
  const program = createProgram(version, actionsBy(withJson, streams));
  const output = {
    writeOut: (text: string) => void streams.stdout.write(text),
    writeErr: (text: string) => void streams.stderr.write(text),
  };
  for (const command of [program, ...program.commands]) command.configureOutput(output);
  try {
    await program.parseAsync(args, { from: 'user' });
    return EXIT.done;
  } catch (error) {
    return report(error, terminal);
  }
}

const actionsBy = (withJson: (options: { readonly json?: boolean }) => Terminal, { stdout }: Streams): Actions => ({
  render: (scene, options) => render(scene, options, withJson(options)),
  merge: (parts, options) => merge(parts, options, withJson(options)),
  convert: (scene, output, options) => convert(scene, output, options, withJson(options)),
  compare: (a, b, options) => compare(a, b, withJson(options)),
  validate: (scenes, options) => validate(scenes, withJson(options)),
  schema: (options) => schema(options, stdout),
  info: (files, options) => info(files, withJson(options)),
  doctor: (options) => doctor(withJson(options)),
  bench: (options) => bench(options, withJson(options)),
});

function report(error: unknown, terminal: Terminal): ExitCode {
  const ended = exitOfCommander(error);
  if (ended !== null) {
    if (ended !== EXIT.done) terminal.event('error', { code: ended, message: (error as Error).message });
    return ended;
  }
  if (error instanceof BadFilesError) {
    for (const { file, problems } of error.scenes)
      for (const problem of problems) {
        terminal.event('problem', { file, ...problem });
        if (!terminal.json) terminal.error(`${file}${problem.path && `#${problem.path}`}: ${problem.message}`);
      }
    for (const message of error.refusals) {
      terminal.event('refused', { message });
      if (!terminal.json) terminal.error(message);
    }
  }
  const known = error instanceof CommandError;
  const message = known ? error.message : `The render failed: ${(error as Error)?.stack ?? error}`;
  const code = known ? error.code : EXIT.failed;
  terminal.event('error', { code, message });
  if (!terminal.json) terminal.error(message);
  return code;
}
