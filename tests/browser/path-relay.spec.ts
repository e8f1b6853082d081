import { expect, test } from './fixtures.ts';

const SEED = 7;
const SCENES = 12;
const SAMPLES = 3;

test(`webgl2: a path in several passes is the same to the bit, in ${SCENES} random scenes (seed ${SEED})`, async ({
  harness,
}) => {
  const films = await harness.evaluate(([s, n, k]) => window.harness.relayedFilms(s, 0, n, k), [
    SEED,
    SCENES,
    SAMPLES,
  ] as const);
  console.log(films);
  for (const film of films) expect.soft(film.different, `scene ${film.index}`).toBe(0);
});
