/** Ctrl+C and `kill`: the first asks the work to stop and save, the second ends at once. */
import { CommandError, EXIT, type ExitCode } from './exit-codes.ts';

export interface Interruption {
  readonly signal: AbortSignal;
  /** Throws when there was one. */
  check(saved: string): void;
}

const CODES: Readonly<Record<string, ExitCode>> = { SIGINT: EXIT.sigint, SIGTERM: EXIT.sigterm };

export function listenForInterruption(): Interruption {
  const controller = new AbortController();
  for (const [name, code] of Object.entries(CODES))
    process.on(name, () => {
      if (controller.signal.aborted) process.exit(code);
      controller.abort(name);
    });
  const { signal } = controller;
  return {
    signal,
    check(saved) {
      if (signal.aborted)
        throw new CommandError(CODES[String(signal.reason)]!, `Stopped by ${signal.reason}. ${saved}`);
    },
  };
}
