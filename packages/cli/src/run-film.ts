/** Brings a film to its samples, block by block, until it has them, is good enough, has taken its time, or is interrupted. */
import type { FilmSums, FilmTracer } from 'mirrorball/headless';
import type { AccumulatedFilm } from './accumulated-film.ts';
import { blockEnd } from './blocks.ts';
import { startClock } from './clock.ts';
import type { Progress } from './progress.ts';
import { missingFrom, type SampleRange } from './sample-ranges.ts';
import { noSavings, type Savings } from './savings.ts';

export interface FilmGoal {
  readonly wanted: SampleRange;
  readonly untilError?: number;
  /** Seconds from now. */
  readonly untilTime?: number;
}

/** Why a film got no more samples. */
export type Ending = 'all samples' | 'error reached' | 'time over' | 'interrupted';

/**
 * A trace stops for saving when so many samples are on their way: one of them is whole, so that the film does get on however long a
 * sample takes.
 */
const LEAST_BEFORE_SAVING = 2;

/** The tracer has begun the film's job already. What is traced stays in the film when this rejects. */
export async function runFilm(
  tracer: FilmTracer,
  film: AccumulatedFilm,
  goal: FilmGoal,
  interrupted: AbortSignal,
  progress: Progress,
  savings: Savings = noSavings,
): Promise<Ending> {
  const clock = startClock(goal.untilTime, interrupted);
  try {
    for (const { first, last } of missingFrom(goal.wanted, film.ranges)) {
      for (let next = first; next <= last; ) {
        // However short the time is, one sample there will be.
        const alone = goal.untilTime !== undefined && film.samples === 0;
        const end = alone ? next : Math.min(last, blockEnd(next));
        next += await addSamples(tracer, film, next, end, alone ? interrupted : clock.signal, progress, savings);
        const ending = endingNow(film, goal, interrupted, clock.signal);
        if (ending) return ending;
        if (savings.due()) await savings.save();
      }
      film.close();
    }
    return 'all samples';
  } finally {
    clock.stop();
  }
}

/**
 * Goes on with the film's open block when it ends just before `first`, else begins one. Gives how many samples were added: fewer than
 * asked for when the signal came, or when it is time to save the film.
 */
async function addSamples(
  tracer: FilmTracer,
  film: AccumulatedFilm,
  first: number,
  last: number,
  signal: AbortSignal,
  progress: Progress,
  savings: Savings,
): Promise<number> {
  let { open } = film;
  if (open && open.first + open.sums[3]! !== first) {
    film.close();
    open = null;
  }
  const held = film.samples;
  const error = film.error();
  const pause = new AbortController();
  const stop = () => pause.abort();
  const onProgress = (samples: number) => {
    progress.update(held + samples, error);
    if (samples >= LEAST_BEFORE_SAVING && savings.due()) stop();
  };
  if (signal.aborted) stop();
  signal.addEventListener('abort', stop);
  try {
    const options = { signal: pause.signal, onProgress };
    const sums: FilmSums = await tracer.trace(first, last - first + 1, open?.sums ?? null, options);
    film.put(open?.first ?? first, sums);
  } finally {
    signal.removeEventListener('abort', stop);
  }
  progress.update(film.samples, film.error());
  return film.samples - held;
}

function endingNow(film: AccumulatedFilm, goal: FilmGoal, interrupted: AbortSignal, clock: AbortSignal): Ending | null {
  if (interrupted.aborted) return 'interrupted';
  const error = film.error();
  if (goal.untilError !== undefined && error !== null && error <= goal.untilError) return 'error reached';
  return clock.aborted ? 'time over' : null;
}
