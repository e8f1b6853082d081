/**
 * All that is said. With --json one object a line goes to standard output, and nothing else; without, results go to standard output
 * and what happens meanwhile to standard error. Colour only on a terminal, and not under NO_COLOR (https://no-color.org).
 */
export interface Terminal {
  readonly json: boolean;
  /** Whether progress may be drawn over itself. */
  readonly live: boolean;
  /** For programs; says nothing without --json. */
  event(event: string, fields: Readonly<Record<string, unknown>>): void;
  /** A line of the result, for people. */
  result(text: string): void;
  /** A line about the work, for people. */
  note(text: string): void;
  error(text: string): void;
}

/** What a terminal needs of Node's streams. */
export interface Stream {
  readonly isTTY?: boolean;
  write(text: string): boolean;
}

export interface Streams {
  readonly stdout: Stream;
  readonly stderr: Stream;
}

export function openTerminal(
  json: boolean,
  env: Readonly<Record<string, string | undefined>> = process.env,
  { stdout, stderr }: Streams = process,
): Terminal {
  const live = !json && stderr.isTTY === true && env.TERM !== 'dumb';
  const coloured = live && !env.NO_COLOR;
  return {
    json,
    live,
    event: (event, fields) => {
      if (json) stdout.write(`${JSON.stringify({ event, ...fields })}\n`);
    },
    result: (text) => {
      if (!json) stdout.write(`${text}\n`);
    },
    note: (text) => {
      if (!json) stderr.write(`${text}\n`);
    },
    error: (text) => void stderr.write(coloured ? `\u001b[31m${text}\u001b[39m\n` : `${text}\n`),
  };
}

/** Seconds as people say them: 4.2 s, 3 min 20 s, 2 h 5 min. */
export function duration(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  const s = Math.round(seconds);
  if (s < 60) return `${s} s`;
  if (s < 3600) return `${Math.floor(s / 60)} min ${s % 60} s`;
  return `${Math.floor(s / 3600)} h ${Math.floor((s % 3600) / 60)} min`;
}

/** An error of a picture, as 1.2 %. */
export const percent = (error: number | null): string => (error === null ? '–' : `${(error * 100).toPrecision(2)} %`);
