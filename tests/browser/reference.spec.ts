import type { Page, TestInfo } from '@playwright/test';
import { pathFeatures } from '../../packages/renderer/src/integrator/path/path-features.ts';
import { DEFAULT_SETTINGS } from '../../packages/renderer/src/view.ts';
import { type Film, meansOf, mergeFilms } from '../reference/blocks.ts';
import { type Picture, pictureOfMeans, pictureOfZ } from '../reference/pictures.ts';
import { referenceNames, referencePicture, referenceScene } from '../reference/references.ts';
import { BATCHES, CUT, SAMPLES, SEED } from '../reference/samples.ts';
import { judge, type ZTest } from '../reference/statistics.ts';
import { batchOrders, filmsOf, pathFilms } from './films.ts';
import { expect, keepPicture, test } from './fixtures.ts';

/**
 * The path integrator against pictures that another renderer made: tests/reference/README.md. On failure ours, the reference and the
 * z-map lie in test-results/. WebGPU's films need no judgement of their own where they are WebGL2's, as in software they are.
 */
const seeds = `seeds ${SEED} to ${SEED + BATCHES - 1}`;
/** Half a minute each, and of S1's kind: `npm run proof` has them. */
const LONG = ['S1_d4', 'S1b'];

/** Scenes that are drawn by the same programs. */
const groups = new Map<string, string[]>();
for (const name of referenceNames) {
  const scene = referenceScene(name);
  const features = pathFeatures({ scene, camera: scene.camera, settings: DEFAULT_SETTINGS });
  const key = [...features].join(' ');
  groups.set(key, [...(groups.get(key) ?? []), name]);
}

// The longest file: both workers take of it, as no film depends on another, but scenes of one program stay together.
test.describe.configure({ mode: 'parallel' });

for (const [features, names] of groups)
  test.describe(features, () => {
    test.describe.configure({ mode: 'default' });
    for (const name of names) {
      const judged = LONG.includes(name) ? '' : `webgl2 gives the reference's picture (${seeds}), and `;
      test(`${name}: ${judged}webgpu the same film, or the reference's picture`, ({ harness }, info) =>
        both(harness, name, info));
    }
  });

async function both(harness: Page, name: string, info: TestInfo): Promise<void> {
  test.setTimeout(600_000);
  const scene = referenceScene(name);
  const { width, height } = referencePicture(name);
  const batches = { width, height, samples: SAMPLES[name]!, batches: BATCHES, seed: SEED };
  const range = { width, height, samples: 2, firstSample: 0, seed: SEED };
  const [one, other, ...films] = await filmsOf(harness, scene, [
    { backend: 'webgpu', range },
    { backend: 'webgl2', range },
    ...(LONG.includes(name) ? [] : batchOrders('webgl2', batches)),
  ]);
  if (films.length > 0) await compare(films, name, info);
  if (!sameFilm(one!, other!)) await compare(await pathFilms(harness, 'webgpu', scene, batches), name, info);
}

/** Up to rounding, and a few paths that rounding sends elsewhere. */
function sameFilm(one: Film, other: Film): boolean {
  let different = 0;
  for (let i = 0; i < one.sum.length; i++) {
    const [a, b] = [one.sum[i]!, other.sum[i]!];
    if (!(Math.abs(a - b) <= 1e-3 * (1e-3 + Math.abs(b)))) different++;
  }
  return different < 1e-3 * one.sum.length;
}

async function compare(films: readonly Film[], name: string, info: TestInfo): Promise<void> {
  const reference = referencePicture(name);
  const { width, height } = reference;
  const result = judge(films, reference, CUT);
  info.annotations.push({ type: 'z-test', description: describeResult(result) });
  const { exposure } = referenceScene(name).render;
  if (result.failures.length > 0)
    await keepPictures(info, {
      ours: pictureOfMeans(meansOf(mergeFilms(films)), width, exposure),
      reference: pictureOfMeans(reference.mean, width, exposure),
      'z-map': pictureOfZ(result, width, height),
    });
  expect(result.failures, describeResult(result)).toEqual([]);
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
