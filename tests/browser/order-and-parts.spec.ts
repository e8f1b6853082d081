import { expect, test } from './fixtures.ts';
import type { Entry } from './harness/tracers.ts';

/** Renders can be dealt out: by samples, by parts of the picture, in any order. */
const SAMPLES = 256;
const SEED = 40;

const ENTRIES: readonly Entry[] = ['webgpu, drawn', 'webgpu, computed', 'webgl2'];
for (const entry of ENTRIES)
  test(`${entry}: ${SAMPLES} samples at once, four merged runs of ${SAMPLES / 4}, and the union of parts are one film (seed ${SEED})`, async ({
    harness,
  }) => {
    const film = await harness.evaluate(([e, n, s, seed]) => window.harness.orderAndParts(e, n, s, seed), [
      entry,
      'materials',
      SAMPLES,
      SEED,
    ] as const);
    expect(film.samples).toBe(SAMPLES);
    expect(film.brightest, 'the brightest sum').toBeGreaterThan(SAMPLES / 100);
    for (const difference of film.runs) expect(difference, 'four runs, relative').toBeLessThanOrEqual(1e-6);
    // On top of one another the same additions come in the same order, however many of them a call has.
    expect(film.goneOn, 'gone on with, interrupted, relative').toEqual([0, 0]);
    // Sums of the device alone, in 32 bits: each addition may round by 2^-24 of what is there by then.
    expect(film.sums, 'sums of four runs, relative').toBeLessThan(SAMPLES * 2 ** -24);
    // Not only about: a pixel does not know which part it is traced in.
    expect(film.parts, 'parts, relative').toBe(0);
  });
