/** Traces what a finished picture's AOVs need: of the same samples as the picture, by the same random numbers. */
import { AOVS, type AovName, directSettings, type FilmJob, type FilmSums, type FilmTracer } from 'mirrorball/headless';
import { AccumulatedFilm } from './accumulated-film.ts';
import type { Progress } from './progress.ts';
import { runFilm } from './run-film.ts';
import type { SampleRange } from './sample-ranges.ts';

/** What the camera sees first has no noise but that of the pixel filter and the lens: so many samples are enough, and float32 sums good. */
export const MOST_FIRST_HITS = 1024;

export interface AovFilms {
  readonly features: FilmSums | null;
  readonly data: FilmSums | null;
  /** The direct part of the light. */
  readonly direct: AccumulatedFilm | null;
}

/** The first so many samples of these ranges. */
export function firstOf(ranges: readonly SampleRange[], most: number): SampleRange[] {
  const kept: SampleRange[] = [];
  let left = most;
  for (const { first, last } of ranges) {
    if (left <= 0) break;
    kept.push({ first, last: Math.min(last, first + left - 1) });
    left -= last - first + 1;
  }
  return kept;
}

const wants = (names: readonly AovName[], source: string): boolean =>
  names.some((name) => AOVS[name].source === source);

/** Samples that all films of these AOVs take together: what their progress is counted in. */
export function aovSamples(names: readonly AovName[], { samples }: AccumulatedFilm): number {
  const firstHits = (['features', 'data'] as const).filter((source) => wants(names, source)).length;
  return firstHits * Math.min(samples, MOST_FIRST_HITS) + (wants(names, 'direct') ? samples : 0);
}

/** Null when it was interrupted. `job` is that of the picture, `film` what came of it. */
export async function traceAovs(
  names: readonly AovName[],
  tracer: FilmTracer,
  job: FilmJob,
  film: AccumulatedFilm,
  interrupted: AbortSignal,
  progress: Progress,
): Promise<AovFilms | null> {
  // Of the films before.
  let done = 0;
  const onward: Progress = { ...progress, update: (samples) => progress.update(done + samples, null) };
  const firstHits = async (content: 'features' | 'data'): Promise<FilmSums | null> => {
    if (!wants(names, content) || interrupted.aborted) return null;
    await tracer.begin({ ...job, content });
    let sums: FilmSums | null = null;
    for (const { first, last } of firstOf(film.ranges, MOST_FIRST_HITS)) {
      const count = last - first + 1;
      sums = await tracer.trace(first, count, sums, {
        signal: interrupted,
        onProgress: (samples) => onward.update(samples, null),
      });
      done += count;
    }
    return sums;
  };
  const features = await firstHits('features');
  const data = await firstHits('data');
  let direct: AccumulatedFilm | null = null;
  if (wants(names, 'direct') && !interrupted.aborted) {
    direct = new AccumulatedFilm(film.pixels);
    await tracer.begin({ ...job, settings: directSettings(job.settings) });
    for (const wanted of film.ranges) await runFilm(tracer, direct, { wanted }, interrupted, onward);
  }
  return interrupted.aborted ? null : { features, data, direct };
}
