import { expect, test } from './fixtures.ts';

const SEED = 7;
const SCENES = 24;
const PASSES = ['begin', 'trace', 'light', 'scatter', 'end'];

test(`webgl2: paths in several passes make the same films to the bit, in ${SCENES} random scenes (seed ${SEED})`, async ({
  harness,
}) => {
  const { films, passes } = await harness.evaluate(([s, n]) => window.harness.relayedFilms(s, n), [
    SEED,
    SCENES,
  ] as const);
  expect(passes).toEqual(PASSES.map((part) => `path, ${part}`));
  for (const { index, different } of films) expect.soft(different, `sums of scene ${index}`).toBe(0);
  // Sums count samples too.
  const lit = films.filter(({ brightest }) => brightest > 3);
  expect(lit.length, 'scenes with light').toBeGreaterThan(SCENES / 4);
});
