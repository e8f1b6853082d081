import { backends, expect, test } from './fixtures.ts';
import { keepScene } from './kept-scenes.ts';

/**
 * Random scenes as bad as files may have them; nothing but light may come of them. `npm run fuzz -- --scenes 10000 --seed 1` traces
 * more of them.
 */
const SEED = 1;
const SCENES = 200;

for (const backend of backends)
  test(`${backend}: no light that is negative, infinite or no number in ${SCENES} random scenes (seed ${SEED})`, async ({
    harness,
  }, testInfo) => {
    const { traced, bad } = await harness.evaluate(([b, s, n]) => window.harness.fuzz(b, 'shapes', s, 0, n), [
      backend,
      SEED,
      SCENES,
    ] as const);
    const found: string[] = [];
    for (const one of bad) {
      const path = await keepScene(`fuzz-${one.index}`, one.scene, (name) => testInfo.outputPath(name));
      await testInfo.attach(`scene ${one.index}`, { path, contentType: 'application/json' });
      found.push(`scene ${one.index}, pixel ${one.pixel}, sample ${one.sample}: ${one.value.join(' ')}`);
    }
    expect(found, 'scenes with samples that are no light').toEqual([]);
    expect(traced).toBe(SCENES);
  });
