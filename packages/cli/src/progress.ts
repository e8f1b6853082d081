/** How far a picture is: a bar on a terminal, now and then a line in a file, an object a line for programs. */
import { basename } from 'node:path';
import { SingleBar } from 'cli-progress';
import { duration, percent, type Terminal } from './terminal.ts';

/** Seconds between two lines when nothing can be drawn over itself, and between two objects. */
const LINE_EVERY = 5;
const OBJECT_EVERY = 0.5;
/** Seconds before there is a bar for what comes before the samples. */
const MOMENT = 0.3;

export interface Progress {
  update(samples: number, error: number | null): void;
  /** Takes the bar away. */
  stop(): void;
}

/** What ends the picture. */
export interface Goal {
  readonly picture: string;
  /** Held at the start, and wanted at most. */
  readonly held: number;
  readonly wanted: number;
  readonly untilError?: number;
  readonly untilTime?: number;
}

/** Seconds still needed, from what has been done. The error falls with the root of the samples. */
export function secondsLeft(goal: Goal, samples: number, error: number | null, elapsed: number): number {
  const done = samples - goal.held;
  if (done <= 0) return goal.untilTime ?? Number.POSITIVE_INFINITY;
  const forError =
    goal.untilError === undefined || error === null
      ? goal.wanted
      : samples * Math.max((error / goal.untilError) ** 2, 1);
  const bySamples = (elapsed / done) * (Math.min(goal.wanted, forError) - samples);
  return Math.max(Math.min(bySamples, (goal.untilTime ?? Number.POSITIVE_INFINITY) - elapsed), 0);
}

export function startProgress(terminal: Terminal, goal: Goal, now = () => performance.now() / 1000): Progress {
  const started = now();
  let told = started;
  const bar = terminal.live ? openBar(goal) : null;
  const every = terminal.json ? OBJECT_EVERY : LINE_EVERY;
  return {
    update(samples, error) {
      const elapsed = now() - started;
      const left = secondsLeft(goal, samples, error, elapsed);
      bar?.update(samples, { error: percent(error), left: duration(left) });
      if (bar || now() - told < every) return;
      told = now();
      const { picture, wanted } = goal;
      terminal.event('progress', {
        picture,
        samples,
        wanted,
        error,
        elapsed,
        left: Number.isFinite(left) ? left : null,
      });
      terminal.note(
        `${picture}: ${Math.floor(samples)} of ${wanted} samples, error ${percent(error)}, ${duration(left)} left`,
      );
    },
    stop: () => bar?.stop(),
  };
}

/** Work before the first sample, or before a file is written, of which the share that is done is known. */
export interface Preparation {
  update(share: number): void;
  /** Takes the bar away. */
  stop(): void;
}

/** Nothing is told where it takes no longer than a moment. `doing`: for people. */
export function startPreparation(
  terminal: Terminal,
  picture: string,
  step: 'trees' | 'images',
  doing: string,
  now = () => performance.now() / 1000,
): Preparation {
  const started = now();
  let told = started;
  let bar: SingleBar | null = null;
  const every = terminal.json ? OBJECT_EVERY : LINE_EVERY;
  return {
    update(share) {
      if (terminal.live && now() - started >= MOMENT)
        bar ??= startBar(`${basename(picture)} [{bar}] {percentage} %  ${doing}`, 100, 0);
      bar?.update(Math.floor(100 * share));
      if (bar || now() - told < every) return;
      told = now();
      terminal.event('preparing', { picture, step, done: share });
      terminal.note(`${picture}: ${doing}, ${Math.floor(100 * share)} %`);
    },
    stop: () => bar?.stop(),
  };
}

export const startTrees = (terminal: Terminal, picture: string, now?: () => number): Preparation =>
  startPreparation(terminal, picture, 'trees', 'building trees', now);

function openBar({ picture, held, wanted }: Goal): SingleBar {
  const format = `${basename(picture)} [{bar}] {value}/{total} samples  error {error}  {left} left`;
  return startBar(format, wanted, held, { error: '–', left: '–' });
}

function startBar(format: string, total: number, value: number, fields: object = {}): SingleBar {
  const bar = new SingleBar({
    barsize: 24,
    format,
    formatValue: (value, _, type) => String(type === 'value' ? Math.floor(value) : value),
    stream: process.stderr,
    hideCursor: true,
    clearOnComplete: true,
    barCompleteChar: '█',
    barIncompleteChar: '·',
    fps: 10,
    // The bar would take Ctrl+C for itself.
    gracefulExit: false,
  });
  bar.start(total, value, fields);
  return bar;
}
