/**
 * Film samples by the double-precision reference tracer: a pure function, so that whoever has threads can share the rows out
 * among them.
 */
import { prepareClassic, traceSample } from '../reference/classic.ts';
import type { FilmJob } from './film-tracer.ts';

/** Traces rows of one film sample; the rows count from the top of the picture. */
export type TraceRows = (sample: number, firstRow: number, rowCount: number) => Float32Array<ArrayBuffer>;

/** Gives the function that traces rows of the job's area: linear red, green, blue and 1 for each pixel, rounded to float32. */
export function referenceRows({ scene, settings, width, height, area }: FilmJob): TraceRows {
  const { maxReflections, lightSamples, seed } = settings;
  const tracer = prepareClassic(scene, { width, height, seed, maxReflections, lightSamples });
  return (sample, firstRow, rowCount) => {
    const pixels = new Float32Array(area.width * rowCount * 4);
    for (let row = 0; row < rowCount; row++) {
      for (let column = 0; column < area.width; column++) {
        const color = traceSample(tracer, area.x + column, firstRow + row, sample);
        pixels.set([...color, 1], (row * area.width + column) * 4);
      }
    }
    return pixels;
  };
}
