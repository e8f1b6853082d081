/** Ctrl+C and `kill`: the first asks the work to stop and save, the second ends at once. */
import { CommandError, EXIT, type ExitCode } from './exit-codes.ts';

export interface Interruption {
  readonly signal: AbortSignal;
  /** Throws when there was one. */
  check(saved: string): void;
  /** Does not listen any more. */
  stop(): void;
}

const CODES: Readonly<Record<string, ExitCode>> = { SIGINT: EXIT.sigint, SIGTERM: EXIT.sigterm };

export function listenForInterruption(): Interruption {
  const controller = new AbortController();
  const hear = (name: NodeJS.Signals): void => {
    if (controller.signal.aborted) process.exit(CODES[name]);
    controller.abort(name);
  };
  for (const name of Object.keys(CODES)) process.on(name, hear);
  const { signal } = controller;
  return {
    signal,
    stop() {
      for (const name of Object.keys(CODES)) process.off(name, hear);
    },
    check(saved) {
      if (signal.aborted)
        throw new CommandError(CODES[String(signal.reason)]!, `Stopped by ${signal.reason}. ${saved}`);
    },
  };
}
