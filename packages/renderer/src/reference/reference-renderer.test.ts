import { expect, test } from 'vitest';
import { baselineRoom } from '../../../../tests/fixtures/baseline-room.ts';
import { traceClassic } from './classic.ts';
import { renderProgressively, type StillJob } from './progressive.ts';
import { renderStill } from './reference-renderer.ts';

const settings = { maxReflections: 1, lightSamples: 4, seed: 5, comparison: null, samples: 3 };
const { camera } = baselineRoom;
const [width, height] = [21, 13];
const job: StillJob = { scene: baselineRoom, camera, width, height, ...settings };

function expectFinished(film: Float32Array): void {
  const { samples: sampleCount, ...rest } = settings;
  const expected = traceClassic(baselineRoom, { width, height, ...rest, sampleCount });
  film.forEach((x, k) => {
    expect(x).toBeCloseTo(expected[k]!, 5);
  });
}

test('coarse to fine ends at the film of the classic tracer, and every pixel is traced once a sample', () => {
  const passes: number[][] = [];
  let film = new Float32Array();
  for (const progress of renderProgressively(job)) {
    film = progress.film;
    if (progress.passDone) passes.push(Array.from(film.filter((_, k) => k % 4 === 3)));
  }
  const traced = passes.map((counts) => counts.reduce((a, b) => a + b));
  expect(traced).toEqual([3 * 2, 6 * 4, 11 * 7, 21 * 13, 2 * 21 * 13, 3 * 21 * 13]);
  expectFinished(film);
});

test('a film can be gone on from, and ends as if it had been made at once', async () => {
  const one = await renderStill(baselineRoom, camera, { ...settings, samples: 1 }, width, height);
  const before = one.slice();
  const start = { film: one, samples: 1 };
  expectFinished(await renderStill(baselineRoom, camera, { ...settings, start }, width, height));
  expect(one, 'what was handed in is left as it was').toEqual(before);
});

test('the first pass already covers the picture', () => {
  for (const { film, passDone } of renderProgressively(job)) {
    if (!passDone) continue;
    for (let k = 0; k < film.length; k += 4) expect(film[k]).toBeGreaterThan(0);
    break;
  }
});

test('without workers it renders in slices on this thread', async () => {
  const shares: number[] = [];
  const film = await renderStill(baselineRoom, camera, settings, width, height, (soFar, done) => {
    expect(soFar.length).toBe(width * height * 4);
    shares.push(done);
  });
  expectFinished(film);
  expect(shares.length).toBeGreaterThanOrEqual(5);
  expect([...shares].sort((a, b) => a - b)).toEqual(shares);
});

test('can be cancelled', async () => {
  const controller = new AbortController();
  const still = renderStill(
    baselineRoom,
    camera,
    { ...settings, samples: 1000 },
    width,
    height,
    () => controller.abort(),
    controller.signal,
  );
  await expect(still).rejects.toThrow(/abort/i);
});
