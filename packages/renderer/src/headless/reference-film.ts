/**
 * Film samples by the double-precision reference tracer: a pure function, so that whoever has threads can share the rows out
 * among them.
 */
import { prepareClassic, traceSample } from '../reference/classic.ts';
import { prepareFirstHit, traceFirstHit } from '../reference/first-hit.ts';
import type { FilmJob, FilmSums } from './film-tracer.ts';

/** Traces rows of one film sample; the rows count from the top of the picture. */
export type TraceRows = (sample: number, firstRow: number, rowCount: number) => FilmSums;

/** What one sample of a pixel adds: four numbers for each layer of the film. */
type TraceSample = (i: number, j: number, sample: number) => readonly (readonly number[])[];

/** Gives the function that traces rows of the job's area, layer after layer, rounded to float32. */
export function referenceRows(job: FilmJob): TraceRows {
  const { area } = job;
  const trace = job.content && job.content !== 'light' ? aovSample(job) : lightSample(job);
  const layers = referenceLayers(job);
  return (sample, firstRow, rowCount) => {
    const texels = area.width * rowCount * 4;
    const pixels = new Float32Array(texels * layers);
    for (let row = 0; row < rowCount; row++)
      for (let column = 0; column < area.width; column++)
        trace(area.x + column, firstRow + row, sample).forEach((texel, layer) => {
          pixels.set(texel, layer * texels + (row * area.width + column) * 4);
        });
    return pixels;
  };
}

/** Layers of the film that `referenceRows` gives rows of. */
export const referenceLayers = ({ content = 'light' }: FilmJob): number => (content === 'light' ? 1 : 2);

/** Linear red, green, blue and 1. */
function lightSample({ scene, settings, width, height }: FilmJob): TraceSample {
  const { maxReflections, lightSamples, seed } = settings;
  const tracer = prepareClassic(scene, { width, height, seed, maxReflections, lightSamples });
  return (i, j, sample) => [[...traceSample(tracer, i, j, sample), 1]];
}

/** As the kernel in integrator/aov/ has it. */
function aovSample({ scene, settings, width, height, content }: FilmJob): TraceSample {
  const { integrator, seed } = settings;
  const tracer = prepareFirstHit(scene, { width, height, integrator, seed });
  const nothing = [0, 0, 0];
  return (i, j, sample) => {
    const { hit, closeness } = traceFirstHit(tracer, i, j, sample);
    if (content === 'data')
      return [
        [...(hit?.place ?? nothing), hit?.id ?? 0],
        [...(hit?.geometricNormal ?? nothing), closeness],
      ];
    return [
      [...(hit?.albedo ?? nothing), 1],
      [...(hit?.normal ?? nothing), hit ? 1 : 0],
    ];
  };
}

/** Adds a sample of all pixels to a film, as the GPU does: `data` keep the sample nearest to the middle of each pixel. */
export function addReferenceSample(film: FilmSums, sample: FilmSums, { content }: FilmJob): void {
  if (content !== 'data') {
    for (let i = 0; i < film.length; i++) film[i]! += sample[i]!;
    return;
  }
  const texels = film.length / 2;
  for (let i = 0; i < texels; i += 4) {
    if (film[texels + i + 3]! >= sample[texels + i + 3]!) continue;
    for (const at of [i, texels + i]) film.set(sample.subarray(at, at + 4), at);
  }
}
