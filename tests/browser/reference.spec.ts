import type { TestInfo } from '@playwright/test';
import { type Film, meansOf, mergeFilms } from '../reference/blocks.ts';
import { type Picture, pictureOfMeans, pictureOfZ } from '../reference/pictures.ts';
import { referenceNames, referencePicture, referenceScene } from '../reference/references.ts';
import { BATCHES, CUT, SAMPLES, SEED } from '../reference/samples.ts';
import { judge, type ZTest } from '../reference/statistics.ts';
import { pathFilms } from './films.ts';
import { backends, expect, keepPicture, test } from './fixtures.ts';

/**
 * The path integrator against pictures that another renderer made: tests/reference/README.md. On failure ours, the reference and the
 * z-map lie in test-results/.
 */
for (const backend of backends)
  for (const name of referenceNames) {
    test(`${backend}: ${name} is the reference's picture (seeds ${SEED} to ${SEED + BATCHES - 1})`, async ({
      harness,
    }, info) => {
      test.setTimeout(600_000);
      const scene = referenceScene(name);
      const reference = referencePicture(name);
      const { width, height } = reference;
      const samples = SAMPLES[name]!;
      const films = await pathFilms(harness, backend, scene, { width, height, samples, batches: BATCHES, seed: SEED });
      const result = judge(films, reference, CUT);
      info.annotations.push({ type: 'z-test', description: describeResult(result) });
      const { exposure } = scene.render;
      if (result.failures.length > 0)
        await keepPictures(info, {
          ours: pictureOfMeans(meansOf(mergeFilms(films as Film[])), width, exposure),
          reference: pictureOfMeans(reference.mean, width, exposure),
          'z-map': pictureOfZ(result, width, height),
        });
      expect(result.failures, describeResult(result)).toEqual([]);
    });
  }

async function keepPictures(info: TestInfo, pictures: Readonly<Record<string, Picture>>): Promise<void> {
  for (const [what, { width, height, rgba }] of Object.entries(pictures))
    await keepPicture(info, what, { width, height, pixels: rgba });
}

const percent = (share: number): string => `${(100 * share).toFixed(3)} %`;
function describeResult({ rms, shareBeyond3, largest, blockError, picture }: ZTest): string {
  const wholes = picture.map(({ difference, error }) => `${percent(difference)} ± ${percent(error)}`);
  return `z: rms ${rms.toFixed(2)}, ${percent(shareBeyond3)} beyond 3, largest ${largest.toFixed(1)}; error of a block ${percent(blockError)}; whole picture ${wholes.join(', ')}`;
}
